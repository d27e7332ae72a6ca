// EXR pictures of lattices.
#include "io/exr.hpp"
#include "core/error.hpp"
#include "io/field.hpp"
#include "scratch.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

using Catch::Matchers::Contains;
using namespace pelage;
using test::Scratch;

namespace {

const std::vector<double> u{1, 2, 3, 4, 5, 6};
const std::vector<double> v{0.1f, -0.0, 1e-40f, 3e38f, -7, 0};

// Floats that hardly compress.
std::vector<double> waves(std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(std::sin(static_cast<double>(i * i)));
    return values;
}

}  // namespace

TEST_CASE("what goes into an EXR picture comes out of it") {
    const Scratch scratch;
    const Attributes attributes{
        {"seed", "7"}, {"iteration", "100"}, {"experiment", "use seed 7\n\xc3\xa4\n"}, {"version", "0.1"}};

    write_exr(scratch / "a.exr", 3, 2, {{"V", v}, {"U", u}}, attributes);
    const auto picture = read_exr(scratch / "a.exr");

    CHECK(picture.columns == 3);
    CHECK(picture.rows == 2);
    CHECK(picture.names == std::vector<std::string>{"U", "V"});
    CHECK(picture.values[0] == u);
    CHECK(picture.values[1] == v);
    CHECK(std::signbit(picture.values[1][1]));
    CHECK(picture.attributes == attributes);
    CHECK(scratch.names() == std::vector<std::string>{"a.exr"});
}

TEST_CASE("the top line of an EXR picture is the highest row, and channels are FLOAT") {
    const Scratch scratch;
    write_exr(scratch / "a.exr", 3, 2, {{"U", u}}, {});

    Imf::InputFile file((scratch / "a.exr").c_str());
    std::vector<float> pixels(6);
    Imf::FrameBuffer buffer;
    buffer.insert("U", Imf::Slice::Make(Imf::FLOAT, pixels.data(), file.header().dataWindow()));
    file.setFrameBuffer(buffer);
    file.readPixels(0, 1);

    CHECK(pixels == std::vector<float>{4, 5, 6, 1, 2, 3});
    CHECK(file.header().channels()["U"].type == Imf::FLOAT);
}

TEST_CASE("a written EXR picture is a field again") {
    const Scratch scratch;
    const auto values = waves(std::size_t{37} * 700);  // several blocks of lines

    write_exr(scratch / "a.exr", 37, 700, {{"morphogen.A", values}}, {});
    const auto field = read_field(scratch / "a.exr", "morphogen.A");

    CHECK(field->columns == 37);
    CHECK(field->values == values);
}

TEST_CASE("a channel of halves keeps three digits, beside one of floats") {
    const Scratch scratch;
    const std::vector<double> wide{0.1, 1e5, -1.0, 65504.0, 1e-9, 0.5};

    write_exr(scratch / "a.exr", 3, 2, {{"U", u, ExrType::half}, {"V", v}, {"W", wide, ExrType::half}}, {});
    const auto picture = read_exr(scratch / "a.exr");

    CHECK(picture.values[0] == u);
    CHECK(picture.values[1] == v);
    CHECK(picture.values[2][0] == Approx(0.1).epsilon(1e-3));
    CHECK(picture.values[2][0] != 0.1f);
    CHECK(std::isinf(picture.values[2][1]));
    CHECK(picture.values[2][3] == 65504.0);
    const Imf::InputFile file((scratch / "a.exr").c_str());
    CHECK(file.header().channels()["U"].type == Imf::HALF);
    CHECK(file.header().channels()["V"].type == Imf::FLOAT);
}

TEST_CASE("a large picture that several threads compress is the same picture") {
    const Scratch scratch;
    const auto values = waves(std::size_t{640} * 480);

    write_exr(scratch / "a.exr", 640, 480, {{"U", values}, {"V", values, ExrType::half}}, {});

    CHECK(read_exr(scratch / "a.exr").values[0] == values);
}

TEST_CASE("text in an EXR header is UTF-8, whatever the experiment's file holds") {
    const Scratch scratch;
    const std::string latin = "// caf\xe9 \xc3\xa4 \xf0\x9f\x90\x86 \xc3";

    write_exr(scratch / "a.exr", 3, 2, {{"U", u}}, {{"experiment", latin}});

    CHECK(read_exr(scratch / "a.exr").attributes.at("experiment") ==
          "// caf\xef\xbf\xbd \xc3\xa4 \xf0\x9f\x90\x86 \xef\xbf\xbd");
}

TEST_CASE("NaN and infinity survive in an EXR picture") {
    const Scratch scratch;
    const double infinity = std::numeric_limits<double>::infinity();

    write_exr(scratch / "a.exr", 3, 1, {{"U", std::vector{std::nan(""), infinity, 1e300}}}, {});
    const auto values = read_exr(scratch / "a.exr").values[0];

    CHECK(std::isnan(values[0]));
    CHECK(values[1] == infinity);
    CHECK(values[2] == infinity);  // too large for float
}

TEST_CASE("EXR pictures that cannot be are refused in words") {
    const Scratch scratch;
    const auto problem = [&](std::size_t columns, const std::vector<ExrChannel>& channels,
                             const Attributes& attributes) {
        return test::error_of([&] { write_exr(scratch / "a.exr", columns, 2, channels, attributes); });
    };

    CHECK_THAT(problem(3, {{"U", u}, {"U", u}}, {}), Contains("a.exr") && Contains("'U'"));
    CHECK_THAT(problem(4, {{"U", u}}, {}), Contains("6 values") && Contains("4 x 2"));
    CHECK_THAT(problem(3, {{"U", u}}, {{"channels", "x"}}), Contains("'channels'"));
    CHECK_THAT(problem(3, {}, {}), Contains("0 channels"));
    CHECK_THAT(problem(0, {{"U", {}}}, {}), Contains("0 x 2"));
    CHECK(scratch.names().empty());
}

TEST_CASE("an EXR picture that cannot be written whole is not there") {
    const Scratch scratch;
    const auto values = waves(std::size_t{128} * 128);
    const auto write = [&](const std::filesystem::path& path) {
        return test::error_of([&] { write_exr(path, 128, 128, {{"U", values}}, {}); });
    };

    CHECK_THAT(write("/dev/full"), Contains("cannot write '/dev/full': No space left on device"));
    CHECK_THAT(write(scratch / "none/a.exr"), Contains("No such file or directory"));
    {
        const test::FileSizeLimit limit(20000);
        CHECK_THAT(write(scratch / "a.exr"), Contains("a.exr': File too large"));
    }
    CHECK(scratch.names().empty());
}
