// How Ready's patterns begin: overlays, and image data in every form VTK writes.
#include "import/files.hpp"

#include <fmt/format.h>
#include <zlib.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

using namespace test;
using Catch::Matchers::Contains;

namespace {

constexpr std::size_t wide = 8, high = 6;
const std::string everywhere = "<everywhere/>";

std::string point(double x, double y, double z = 0) {
    return fmt::format("<point3D x=\"{}\" y=\"{}\" z=\"{}\"/>", x, y, z);
}

std::vector<double> start(const std::string& overlays, std::size_t chemical = 0) {
    Pattern pattern;
    pattern.chemicals = 2;
    pattern.parameters.emplace_back("p", "7");
    pattern.formula = "delta_a = p;";
    pattern.generator =
        "<initial_pattern_generator apply_when_loading=\"true\">" + overlays + "</initial_pattern_generator>";
    return run(imported(pattern), 0).conc[chemical];
}

void check_start(const std::string& overlays, const std::function<double(double, double)>& expected) {
    const std::vector<double> values = start(overlays);
    for (std::size_t i = 0; i < values.size(); ++i) {
        INFO(overlays << " cell " << i);
        CHECK(values[i] == Approx(expected(double(i % wide), double(i / wide))).margin(1e-12));
    }
}

// ---- image data

std::string base64_of(const std::string& bytes) {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k > bytes.size() - i ? '=' : digits[group >> (18 - 6 * k) & 63u];
    }
    return text;
}

template <class T>
std::string bytes_of(T value, bool swapped = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (swapped) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string packed(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
             bytes.size());
    result.resize(size);
    return result;
}

double ramp(std::size_t cell) { return static_cast<double>(cell) * 0.25 - 3; }

template <class T>
std::string raw_values(bool swapped = false) {
    std::string bytes;
    for (std::size_t i = 0; i < wide * high; ++i) bytes += bytes_of(static_cast<T>(ramp(i)), swapped);
    return bytes;
}

// In blocks of 64 bytes, the last of which is smaller.
template <class Word>
std::string compressed_blocks(const std::string& bytes, std::string& header) {
    std::string data, sizes;
    Word blocks = 0;
    for (std::size_t at = 0; at < bytes.size(); at += 80, ++blocks) {
        const std::string one = packed(bytes.substr(at, 80));
        data += one;
        sizes += bytes_of(static_cast<Word>(one.size()));
    }
    header = bytes_of(blocks) + bytes_of(Word{80}) + bytes_of(static_cast<Word>(bytes.size() % 80)) + sizes;
    return data;
}

Pattern with_data(const std::string& attributes, const std::string& text, const std::string& file) {
    Pattern pattern;
    pattern.generator = "";
    pattern.formula = "delta_a = a;";
    pattern.file = file;
    pattern.data = fmt::format("<DataArray Name=\"a\" {}>{}</DataArray>", attributes, text);
    return pattern;
}

void check_ramp(const Pattern& pattern) {
    const auto made = imported(pattern);
    CHECK_THAT(made.text, Contains("define chemical a floor none conc \"test.a.npy\""));
    const auto values = run(made, 0).conc[0];
    for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == ramp(i));
}

const std::string little = "byte_order=\"LittleEndian\"";
const std::string zipped = little + " compressor=\"vtkZLibDataCompressor\"";

}  // namespace

TEST_CASE("every overlay begins as Ready computes it") {
    check_start(overlay("a", "<constant value=\"-2\"/>" + everywhere), [](double, double) { return -2; });
    check_start(overlay("a", "<parameter name=\"p\"/>" + everywhere), [](double, double) { return 7; });
    check_start(overlay("a", "<constant value=\"1\"/><rectangle>" + point(.25, .5) + point(.5, 1) + "</rectangle>"),
                [](double x, double y) { return x >= 2 && x <= 4 && y >= 3 ? 1 : 0; });
    check_start(overlay("a", "<constant value=\"1\"/><circle radius=\"0.25\">" + point(.5, .5) + "</circle>"),
                [](double x, double y) { return std::hypot(x - 4, y - 3) < 2 ? 1 : 0; });
    check_start(overlay("a", "<constant value=\"1\"/><pixel x=\"3\" y=\"2\" z=\"0\"/>"),
                [](double x, double y) { return x == 3 && y == 2 ? 1 : 0; });
    check_start(overlay("a", "<linear_gradient val1=\"1\" val2=\"3\">" + point(0, 0) + point(1, 0) +
                                 "</linear_gradient>" + everywhere),
                [](double x, double) { return 1 + 2 * x / 8; });
    check_start(overlay("a", "<radial_gradient val1=\"1\" val2=\"0\">" + point(.5, .5) + point(1, .5) +
                                 "</radial_gradient>" + everywhere),
                [](double x, double y) { return 1 - std::hypot(x - 4, y - 3) / 4; });
    check_start(overlay("a", "<gaussian height=\"2\" sigma=\"0.125\">" + point(.5, .5) + "</gaussian>" + everywhere),
                [](double x, double y) { return 2 * std::exp(-(std::pow(x - 4, 2) + std::pow(y - 3, 2)) / 2); });
    check_start(
        overlay("a", "<sine amplitude=\"2\" phase=\"1\">" + point(0, 0) + point(.5, 0) + "</sine>" + everywhere),
        [](double x, double) { return 2 * std::sin(x / 4 * 2 * M_PI - 1); });
}

TEST_CASE("overlays work one after another, with every operation") {
    const auto set = [](double value) { return fmt::format("<constant value=\"{}\"/>", value) + everywhere; };
    check_start(overlay("a", set(3)) + overlay("a", "<add/>" + set(2)), [](double, double) { return 5; });
    check_start(overlay("a", set(3)) + overlay("a", "<subtract/>" + set(2)), [](double, double) { return 1; });
    check_start(overlay("a", set(3)) + overlay("a", "<multiply/>" + set(2)), [](double, double) { return 6; });
    check_start(overlay("a", set(3)) + overlay("a", "<divide/>" + set(2)), [](double, double) { return 1.5; });
    check_start(
        overlay("b", set(3)) + overlay("a", "<other_chemical chemical=\"b\"/>" + everywhere) + overlay("b", set(1)),
        [](double, double) { return 3; });
    check_start(overlay("z", set(3)) + overlay("a", set(1)), [](double, double) { return 1; });
    const std::vector<double> noise = start(overlay("a", "<white_noise low=\"2\" high=\"3\"/>" + everywhere));
    const auto [low, top] = std::minmax_element(noise.begin(), noise.end());
    CHECK((*low >= 2 && *top < 3 && *top - *low > 0.5));
}

TEST_CASE("an overlay that is no overlay is refused") {
    Pattern pattern;
    const auto said = [&](const std::string& inside) {
        pattern.generator = "<initial_pattern_generator>" + overlay("a", inside) + "</initial_pattern_generator>";
        return refusal(text_of(pattern));
    };
    CHECK_THAT(said("<constant/>" + everywhere), Contains("'constant' has no 'value'"));
    CHECK_THAT(said("<constant value=\"x\"/>" + everywhere), Contains("must be a number"));
    CHECK_THAT(said("<perlin_noise/>" + everywhere), Contains("'perlin_noise'"));
    CHECK_THAT(said("<constant value=\"1\"/>"), Contains("needs an operation, a fill and a shape"));
    CHECK_THAT(said("<constant value=\"1\"/><rectangle>" + point(0, 0) + "</rectangle>"),
               Contains("needs a point more"));
    CHECK_THAT(said("<parameter name=\"nix\"/>" + everywhere), Contains("'nix' is no parameter"));
    CHECK_THAT(said("<sine amplitude=\"1\" phase=\"0\">" + point(0, 0) + point(0, 0) + "</sine>" + everywhere),
               Contains("are one"));
}

TEST_CASE("image data are read in every form that VTK writes") {
    std::string text;
    for (std::size_t i = 0; i < wide * high; ++i) text += fmt::format("{} ", ramp(i));
    check_ramp(with_data("type=\"Float32\" format=\"ascii\"", text, little));
    const std::string floats = raw_values<float>(), doubles = raw_values<double>();
    const auto length = [](const std::string& bytes) { return bytes_of(static_cast<std::uint32_t>(bytes.size())); };
    check_ramp(with_data("type=\"Float32\" format=\"binary\"", base64_of(length(floats) + floats), little));
    check_ramp(with_data("type=\"Float64\" format=\"binary\"", base64_of(length(doubles)) + "\n " + base64_of(doubles),
                         little));
    check_ramp(with_data("type=\"Float64\" format=\"binary\"",
                         base64_of(bytes_of(std::uint64_t{doubles.size()}) + doubles),
                         little + " header_type=\"UInt64\""));
    check_ramp(with_data("type=\"Float32\" format=\"binary\"",
                         base64_of(bytes_of(static_cast<std::uint32_t>(floats.size()), true) + raw_values<float>(true)),
                         "byte_order=\"BigEndian\""));
    std::string header;
    const std::string blocks = compressed_blocks<std::uint32_t>(floats, header);
    check_ramp(with_data("type=\"Float32\" format=\"binary\"", base64_of(header) + base64_of(blocks), zipped));
    std::string wide_header;
    const std::string wide_blocks = compressed_blocks<std::uint64_t>(floats, wide_header);
    check_ramp(with_data("type=\"Float32\" format=\"binary\"", base64_of(wide_header) + base64_of(wide_blocks),
                         zipped + " header_type=\"UInt64\""));

    Pattern appended = with_data("type=\"Float32\" format=\"appended\" offset=\"4\"", "", zipped);
    appended.appended =
        "<AppendedData encoding=\"base64\">\n _AAAA" + base64_of(header) + base64_of(blocks) + "</AppendedData>";
    check_ramp(appended);
    Pattern raw = with_data("type=\"Float32\" format=\"appended\" offset=\"1\"", "", little);
    raw.appended = "<AppendedData encoding=\"raw\">_<" + length(floats) + floats + "</AppendedData>";
    check_ramp(raw);
}

TEST_CASE("an image may hold its chemicals as components, and equal values need no file") {
    Pattern pattern;
    pattern.generator = "<initial_pattern_generator apply_when_loading=\"false\"/>";
    pattern.chemicals = 2;
    pattern.extent = "0 1 0 0 0 0";
    pattern.data =
        "<DataArray type=\"Float32\" Name=\"Scalars_\" NumberOfComponents=\"2\" format=\"ascii\">1 2 3 2</DataArray>";
    const auto made = imported(pattern);
    CHECK(made.pictures.size() == 1);
    CHECK_THAT(made.text, Contains("use chemical b conc 2"));
    CHECK(run(made, 0).conc[0] == std::vector<double>{1, 3});
}

TEST_CASE("image data that are not what their header says are refused before room is made for them") {
    const std::string floats = raw_values<float>();
    std::string header;
    const std::string blocks = compressed_blocks<std::uint32_t>(floats, header);
    const auto zip = [&](std::string head) {
        return refusal(
            text_of(with_data("type=\"Float32\" format=\"binary\"", base64_of(head) + base64_of(blocks), zipped)));
    };
    const auto with_word = [&](std::size_t index, std::uint32_t value) {
        std::string changed = header;
        changed.replace(4 * index, 4, bytes_of(value));
        return zip(changed);
    };
    CHECK(zip(header).empty());
    for (std::size_t index = 0; index < 4; ++index) {
        for (const std::uint32_t value : {0u, 1u, 0x7fffffffu, 0xffffffffu}) {
            INFO(index << " " << value);
            CHECK_THAT(with_word(index, value), Contains("test.file:14"));
        }
    }
    const auto said = [](const std::string& attributes, const std::string& text) {
        return refusal(text_of(with_data(attributes, text, little)));
    };
    CHECK_THAT(said("type=\"Float32\" format=\"ascii\"", "1 2 3"), Contains("less than the 48 numbers"));
    CHECK_THAT(said("type=\"Float32\" format=\"binary\"", "AAAA"), Contains("end within their header"));
    CHECK_THAT(said("type=\"Float32\" format=\"binary\"", "!!"), Contains("no base64"));
    CHECK_THAT(said("type=\"String\" format=\"binary\"", "AAAA"), Contains("'String'"));
    CHECK_THAT(said("type=\"Float32\" format=\"appended\" offset=\"99\"", ""), Contains("offset"));
    CHECK_THAT(refusal(text_of(with_data("type=\"Float32\" format=\"binary\"", "AAAA",
                                         little + " compressor=\"vtkLZ4DataCompressor\""))),
               Contains("vtkLZ4"));
    Pattern huge;
    huge.extent = "0 99999 0 99999 0 0";
    CHECK_THAT(refusal(text_of(huge)), Contains("too large"));
    huge.extent = "0 99999999999999999999 0 1 0 0";
    CHECK_THAT(refusal(text_of(huge)), Contains("six whole numbers"));
    huge.extent = "0 -5 0 1 0 0";
    CHECK_THAT(refusal(text_of(huge)), Contains("no extent"));
}
