// NumPy files byte by byte.
#include "io/npy.hpp"
#include "core/error.hpp"
#include "scratch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

// A file as numpy.save makes it: version 1.0, numbers from byte 128 on.
std::string npy(const std::string& dictionary, std::string_view numbers) {
    std::string header = dictionary;
    header.append(128 - 10 - 1 - header.size(), ' ');
    header += '\n';
    return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + std::string(numbers);
}

std::string of_type(const std::string& descr, std::size_t count, std::string_view numbers) {
    return npy("{'descr': '" + descr + "', 'fortran_order': False, 'shape': (" + std::to_string(count) + ",), }",
               numbers);
}

NpyArray parsed(const std::string& bytes) { return parse_npy(bytes, "a.npy"); }
std::string npy_problem(const std::string& bytes) {
    return test::error_of([&] { parsed(bytes); });
}

}  // namespace

TEST_CASE("all number types of .npy files are read") {
    using namespace std::string_view_literals;
    using Values = std::vector<double>;

    CHECK(parsed(of_type("<f4", 2, "\x00\x00\x80\x3f\x00\x00\x20\xc0"sv)).values == Values{1.0, -2.5});
    CHECK(parsed(of_type("<f2", 3, "\x00\x3c\x55\xb5\x01\x00"sv)).values == Values{1.0, -0.333251953125, 0x1p-24});
    CHECK(parsed(of_type("<f8", 1, "\x18\x2d\x44\x54\xfb\x21\x09\x40"sv)).values == Values{3.141592653589793});
    CHECK(parsed(of_type("<i2", 2, "\x00\x80\x34\x12"sv)).values == Values{-32768, 0x1234});
    CHECK(parsed(of_type("<i4", 2, "\xff\xff\xff\xff\x78\x56\x34\x12"sv)).values == Values{-1, 0x12345678});
    CHECK(parsed(of_type("<i8", 1, "\xfe\xff\xff\xff\xff\xff\xff\xff"sv)).values == Values{-2});
    CHECK(parsed(of_type("|i1", 2, "\x80\x7f"sv)).values == Values{-128, 127});
    CHECK(parsed(of_type("|u1", 2, "\x80\xff"sv)).values == Values{128, 255});
    CHECK(parsed(of_type("<u2", 1, "\x00\x80"sv)).values == Values{32768});
    CHECK(parsed(of_type("<u4", 1, "\xff\xff\xff\xff"sv)).values == Values{4294967295.0});
    CHECK(parsed(of_type("|b1", 3, "\x01\x00\x01"sv)).values == Values{1, 0, 1});
}

TEST_CASE("shapes and orders of .npy files") {
    using namespace std::string_view_literals;
    const auto u1 = [](const std::string& order, const std::string& shape, std::string_view numbers) {
        return parsed(npy("{'descr': '|u1', 'fortran_order': " + order + ", 'shape': " + shape + ", }", numbers));
    };

    const auto c = u1("False", "(2, 3)", "\1\2\3\4\5\6"sv);
    const auto fortran = u1("True", "(2, 3)", "\1\4\2\5\3\6"sv);
    const auto number = u1("False", "()", "\7"sv);
    const auto none = u1("False", "(0, 3)", ""sv);
    const auto line = u1("True", "(3,)", "\1\2\3"sv);

    CHECK(c.shape == std::vector<std::size_t>{2, 3});
    CHECK(c.values == std::vector<double>{1, 2, 3, 4, 5, 6});
    CHECK(fortran.shape == c.shape);
    CHECK(fortran.values == c.values);
    CHECK(number.shape.empty());
    CHECK(number.values == std::vector<double>{7});
    CHECK(none.values.empty());
    CHECK(line.values == std::vector<double>{1, 2, 3});
}

TEST_CASE("format versions 2 and 3, other spacing and quotes are read") {
    const std::string text = R"({"shape":(2,),"descr":"|u1","fortran_order":False})";
    const auto length = static_cast<char>(text.size());
    for (const char version : {'\2', '\3'}) {
        const auto bytes = std::string("\x93NUMPY") + version + '\0' + length + std::string(3, '\0') + text + "\5\6";

        CHECK(parsed(bytes).values == std::vector<double>{5, 6});
    }
}

TEST_CASE("what is not a plain array is refused in words") {
    const auto with = [](const std::string& dictionary) { return npy_problem(npy(dictionary, "")); };

    CHECK_THAT(npy_problem("GIF89a"), Contains("'a.npy' is not an .npy file"));
    CHECK_THAT(npy_problem(of_type(">f4", 1, "1234")), Contains("'>f4'") && Contains("allowed are"));
    CHECK_THAT(npy_problem(of_type(">f2", 1, "12")), Contains("allowed are little-endian f2 f4 f8"));
    CHECK_THAT(npy_problem(of_type("<f2", 2, "123")), Contains("truncated"));
    CHECK_THAT(npy_problem(of_type("|O", 1, "12345678")), Contains("'|O'"));
    CHECK_THAT(npy_problem(of_type("<c8", 1, "12345678")), Contains("'<c8'"));
    CHECK_THAT(npy_problem(of_type("<U4", 1, "1234567890123456")), Contains("'<U4'"));
    CHECK_THAT(with("{'descr': [('a', '<f4')], 'fortran_order': False, 'shape': (1,), }"), Contains("structured"));
    CHECK_THAT(with("{'descr': '<f4', 'fortran_order': False, }"), Contains("must hold"));
    CHECK_THAT(with("{'descr': '<f4', 'fortran_order': Maybe, 'shape': (1,), }"), Contains("True or False"));
    CHECK_THAT(with("{'descr': '<f4', 'fortran_order': False, 'shape': (-1,), }"), Contains("whole numbers"));
    CHECK_THAT(with("{'descr': '<f4', 'fortran_order': False, 'shape': (1 2), }"), Contains("whole numbers"));
    CHECK_THAT(with("{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999999999999,), }"), Contains("whole"));
    CHECK_THAT(with("{'descr': '<f4', 'fortran_order': False, 'shape': (4294967296, 4294967296), }"),
               Contains("absurd"));
    CHECK_THAT(with("{'descr': '<f4', 'fortran_order': False, 'shape': (1000000000,), }"), Contains("truncated"));
    CHECK_THAT(with("{'colour': 1}"), Contains("unknown entry 'colour'"));
    CHECK_THAT(with("shape"), Contains("'{' is missing"));
    CHECK_THAT(npy_problem(of_type("|u1", 2, "123")), Contains("too long"));
    CHECK_THAT(npy_problem(std::string("\x93NUMPY\x09\x00\x02\x00{}", 12)), Contains("version 9"));
    CHECK_THAT(npy_problem(npy("{'descr': '|u1', 'fortran_order': True, 'shape': (1, 1, 1), }", "1")),
               Contains("Fortran order"));
}

TEST_CASE("an .npy file cut anywhere is an error") {
    const auto whole = of_type("<f4", 2, "12345678");

    const auto accepted = test::accepted_beginnings(whole, [](auto bytes) { parse_npy(bytes, "a.npy"); });
    test::accepted_changes(whole, [](auto bytes) { parse_npy(bytes, "a.npy"); });

    CHECK(parsed(whole).values.size() == 2);
    CHECK(accepted == 0);
}

TEST_CASE("a written .npy file has the bytes that NumPy writes") {
    const Scratch scratch;

    write_npy(scratch / "a.npy", {1, 2}, std::vector<double>{1.0, -2.5}, NpyType::float32);

    const std::string dictionary = "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2), }";
    const std::string numbers("\x00\x00\x80\x3f\x00\x00\x20\xc0", 8);
    CHECK(test::get(scratch / "a.npy") == npy(dictionary, numbers));
}

TEST_CASE("written .npy files are read back with the same bits") {
    const Scratch scratch;
    const std::vector<double> values{
        0.1, -0.0, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 5e-324};

    write_npy(scratch / "a.npy", {3, 2}, values);
    write_npy(scratch / "line.npy", {6}, values, NpyType::float32);
    const auto array = read_npy(scratch / "a.npy");
    const auto line = read_npy(scratch / "line.npy");

    CHECK(array.shape == std::vector<std::size_t>{3, 2});
    REQUIRE(array.values.size() == values.size());
    CHECK(std::memcmp(array.values.data(), values.data(), values.size() * sizeof(double)) == 0);
    CHECK(line.shape == std::vector<std::size_t>{6});
    CHECK(line.values[0] == static_cast<double>(0.1f));
    CHECK(std::isnan(line.values[4]));
}

TEST_CASE("a shape that does not fit its values is not written") {
    const Scratch scratch;

    const auto text = test::error_of([&] { write_npy(scratch / "a.npy", {2, 2}, std::vector<double>(3)); });

    CHECK_THAT(text, Contains("3 values") && Contains("2, 2"));
    CHECK(scratch.names().empty());
}
