// Checkpoints keep every bit, and nothing that is not whole passes for one.
#include "io/checkpoint.hpp"
#include "core/error.hpp"
#include "io/checksum.hpp"
#include "scratch.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <string>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

CheckpointInfo info() {
    return {"use seed 7\n", "spots.pex", "experiments", Precision::double_, -7, "opencl", "a device", "0.1.0"};
}

Snapshot awkward() {
    auto state = test::cells({0.1, -0.0, 5e-324}, {1e300, 2, 3});
    state.iteration = 123456789012345;
    state.origin_x = -0.0;
    state.conc[0] = {std::bit_cast<double>(0x7ff8dead0000beefu), std::bit_cast<double>(0xfff0000000000001u),
                     -std::numeric_limits<double>::infinity()};
    state.mappings = {{1, 2, 3}, {0, -0.0, 0}};
    state.birth = {1, 0, std::numeric_limits<std::uint32_t>::max()};
    state.fixed = {0, 1, 0};
    state.mirrors = {{0, 2}, {1, 1}};
    state.order = {1, 0};
    return state;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bits(const Snapshot& a, const Snapshot& b) {
    const auto all = [](const auto& p, const auto& q) {
        return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                          [](const auto& x, const auto& y) { return same_bits(x, y); });
    };
    return a.iteration == b.iteration && a.columns == b.columns && a.rows == b.rows &&
           same_bits(std::vector{a.origin_x, a.origin_y}, {b.origin_x, b.origin_y}) && all(a.conc, b.conc) &&
           all(a.diff, b.diff) && all(a.mappings, b.mappings) && same_bits(a.x, b.x) && same_bits(a.y, b.y) &&
           same_bits(a.polarity_x, b.polarity_x) && same_bits(a.polarity_y, b.polarity_y) &&
           same_bits(a.birth, b.birth) && same_bits(a.neighbours, b.neighbours) && same_bits(a.fixed, b.fixed) &&
           a.mirrors == b.mirrors && a.order == b.order;
}

std::string bytes_of(const Snapshot& state) {
    const Scratch scratch;
    write_checkpoint(scratch / "a", state, info());
    return test::get(scratch / "a");
}

std::string checkpoint_problem(const std::string& bytes) {
    return test::error_of([&] { parse_checkpoint(bytes, "a.pelage"); });
}

}  // namespace

TEST_CASE("a checkpoint keeps every bit") {
    const Scratch scratch;
    for (const auto& state : {awkward(), test::lattice(7, 5), Snapshot{}}) {
        write_checkpoint(scratch / "a.pelage", state, info());
        const auto back = read_checkpoint(scratch / "a.pelage");

        CHECK(same_bits(back.snapshot, state));
        CHECK(back.info == info());
    }
    CHECK(scratch.names() == std::vector<std::string>{"a.pelage"});
}

TEST_CASE("the comparison of snapshots sees every bit") {
    const auto state = awkward();
    auto other = state;
    other.x[1] = 0.0;
    CHECK_FALSE(same_bits(state, other));
    other = state;
    other.conc[0][0] = std::bit_cast<double>(0x7ff8dead0000beeeu);
    CHECK_FALSE(same_bits(state, other));
    other = state;
    other.mirrors[0].second = 1;
    CHECK_FALSE(same_bits(state, other));
    CHECK(same_bits(state, awkward()));
}

TEST_CASE("equal elements take little room in a checkpoint") {
    auto state = test::lattice(100, 100);
    const auto before = bytes_of(state).size();

    state.conc[0].assign(10000, 1.0);
    const auto after = bytes_of(state);

    CHECK(before - after.size() == 9999 * sizeof(double));
    CHECK(same_bits(parse_checkpoint(after, "a").snapshot, state));
}

TEST_CASE("a checkpoint cut anywhere or changed anywhere is an error") {
    const auto whole = bytes_of(awkward());
    const auto parse = [](auto bytes) { parse_checkpoint(bytes, "a.pelage"); };

    CHECK(checkpoint_problem(whole).empty());
    CHECK(test::accepted_beginnings(whole, parse) == 0);
    CHECK(test::accepted_changes(whole, parse) == 0);
}

TEST_CASE("errors of checkpoints say what is wrong") {
    const auto whole = bytes_of(awkward());
    auto newer = whole;
    newer[8] = 9;
    auto damaged = whole;
    damaged[damaged.size() / 2] ^= 1;

    CHECK_THAT(checkpoint_problem("\x89PNG\r\n"), Contains("'a.pelage' is not a checkpoint"));
    CHECK_THAT(checkpoint_problem(""), Contains("is not a checkpoint"));
    CHECK_THAT(checkpoint_problem(newer), Contains("format 9") && Contains("formats 1 to 2"));
    CHECK_THAT(checkpoint_problem(whole.substr(0, whole.size() - 1)), Contains("truncated") && Contains("should have"));
    CHECK_THAT(checkpoint_problem(whole.substr(0, 12)), Contains("truncated"));
    CHECK_THAT(checkpoint_problem(whole + "x"), Contains("corrupted"));
    CHECK_THAT(checkpoint_problem(damaged), Contains("checksum"));
    CHECK_THAT(test::error_of([] { read_checkpoint("/nowhere/a.pelage"); }), Contains("/nowhere/a.pelage"));
}

TEST_CASE("a payload that lies about its lengths is refused even with a right checksum") {
    const auto whole = bytes_of(test::cells({1, 2}, {3, 4}));
    std::size_t refused = 0;
    for (std::size_t at = 20; at + 16 <= whole.size(); ++at) {
        auto bytes = whole;
        const std::uint64_t absurd = 0x7000000000000000u;
        std::memcpy(bytes.data() + at, &absurd, sizeof absurd);
        Checksum sum;
        sum.add(bytes.data() + 20, bytes.size() - 28);
        const auto value = sum.value();
        std::memcpy(bytes.data() + bytes.size() - 8, &value, sizeof value);

        refused += checkpoint_problem(bytes).empty() ? 0u : 1u;  // an Error or a state, never anything else
    }
    CHECK(refused > 0);
}

TEST_CASE("a checkpoint that cannot be written leaves the old one") {
    const Scratch scratch;
    write_checkpoint(scratch / "a.pelage", awkward(), info());
    const auto before = test::get(scratch / "a.pelage");

    std::string text;
    {
        const test::FileSizeLimit limit(5000);
        text = test::error_of([&] { write_checkpoint(scratch / "a.pelage", test::lattice(50, 50), info()); });
    }

    CHECK_THAT(text, Contains("a.pelage") && Contains("File too large"));
    CHECK(test::get(scratch / "a.pelage") == before);
    CHECK(scratch.names() == std::vector<std::string>{"a.pelage"});
    CHECK_THAT(test::error_of([] { write_checkpoint("/dev/full", awkward(), info()); }),
               Contains("No space left on device"));
}

TEST_CASE("the checksum does not depend on how bytes come in, but on each of them") {
    const std::string text = "The leopard, the cheetah and the frog.";
    Checksum whole;
    whole.add(text.data(), text.size());
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        Checksum parts;
        parts.add(text.data(), cut);
        parts.add(text.data() + cut, text.size() - cut);
        Checksum shorter;
        shorter.add(text.data(), cut);

        CHECK(parts.value() == whole.value());
        CHECK((shorter.value() == whole.value()) == (cut == text.size()));
    }
}
