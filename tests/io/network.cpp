// Files of networks: every kind there is, and what they must not be.
#include "io/network.hpp"
#include "core/error.hpp"
#include "io/archive.hpp"
#include "io/npy.hpp"
#include "io/number_type.hpp"
#include "io/pickle.hpp"
#include "scratch.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

const std::filesystem::path network_folder = PELAGE_SOURCE "/tests/io/networks";

// W0 = (0 .. 11) / 4 - 1 of 4 chemicals and 3 hidden values, b0 = 0.5 -0.25 1, W1 = ((0 .. 11) - 6) / 8.
void check_small(const Network& network) {
    CHECK(network.chemicals == 4);
    REQUIRE(network.hidden == hidden_block);
    REQUIRE(network.first.size() == 4 * hidden_block);
    REQUIRE(network.second.size() == 4 * hidden_block);
    CHECK(network.bias == std::vector<double>{0.5, -0.25, 1, 0, 0, 0, 0, 0});
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t h = 0; h < hidden_block; ++h) {
            CHECK(network.first[i * hidden_block + h] == (h < 3 ? static_cast<double>(3 * i + h) / 4 - 1 : 0));
            CHECK(network.second[h * 4 + i] == (h < 3 ? (static_cast<double>(4 * h + i) - 6) / 8 : 0));
        }
    }
}

std::string network_problem(const std::string& bytes) {
    return test::error_of([&] { parse_network(bytes, "m"); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

std::string in_order(std::string header) {
    return std::string(1, static_cast<char>(header.size())) + std::string(7, '\0') + header;
}

const std::vector<std::string> small_files{
    "protocol2.npy", "protocol3.npy", "protocol4.npy", "protocol5.npy",     "protocol5_half.npy", "python2.npy",
    "stored.npz",    "deflated.npz",  "half.npz",      "plain.safetensors", "half.safetensors",   "bfloat.safetensors"};

}  // namespace

TEST_CASE("a network is the same from every kind of file") {
    for (const std::string& name : small_files) {
        INFO(name);
        const FoundNetwork found = read_network(network_folder / name);
        check_small(found.network);
        REQUIRE(found.files.size() == 1);
        CHECK(found.files[0].name.empty());
        CHECK(found.files[0].bytes == test::get(network_folder / name));
    }
}

TEST_CASE("a network is read from a folder of three plain arrays") {
    const Scratch scratch;
    const Network from = parse_network(test::get(network_folder / "stored.npz"), "m");
    std::vector<double> first, second(from.second.begin(), from.second.begin() + 12);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t h = 0; h < 3; ++h) first.push_back(from.first[i * hidden_block + h]);
    }
    write_npy(scratch / "W0.npy", {4, 3}, first);
    write_npy(scratch / "b0.npy", {3}, std::vector<double>{0.5, -0.25, 1}, NpyType::float32);
    CHECK_THAT(test::error_of([&] { read_network(scratch.folder()); }), Contains("W1.npy"));
    write_npy(scratch / "W1.npy", {1, 1, 3, 4}, second);

    const FoundNetwork found = read_network(scratch.folder());

    check_small(found.network);
    REQUIRE(found.files.size() == 3);
    CHECK(found.files[1].name == "b0.npy");

    write_npy(scratch / "W1.npy", {4, 3}, second);
    CHECK_THAT(test::error_of([&] { read_network(scratch.folder()); }),
               Contains("W0 (4, 3), b0 (3) and W1 (4, 3); needed are (chemicals, hidden), (hidden) and"));
}

TEST_CASE("a pickle that asks for more than arrays of floats is refused, with what it asks for") {
    const std::string evil = test::get(network_folder / "calls_system.npy");
    CHECK(network_problem(evil) ==
          "'m' is pickled and is not read: it asks for 'posix.system'; a model may hold arrays of floats and nothing "
          "else");
    const std::string good = test::get(network_folder / "protocol2.npy");
    const std::size_t begin = static_cast<std::size_t>(npy_content(good, "m").data() - good.data());
    const auto with = [&](const std::string& pickle) { return network_problem(good.substr(0, begin) + pickle); };
    CHECK_THAT(with("\x80\x02"
                    "cbuiltins\neval\n."),
               Contains("'builtins.eval'"));
    CHECK_THAT(with("\x80\x06."), Contains("its protocol is 6; allowed are 2 to 5"));
    CHECK_THAT(with("\x80\x02Q."), Contains("operation 0x51"));
    CHECK_THAT(with("\x80\x02N."), Contains("it holds no list of arrays"));
    CHECK_THAT(with("\x80\x02]."), Contains("it holds 0 arrays"));
    CHECK_THAT(with(std::string("\x80\x02](K\x01K\x02K\x03"
                                "e.")),
               Contains("something else than arrays of floats"));
    CHECK_THAT(
        network_problem(replaced(good, std::string("\x01\x00\x00\x00<", 5), std::string("\x01\x00\x00\x00>", 5))),
        Contains("big-endian"));
    CHECK_THAT(network_problem(replaced(good, "f4", "i4")), Contains("something else than arrays of floats"));
}

TEST_CASE(
    "a pickle of protocol 5 that is damaged, or whose numbers lie outside of it, is refused with what was found") {
    const std::string good = test::get(network_folder / "protocol5.npy");
    const std::size_t begin = static_cast<std::size_t>(npy_content(good, "m").data() - good.data());
    const auto with = [&](const std::string& pickle) { return network_problem(good.substr(0, begin) + pickle); };
    for (const char* buffer : {"\x97", "\x98"})
        CHECK_THAT(with("\x80\x05" + std::string(buffer) + "."), Contains("its numbers lie outside of it, in buffers"));
    CHECK_THAT(with(std::string("\x80\x05\x96\xff\xff\xff\xff\xff\xff\xff\xff.", 12)), Contains("it is truncated"));
    const std::string call =
        "\x80\x05"
        "cnumpy._core.numeric\n_frombuffer\n";
    CHECK_THAT(with(call + ")R."), Contains("something else than numbers, type, shape and order"));
    CHECK_THAT(network_problem(replaced(good, std::string("\x85\x94h\x1dt", 5), std::string("\x85\x94h\x17t", 5))),
               Contains("neither C nor F"));
    CHECK_THAT(network_problem(replaced(good, std::string("K\x04K\x03\x86", 5), std::string("K\x04K\x04\x86", 5))),
               Contains("not as many numbers as its shape"));
    CHECK_THAT(network_problem(replaced(good,
                                        "\x8c\x01"
                                        "C",
                                        "\x8c\x01"
                                        "F")),
               Contains("Fortran order"));
    CHECK_THAT(network_problem(replaced(good,
                                        "\x8c\x02"
                                        "f4",
                                        "\x8c\x02"
                                        "f3")),
               Contains("f2, f4 or f8"));
    CHECK_THAT(network_problem(replaced(good, std::string("K\x04K\x03\x86", 5), std::string("K\x04N\x86N", 5))),
               Contains("is pickled and is not read"));
}

TEST_CASE("all numbers of 16 bits become the doubles that they are") {
    std::set<double> found;
    for (unsigned bits = 0; bits < 0x8000; ++bits) {
        const double value = of_half(static_cast<std::uint16_t>(bits));
        const double opposite = of_half(static_cast<std::uint16_t>(bits | 0x8000));
        if (std::isnan(value) || std::signbit(value) || !std::signbit(opposite) || value != -opposite) {
            REQUIRE(bits > 0x7c00);  // these are no numbers
            REQUIRE(std::isnan(value));
            REQUIRE(std::isnan(opposite));
            continue;
        }
        found.insert(found.end(), value);
        REQUIRE(*found.rbegin() == value);  // they ascend
        REQUIRE(found.size() == bits + 1);
    }
    // Of IEEE 754: the smallest, the largest below the normal numbers, the smallest of these, 1, a third, the largest.
    CHECK(of_half(0x0001) == 0x1p-24);
    CHECK(of_half(0x03ff) == 0x1.ff8p-15);
    CHECK(of_half(0x0400) == 0x1p-14);
    CHECK(of_half(0x3c00) == 1);
    CHECK(of_half(0x3555) == 0.333251953125);
    CHECK(of_half(0x7bff) == 65504);
    CHECK(of_half(0xfc00) == -std::numeric_limits<double>::infinity());
    const std::string third("\xab\x3e", 2), nan("\xc0\x7f", 2);
    CHECK(bfloat_type().load(third.data()) == 0.333984375);
    CHECK(std::isnan(bfloat_type().load(nan.data())));
}

TEST_CASE("a pickle cannot make more of itself than it holds") {
    // The same text encoded again and again: 6 bytes each time.
    std::string pickle = "\x80\x02";
    pickle += std::string("X\x00\x10\x00\x00", 5) + std::string(4096, 'a') + "q\x01";
    pickle += std::string("c_codecs\nencode\nq\x02X\x06\x00\x00\x00latin1q\x03", 31);
    for (int i = 0; i < 1000; ++i) pickle += "h\x02h\x01h\x03\x86R";
    CHECK_THAT(test::error_of([&] { parse_pickled_arrays(pickle, "m"); }), Contains("again and again"));
    // A list that holds itself.
    CHECK_THAT(test::error_of([&] {
                   parse_pickled_arrays(
                       "\x80\x02]q\x01h\x01"
                       "a.",
                       "m");
               }),
               Contains("something else than arrays of floats"));
}

TEST_CASE("archives that are no networks") {
    const std::string good = test::get(network_folder / "deflated.npz");
    const auto central = good.find("PK\x01\x02");
    const auto changed = [&](std::size_t at, const std::string& bytes) {
        std::string text = good;
        return network_problem(text.replace(central + at, bytes.size(), bytes));
    };
    CHECK_THAT(changed(10, std::string("\x63\x00", 2)), Contains("packed by method 99"));
    CHECK_THAT(changed(8, std::string("\x01\x00", 2)), Contains("encrypted"));
    CHECK_THAT(changed(24, std::string("\xff\xff\xff\x7f", 4)), Contains("more than any network needs"));
    CHECK_THAT(changed(24, std::string("\xff\xff\x00\x00", 4)), Contains("damaged"));
    CHECK_THAT(changed(42, std::string("\xff\xff\xff\x7f", 4)), Contains("points behind its end"));
    CHECK_THAT(network_problem(good.substr(0, 200)), Contains("the list of its files is missing"));
    CHECK_THAT(network_problem(replaced(replaced(good, "arr_1.npy", "arr_9.npy"), "arr_1.npy", "arr_9.npy")),
               Contains("'m' has no array 'b0'; it needs W0, b0 and W1 and has W0, W1, arr_9"));
}

TEST_CASE("safetensors files that are no networks") {
    const auto problem = [](const std::string& header) { return network_problem(in_order(header)); };
    CHECK_THAT(problem("{}"), Contains("has no array 'W0'"));
    CHECK_THAT(problem("{\"W0\": 3}"), Contains("'dtype', 'shape' and 'data_offsets'"));
    CHECK_THAT(problem("{,}"), Contains("no JSON object"));
    CHECK_THAT(problem(R"({"W0":{"dtype":"F8_E5M2","shape":[1],"data_offsets":[0,1]}})"),
               Contains("type 'F8_E5M2'; allowed are BF16, F16, F32 and F64"));
    for (const char* type : {"BF16", "F16"}) {
        const std::string half = fmt::format(R"({{"W0":{{"dtype":"{}","shape":[2],"data_offsets":[0,3]}}}})", type);
        CHECK_THAT(network_problem(in_order(half) + "123"), Contains("'W0' has 3 bytes of numbers"));
    }
    CHECK_THAT(problem(R"({"W0":{"dtype":"F32","shape":[1],"data_offsets":[0,4]}})"), Contains("outside of the file"));
    CHECK_THAT(problem(R"({"W0":{"dtype":"F32","shape":[9,-1],"data_offsets":[0,0]}})"), Contains("whole numbers"));
    CHECK_THAT(problem(R"({"W0":{"dtype":"F32","shape":[2,4000000000,4000000000],"data_offsets":[0,0]}})"),
               Contains("do not fill its shape"));
    const auto two = [](const char* one, const char* other, const char* where) {
        const char* const form = R"({{"{}":{{"dtype":"F32","shape":[1],"data_offsets":[0,4]}},)"
                                 R"("{}":{{"dtype":"F32","shape":[1],"data_offsets":{}}}}})";
        return network_problem(in_order(fmt::format(fmt::runtime(form), one, other, where)) + "12345678");
    };
    CHECK_THAT(two("W0", "W1", "[4,8]"), Contains("has no array"));  // the file itself is right
    CHECK_THAT(two("W0", "W0", "[4,8]"), Contains("'W0' stands in its header twice"));
    CHECK_THAT(two("W0", "W1", "[0,4]"), Contains("'W0' and 'W1' lie in the same place"));
    CHECK_THAT(two("W0", "W1", "[2,6]"), Contains("'W1' begins at byte 2 of the numbers, those before it end at 4"));
    CHECK_THAT(network_problem(in_order(R"({"W0":{"dtype":"F32","shape":[1],"data_offsets":[0,4]}})") + "123456"),
               Contains("of 6 bytes of numbers its arrays take 4"));
    CHECK_THAT(network_problem(std::string("\xff\xff\xff\xff\xff\xff\xff\xff{", 9)), Contains("at most 1048576"));
    CHECK_THAT(network_problem(std::string("\x10\x00\x00\x00\x00\x00\x00\x00{", 9)), Contains("header is not whole"));
}

TEST_CASE("networks of other sizes, and weights that are no numbers, are refused") {
    const auto of = [](std::size_t chemicals, std::size_t hidden, double weight = 0.5) {
        return test::error_of([&] {
            make_network(chemicals, hidden, std::vector<double>(chemicals * hidden, weight),
                         std::vector<double>(hidden, 0.0), std::vector<double>(chemicals * hidden, 0.0), "m");
        });
    };
    CHECK(of(4, 1).empty());
    CHECK(of(64, 256).empty());
    CHECK_THAT(of(6, 8), Contains("6 chemicals; allowed are multiples of 4 up to 64"));
    CHECK_THAT(of(68, 8), Contains("68 chemicals"));
    CHECK_THAT(of(0, 8), Contains("0 chemicals"));
    CHECK_THAT(of(4, 257), Contains("257 hidden values; allowed are 1 to 256"));
    CHECK_THAT(of(4, 0), Contains("0 hidden values"));
    CHECK_THAT(of(4, 8, 1e39), Contains("1e+39 in W0"));
    CHECK_THAT(of(4, 8, std::numeric_limits<double>::quiet_NaN()), Contains("nan in W0"));
    CHECK_THAT(test::error_of([] { make_network(4, 1, {1}, {1}, {1}, "m"); }),
               Contains("1 numbers in W0; 4 are needed"));
}

TEST_CASE("files that hold something else") {
    CHECK_THAT(network_problem("hello"), Contains("neither an .npz archive nor a pickled .npy list nor a safetensors"));
    CHECK_THAT(network_problem(""), Contains("neither"));
    const Scratch scratch;
    write_npy(scratch / "one.npy", {2}, std::vector<double>{1, 2});
    CHECK_THAT(network_problem(test::get(scratch / "one.npy")), Contains("holds a single array"));
    CHECK_THAT(test::error_of([&] { read_network(scratch / "nothing"); }), Contains("cannot read"));
    CHECK_THAT(network_problem(std::string(largest_network_file + 1, 'x')), Contains("at most 16777216 are allowed"));
}

// What is left of a damaged file is an Error, or another network, but nothing worse.
TEST_CASE("damaged networks are refused or read, and never crash") {
    for (const std::string& name : small_files) {
        INFO(name);
        const std::string bytes = test::get(network_folder / name);
        const auto parse = [](std::string_view text) { parse_network(text, "m"); };
        CHECK(test::accepted_beginnings(bytes, parse) == 0);
        const std::size_t accepted = test::accepted_changes(bytes, parse);
        CHECK(accepted < 2 * bytes.size());  // of three changes of each byte; weights may be any
    }
}

TEST_CASE("random pickles are refused, and never crash") {
    std::uint64_t state = 88172645463325252u;
    const auto next = [&] {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        return state;
    };
    const std::string codes = "(.)]tebRchqjNKMJUTBCX\x80\x85\x86\x87\x88\x89\x8a\x8c\x8d\x8e\x93\x94\x95\x96\x97";
    std::size_t read = 0;
    const std::array<std::string, 2> files{test::get(network_folder / "protocol4.npy"),
                                           test::get(network_folder / "protocol5.npy")};
    for (std::size_t round = 0; round < 20'000; ++round) {
        std::string pickle(npy_content(files[round % 2], "m"));
        for (std::uint64_t k = next() % 4 + 1; k > 0; --k)
            pickle[next() % pickle.size()] =
                k % 2 == 0 ? codes[next() % codes.size()] : static_cast<char>(next() % 256);
        const std::string problem = test::error_of([&] { parse_pickled_arrays(pickle, "m"); });
        read += problem.empty() ? 1 : 0;
    }
    CHECK(read < 15'000);
}
