// Numbers are parameters: programs depend on the structure of the rules alone, and a changed number compiles nothing.
#include "opencl/rules/numbers.hpp"

#include "core/prepattern.hpp"
#include "language/parse.hpp"
#include "opencl/rules/emit_whole.hpp"
#include "opencl/tissue.hpp"
#include "reference/backend.hpp"
#include "support/opencl_session.hpp"
#include "verify/compare.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <limits>

using namespace pelage;

namespace {

std::shared_ptr<const Experiment> parsed(const std::string& text) {
    return std::make_shared<const Experiment>(parse_experiment(text, "numbers.pex", "."));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// Every kind of rule that has numbers; each stands where a word in capitals and braces is.
const std::string rules =
    "rule always react U V scale {S} turing alpha {A} beta {B}\n"
    "rule from {F} until 40 every {E} offset 1 if U conc > {T} change V conc {C} dev 0.125\n"
    "rule if AGE >= {W} and\nrule probability {P} set U conc {V}\n"
    "rule always map U conc {L} 9 to M {M} 2\nrule if M in {I} 1.5 change V diff {R}\n";
const std::string lattice =
    "define chemical U floor {O} limit {K}\ndefine chemical V limit 30\ndefine time_step {D}\nuse seed {N}\n"
    "use chemical U conc 4 dev 1 diff {Q}\nuse chemical V conc 4 dev 1 diff 0.5 dev 0.25\n"
    "create matrix 23 17 wrap\n" +
    rules;
const std::string cells =
    "define chemical U floor {O} limit {K}\ndefine chemical V limit 30\ndefine time_step {D}\nuse seed {N}\n"
    "use chemical U conc 4 dev 1 diff {Q}\nuse chemical V conc 4 dev 1 diff 0.05 dev 0.02\n"
    "create hex_circle 5 at 0 0\n" +
    rules + "rule if V conc > {X} move {Y}\n";

std::string filled(std::string text, const std::vector<std::pair<std::string, std::string>>& numbers) {
    for (const auto& [word, number] : numbers) text = replaced(text, "{" + word + "}", number);
    return text;
}

const std::vector<std::pair<std::string, std::string>> some{
    {"S", "0.01"}, {"A", "16"},  {"B", "12"},   {"F", "3"}, {"E", "4"},    {"T", "4.5"},  {"C", "0.25"},
    {"W", "7"},    {"P", "0.3"}, {"V", "5"},    {"L", "1"}, {"M", "0.5"},  {"I", "0.75"}, {"R", "0.001"},
    {"O", "0.5"},  {"K", "25"},  {"D", "0.02"}, {"N", "5"}, {"Q", "0.75"}, {"X", "4"},    {"Y", "0.01"}};
const std::vector<std::pair<std::string, std::string>> others{
    {"S", "0.02"}, {"A", "15"},  {"B", "11"},   {"F", "2"}, {"E", "3"},    {"T", "4.25"}, {"C", "0.5"},
    {"W", "5"},    {"P", "0.6"}, {"V", "6"},    {"L", "2"}, {"M", "0.25"}, {"I", "0.5"},  {"R", "0.002"},
    {"O", "0.25"}, {"K", "24"},  {"D", "0.01"}, {"N", "6"}, {"Q", "0.5"},  {"X", "3.5"},  {"Y", "0.02"}};

}  // namespace

TEST_CASE("other numbers compile nothing anew, and give the reference's bits") {
    const Precision precision = GENERATE(Precision::single_, Precision::double_);
    const std::string text = GENERATE(lattice, cells);
    const auto session = std::shared_ptr<const Session>(std::shared_ptr<void>(), &test::session(precision));
    const auto compare = [&](const std::vector<std::pair<std::string, std::string>>& numbers) {
        const auto experiment = parsed(filled(text, numbers));
        const Snapshot initial = initial_state(*experiment, precision);
        const auto found = make_opencl_tissue(session, experiment, initial);
        const auto expected = reference_backend(precision)->make_tissue(*experiment, initial);
        for (const std::uint64_t count : {1u, 20u, 30u}) {
            found->advance(count);
            expected->advance(count);
            CHECK(verify::differences(expected->read(), found->read()) == std::vector<std::string>{});
        }
        return expected->read();
    };

    const Snapshot one = compare(some);
    const std::size_t built = session->programs();
    const Snapshot other = compare(others);

    CHECK(built > 0);
    CHECK(session->programs() == built);
    CHECK(one.conc != other.conc);
}

TEST_CASE("the range of whole numbers is the truth of the comparison") {
    constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
    for (const Comparison comparison : {Comparison::equal, Comparison::not_equal, Comparison::less,
                                        Comparison::less_equal, Comparison::greater, Comparison::greater_equal}) {
        for (const double number : {-1e30, -3.0, -0.5, 0.0, 0.5, 1.0, 2.5, 16777217.0, 4294967294.5, 4294967295.0,
                                    4294967295.5, 4294967296.0, 1e30}) {
            for (const std::uint32_t whole : {0u, 1u, 2u, 3u, 16777216u, 16777217u, 16777218u, most - 1, most}) {
                const WholeRange range = whole_range(comparison, number);
                const bool within = range.low <= whole && whole <= range.high;
                const double w = whole;
                const bool truth = comparison == Comparison::equal        ? w == number
                                   : comparison == Comparison::not_equal  ? w != number
                                   : comparison == Comparison::less       ? w < number
                                   : comparison == Comparison::less_equal ? w <= number
                                   : comparison == Comparison::greater    ? w > number
                                                                          : w >= number;
                INFO(symbol(comparison) << " of " << whole << " and " << number);
                CHECK((within == range.inside) == truth);
            }
        }
    }
}

TEST_CASE("numbers that are left out keep their places, and are not declared") {
    Numbers numbers;
    CHECK(numbers.real(0.5) == "k0");
    numbers.declare(false);
    CHECK(numbers.word(7) == "u1");
    numbers.declare(true);
    CHECK(numbers.real(2) == "k2");

    CHECK(numbers.declarations(12) == "const real k0 = R(parameters[12]);\nconst real k2 = R(parameters[14]);\n");
    CHECK(numbers.values() == std::vector<KernelNumber>{0.5, std::uint32_t{7}, 2.0});
    CHECK(parameter_words(numbers.values(), Precision::single_) ==
          std::vector<std::uint32_t>{std::bit_cast<std::uint32_t>(0.5f), 7, std::bit_cast<std::uint32_t>(2.0f)});
    CHECK(parameter_words(numbers.values(), Precision::double_) ==
          std::vector<std::uint32_t>{0, 0x3fe00000u, 7, 0, 0, 0x40000000u});
}
