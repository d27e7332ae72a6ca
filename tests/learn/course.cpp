// The course of a training: its samples, its rates, its way back from NaN, and its checkpoint.
#include "learn/course.hpp"
#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "learn/checkpoint.hpp"
#include "learn/results.hpp"
#include "learn/settings.hpp"
#include "support/process.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace pelage;
using namespace pelage::learn;

namespace {

// Adds 1 to every number of the states and of the weights, or gives a NaN at the steps that it is told.
class Pretended final : public Learner {
public:
    explicit Pretended(std::set<int> bad = {}) : bad_(std::move(bad)) {}

    LearningLoss<float> step(std::vector<float>& states, const LearningOrder& order) override {
        orders.push_back(order);
        for (float& one : states) one += 1;
        if (order.rate != 0) {
            for (float& one : learned_.weights) one += 1;
        }
        const bool bad = bad_.contains(calls_++);
        return {bad ? std::numeric_limits<float>::quiet_NaN() : 0.5f, {}, {}};
    }
    Learned<float> read() const override { return learned_; }
    void write(const Learned<float>& learned) override { learned_ = learned; }
    std::vector<float> slopes() const override { return {}; }
    std::string name() const override { return "pretended"; }

    std::vector<LearningOrder> orders;

private:
    std::set<int> bad_;
    int calls_ = 0;
    Learned<float> learned_;
};

Settings small_settings() {
    Settings settings;
    settings.shape = {32, 2, 4, 8, 1};
    settings.pool = 6;
    settings.seed_every = 3;
    settings.drops = {4};
    return settings;
}

float sum(const std::vector<float>& numbers) {
    float total = 0;
    for (const float one : numbers) total += one;
    return total;
}

std::string refused(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("steps have rates, counts, sets of directions and numbers of iterations as planned") {
    auto owned = std::make_unique<Pretended>();
    Pretended& learner = *owned;
    Course course(small_settings(), std::move(owned));
    std::set<std::size_t> lengths;
    for (int n = 0; n < 40; ++n) course.advance();
    REQUIRE(learner.orders.size() == 41);  // the first is for the seed states' loss
    CHECK(learner.orders[0].rate == 0.0);
    CHECK(learner.orders[4].rate == 1e-3);
    CHECK(learner.orders[5].rate == Approx(2e-4));
    for (std::size_t n = 1; n < learner.orders.size(); ++n) {
        CHECK(learner.orders[n].count == n);
        CHECK(learner.orders[n].set == n % direction_sets);
        CHECK(learner.orders[n].iterations >= 32);
        CHECK(learner.orders[n].iterations <= 96);
        lengths.insert(learner.orders[n].iterations);
    }
    CHECK(lengths.size() > 15);
    CHECK(course.pool().size() == 6);  // every place has been drawn
}

TEST_CASE("a seed state is spots, alike in three chemicals and absent from the others") {
    const LearningShape shape = small_settings().shape;
    const std::vector<float> state = seed_state(shape, 1, 0);
    REQUIRE(state.size() == shape.sample());
    CHECK(std::vector<float>(state.begin(), state.begin() + 1024) ==
          std::vector<float>(state.begin() + 2048, state.begin() + 3072));
    CHECK(sum({state.begin() + 3072, state.end()}) == 0.0f);
    // 5 spots of 2 pi sigma^2 times their height
    CHECK(sum({state.begin(), state.begin() + 1024}) == Approx(5 * 0.145 * 2 * 3.14159 * 9).epsilon(0.01));
    CHECK(state != seed_state(shape, 1, 1));
    CHECK(state != seed_state(shape, 2, 0));
}

TEST_CASE("a pool draws different places, and throws away what has run away") {
    Pool pool(small_settings());
    for (std::uint64_t step = 1; step < 50; ++step) {
        const auto places = pool.drawn_places(step);
        REQUIRE(places.size() == 2);
        CHECK(places[0] != places[1]);
        CHECK(places[0] < 6);
    }
    std::vector<float> state(4 * 1024, 0.25f);
    pool.put(3, state.data());
    CHECK(pool.at(3) == state);
    state[7] = std::numeric_limits<float>::infinity();
    pool.put(3, state.data());
    CHECK(pool.at(3) == seed_state(small_settings().shape, 1, 3));
}

TEST_CASE("where numbers run away the last sound weights come back and the rate is halved") {
    auto owned = std::make_unique<Pretended>(std::set<int>{34, 35});
    Pretended& learner = *owned;
    Course course(small_settings(), std::move(owned));
    for (int n = 0; n < 32; ++n) course.advance();
    const std::vector<float> sound = course.learned().weights;
    CHECK_FALSE(std::isnan(course.advance().loss));
    CHECK(std::isnan(course.advance().loss));
    CHECK(course.learned().weights == sound);
    CHECK(std::isnan(course.advance().loss));
    course.advance();
    CHECK(learner.orders.back().rate == Approx(2e-4 / 4));
    CHECK(learner.orders.back().count == 33);  // steps that were taken back do not count
    CHECK(course.steps() == 36);
    CHECK(recent_loss(course.records(), 100) == 0.5);
}

TEST_CASE("a training whose numbers run away at any rate ends with a sentence") {
    std::set<int> all;
    for (int n = 1; n < 100; ++n) all.insert(n);
    Course course(small_settings(), std::make_unique<Pretended>(all));
    const std::string text = refused([&] {
        for (int n = 0; n < 99; ++n) course.advance();
    });
    CHECK_THAT(text, Catch::Contains("numbers run away at step 17"));
    CHECK(course.records().size() == 17);  // the last one, too: what is saved now can go on
    CHECK(course.steps() == 17);
}

TEST_CASE("a checkpoint keeps a course to the bit, and is refused by another one or when it is damaged") {
    const Settings settings = small_settings();
    Course course(settings, std::make_unique<Pretended>(std::set<int>{3}));
    for (int n = 0; n < 5; ++n) course.advance();
    const test::Folder folder;
    const Identity identity{learn::identity(settings), "abc", "pretended"};
    write_saved(folder / "x.checkpoint", identity, course.state(), course.pool());
    const Saved saved = read_saved(folder / "x.checkpoint", settings.shape, identity);

    Course other(settings, std::make_unique<Pretended>());
    other.restore(saved.course, saved.pool);
    CHECK(other.steps() == 5);
    CHECK(other.pool() == course.pool());
    course.advance();
    other.advance();
    CHECK(other.state().learned == course.state().learned);
    CHECK(other.samples() == course.samples());
    CHECK(curve_text(other.records()) == curve_text(course.records()));
    CHECK_THAT(curve_text(course.records()), Catch::Contains("\n3,nan,"));

    const std::string bytes = read_file(folder / "x.checkpoint");
    const auto parse = [&](const std::string& text, const Identity& now) {
        return refused([&] { parse_saved(text, settings.shape, now, "x"); });
    };
    CHECK(parse(bytes, identity).empty());
    CHECK_THAT(parse(bytes, {learn::identity(settings) + " ", "abc", "pretended"}),
               Catch::Contains("another training"));
    CHECK_THAT(parse(bytes, {learn::identity(settings), "abd", "pretended"}), Catch::Contains("another picture"));
    CHECK_THAT(parse(bytes, {learn::identity(settings), "abc", "reference"}), Catch::Contains("on pretended"));
    CHECK_THAT(parse("PNG", identity), Catch::Contains("no checkpoint"));
    for (const std::size_t length : {std::size_t{16}, std::size_t{40}, std::size_t{400}, bytes.size() - 1})
        CHECK_THAT(parse(bytes.substr(0, length), identity), Catch::Contains("damaged"));
    for (const std::size_t at : {std::size_t{17}, std::size_t{60}, bytes.size() / 2, bytes.size() - 3}) {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 4);
        CHECK_THAT(parse(changed, identity), Catch::Contains("damaged"));
    }
}

TEST_CASE("settings that cannot be are refused by the name of the option") {
    const auto complaint = [](const std::function<void(Settings&)>& change) {
        Settings settings;
        change(settings);
        return refused([&] { check(settings); });
    };
    CHECK(complaint([](Settings&) {}).empty());
    CHECK_THAT(complaint([](Settings& s) { s.rate = 0; }), Catch::Contains("--rate 0"));
    CHECK_THAT(complaint([](Settings& s) { s.drop = -1; }), Catch::Contains("--drop -1"));
    CHECK_THAT(complaint([](Settings& s) { s.scale = std::nan(""); }), Catch::Contains("--scale nan"));
    CHECK_THAT(complaint([](Settings& s) { s.scale = 0; }), Catch::Contains("allowed is a number from 0.1 to 1000"));
    CHECK_THAT(complaint([](Settings& s) { s.drops = {0}; }), Catch::Contains("--drop-at 0"));
    CHECK_THAT(complaint([](Settings& s) { s.drops = {3, 3}; }), Catch::Contains("--drop-at 3,3"));
    CHECK_THAT(complaint([](Settings& s) { s.overflow = -1; }), Catch::Contains("--overflow -1"));
    CHECK_THAT(complaint([](Settings& s) { s.fewest = 97; }), Catch::Contains("--iterations 97:96"));
    CHECK_THAT(complaint([](Settings& s) { s.pool = 3; }), Catch::Contains("--pool 3 is smaller than --batch 4"));
    CHECK(bytes_needed(Settings{}) > 5e8);  // the pool alone
}
