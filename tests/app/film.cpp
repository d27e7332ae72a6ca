// --video: a film of a run, by a stand-in for ffmpeg that keeps the frames as they come, and by ffmpeg itself.
#include "support/process.hpp"
#include "texts.hpp"

#include "app/ffmpeg.hpp"
#include "app/film_plan.hpp"
#include "app/run_options.hpp"
#include "core/error.hpp"
#include "io/field.hpp"
#include "io/frame.hpp"
#include "io/picture.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;
using Catch::Contains;
using test::Child;
using test::Folder;
using test::Outcome;
using test::program;
using test::read_all;

namespace {

// A folder with a program `ffmpeg` of ours, found before any other.
struct Stage {
    Folder folder;
    std::string file = folder.write("spots.pex", test::spots);
    std::string film = (folder / "film.gif").string();

    explicit Stage(const std::string& script = keeper()) {
        fs::create_directories(folder / "bin");
        if (!script.empty()) {
            (void)folder.write("bin/ffmpeg", "#!/bin/sh\n" + script);
            fs::permissions(folder / "bin" / "ffmpeg", fs::perms::owner_all);
        }
    }

    // Writes down its arguments, and what it reads into the file that they end with.
    static std::string keeper() {
        return "printf '%s\\n' \"$@\" > \"$(dirname \"$0\")/arguments\"\n"
               "for last; do :; done\n"
               "exec cat > \"${last#file:}\"\n";
    }

    test::Surroundings surroundings() const {
        test::Surroundings ours;
        ours.environment["PATH"] = (folder / "bin").string() + ":" + std::getenv("PATH");
        return ours;
    }
    Outcome run(std::vector<std::string> more, const std::string& experiment = "") const {
        std::vector<std::string> words{
            "run", experiment.empty() ? file : experiment, "--backend", "reference", "--out", folder / "out"};
        words.insert(words.end(), more.begin(), more.end());
        return test::command(words, surroundings());
    }
    std::string arguments() const { return read_all(folder / "bin" / "arguments"); }
};

// RGB of a PNG picture, top line first.
std::string pixels_of(const fs::path& picture) {
    std::array<std::shared_ptr<const pelage::Field>, 3> channels;
    for (std::size_t i = 0; i < 3; ++i) channels[i] = pelage::read_field(picture, std::string(1, "RGB"[i]));
    const auto [columns, rows] = std::pair(channels[0]->columns, channels[0]->rows);
    std::string bytes;
    for (std::size_t line = 0; line < rows; ++line) {
        for (std::size_t column = 0; column < columns; ++column) {
            for (const auto& channel : channels) {
                bytes += static_cast<char>(std::lround(255 * channel->values[(rows - 1 - line) * columns + column]));
            }
        }
    }
    return bytes;
}

std::vector<std::string> frames_of(const std::string& bytes, std::size_t frame) {
    REQUIRE(bytes.size() % frame == 0);
    std::vector<std::string> frames;
    for (std::size_t at = 0; at < bytes.size(); at += frame) frames.push_back(bytes.substr(at, frame));
    return frames;
}

}  // namespace

TEST_CASE("the frames of a film are the pictures of the run, to the bit") {
    const Stage stage;
    const std::string ranged = test::spots + "output V colormap inferno range 2 6\noutput U range each\n";
    const std::string file = stage.folder.write("ranged.pex", ranged);
    const std::string of = GENERATE(as<std::string>(), "V", "U");

    const Outcome outcome = stage.run(
        {"--video", stage.film, "--video-of", of, "--every", "25", "--snap-every", "25", "--format", "png"}, file);

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(outcome.out, Contains("film.gif, 4 frames at 30 a second"));
    CHECK_THAT(stage.arguments(), Contains("\nrgb24\n") && Contains("\n384x256\n") && Contains("\n-framerate\n30\n"));
    const std::string name = of == "U" ? ".U.png" : ".png";
    const auto frames = frames_of(read_all(stage.film), 3 * 384 * 256);
    REQUIRE(frames.size() == 4);
    CHECK(frames[0] == pixels_of(stage.folder / "out" / ("0" + name)));
    CHECK(frames[1] == pixels_of(stage.folder / "out" / ("25" + name)));
    CHECK(frames[2] == pixels_of(stage.folder / "out" / ("50" + name)));
    CHECK(frames[3] == pixels_of(stage.folder / "out" / ("final" + name)));
    const auto manifest = nlohmann::json::parse(read_all(stage.folder / "out" / "manifest.json"));
    CHECK(manifest.at("film_frames") == 4);
}

TEST_CASE("brightness and colours go to ffmpeg as BT.709 has them") {
    const Stage stage;
    const std::string film = stage.folder / "film.mp4";
    const std::string coloured = test::spots + "output V colormap \"red at 0, 00ff40 at 0.5, blue at 1\" range 0 8\n";
    const auto size = GENERATE(std::pair(24, 16), std::pair(384, 256));  // as many pixels as cells; enlarged

    const Outcome outcome = stage.run(
        {"--video", film, "--every", "60", "--size", std::to_string(size.first) + "x" + std::to_string(size.second)},
        stage.folder.write("coloured.pex", coloured));

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK_THAT(stage.arguments(), Contains("\nyuv420p\n") && Contains("\nbt709\n") && Contains("\n-f\nmp4\n"));
    const auto [columns, rows] = size;
    const auto pixels = static_cast<std::size_t>(columns * rows);
    const std::string frame = frames_of(read_all(film), pixels * 3 / 2).back();
    const std::string picture = pixels_of(stage.folder / "out" / "final.png");
    const std::size_t factor = static_cast<std::size_t>(384 / columns);
    const auto channel = [&](std::size_t column, std::size_t line, std::size_t i) {
        const std::size_t place = line * factor * 384 + column * factor;
        return static_cast<double>(static_cast<std::uint8_t>(picture[3 * place + i]));
    };
    double worst = 0;
    for (std::size_t at = 0; at < pixels; ++at) {
        const std::size_t column = at % static_cast<std::size_t>(columns),
                          line = at / static_cast<std::size_t>(columns);
        const double bright =
            0.2126 * channel(column, line, 0) + 0.7152 * channel(column, line, 1) + 0.0722 * channel(column, line, 2);
        const auto found = static_cast<double>(static_cast<std::uint8_t>(frame[at]));
        worst = std::max(worst, std::abs(found - (16 + bright * 219 / 255)));
        if (column % 2 != 0 || line % 2 != 0) continue;
        double blue = 0, red = 0;
        for (const std::size_t i : {0U, 1U, 2U, 3U}) {
            const auto of = [&](std::size_t one) { return channel(column + i % 2, line + i / 2, one); };
            const double y = 0.2126 * of(0) + 0.7152 * of(1) + 0.0722 * of(2);
            blue += (of(2) - y) / 1.8556 / 4;
            red += (of(0) - y) / 1.5748 / 4;
        }
        const std::size_t quarter = line / 2 * static_cast<std::size_t>(columns / 2) + column / 2;
        const auto part = [&](std::size_t place) {
            return static_cast<double>(static_cast<std::uint8_t>(frame[place]));
        };
        worst = std::max(worst, std::abs(part(pixels + quarter) - (128 + blue * 224 / 255)));
        worst = std::max(worst, std::abs(part(pixels + pixels / 4 + quarter) - (128 + red * 224 / 255)));
    }
    CHECK(worst < 1.01);
}

TEST_CASE("frames of half the lattice's size have the means of its pixels") {
    const Stage stage;
    const std::string file = stage.folder.write(
        "half.pex",
        "define chemical V limit 8\nuse chemical V conc (8 * RANDOM) diff 0.1\ncreate matrix 64 48 wrap\n"
        "define time_step 0.1\nrule always react V by (4 - V)\nstop at 20\noutput V colormap inferno range 1 7\n");
    const auto film = [&](const char* name) {
        const std::string path = stage.folder / name;
        const Outcome outcome = stage.run({"--video", path, "--every", "10", "--size", "32x24"}, file);
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return read_all(path);
    };
    const std::vector<std::string> quick = frames_of(film("film.mp4"), 32 * 24 * 3 / 2);
    const std::vector<std::string> plain = frames_of(film("film.gif"), 32 * 24 * 3);
    REQUIRE(quick.size() == 3);
    REQUIRE(plain.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        pelage::Picture picture(32, 24);
        std::memcpy(picture.pixels.data(), plain[i].data(), plain[i].size());
        std::string expected;
        pelage::write_yuv420(picture, expected);
        CHECK(quick[i] == expected);
    }
}

TEST_CASE("a film of a lattice that grows has one size, and the lattice in its middle") {
    const Stage stage;
    const std::string growing = test::spots +
                                "rule every 15 offset 14 always expand columns 2 rows 2\n"
                                "output V range 0 8 colormap gray\n";
    const Outcome outcome = stage.run({"--video", stage.film, "--every", "20", "--snap-every", "20", "--format", "png"},
                                      stage.folder.write("growing.pex", growing));

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    // 24 x 16 cells become 32 x 24, of 16 pixels each.
    const auto frames = frames_of(read_all(stage.film), 3 * 512 * 384);
    REQUIRE(frames.size() == 4);
    CHECK(frames.back() == pixels_of(stage.folder / "out" / "final.png"));
    std::string expected(frames[0].size(), '\xff');
    const std::string small = pixels_of(stage.folder / "out" / "0.png");
    REQUIRE(small.size() == 3 * 384 * 256);
    for (std::size_t line = 0; line < 256; ++line) {
        expected.replace(3 * ((line + 64) * 512 + 64), 3 * 384, small.substr(3 * 384 * line, 3 * 384));
    }
    CHECK(frames[0] == expected);
}

TEST_CASE("without a range of its own an output is filmed in the range so far, which only widens") {
    const Stage stage;
    // U in two halves of a row: 0 and 1 in the beginning, then up to 4, then 2 at most.
    const std::string course =
        "define chemical U\nuse chemical U conc 1\ncreate matrix 16 16\nrule until 0 if COLUMN < 8 set U conc 0\n"
        "rule from 1 until 1 if COLUMN < 8 set U conc 4\nrule from 2 if COLUMN < 8 set U conc 2\n"
        "stop at 3\noutput U colormap gray\n";
    const Outcome outcome =
        stage.run({"--video", stage.film, "--every", "1"}, stage.folder.write("course.pex", course));

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const auto frames = frames_of(read_all(stage.film), 3 * 256 * 256);
    REQUIRE(frames.size() == 4);
    const auto left = [](const std::string& frame) { return static_cast<int>(static_cast<std::uint8_t>(frame[0])); };
    const auto right = [](const std::string& frame) {
        return static_cast<int>(static_cast<std::uint8_t>(frame[3 * 255]));
    };
    CHECK(left(frames[0]) == 128);  // all are 1: grey
    CHECK(std::pair(left(frames[1]), right(frames[1])) == std::pair(0, 255));
    CHECK(std::pair(left(frames[2]), right(frames[2])) == std::pair(255, 64));
    CHECK(std::pair(left(frames[3]), right(frames[3])) == std::pair(128, 64));
}

TEST_CASE("free cells, textures, maps and formulas are filmed like their pictures") {
    const Stage stage;
    const std::string cells =
        "define chemical U\nuse chemical U conc 1 dev 0.5\ncreate hex_grid 6 5 fixed\n"
        "rule always change U conc 0.1\nstop at 2\ntexture size 32 24\n"
        "output U range 0 2 colormap viridis\noutput (U * X) range -5 5 as slope\noutput rgb (U) (0.5) (0) as tints\n";
    const std::string lattice =
        test::spots + "output V height range 0 8\noutput V normal 2\noutput (U - V) range -5 5\n";
    struct Case {
        std::string experiment, of, picture;
    };
    const auto [experiment, of, picture] = GENERATE_COPY(
        Case{cells, "U", "final.png"}, Case{cells, "slope", "final.slope.png"}, Case{cells, "tints", "final.tints.png"},
        Case{cells, "texture", "texture.png"}, Case{lattice, "formula", "final.png"});
    const Outcome outcome = stage.run({"--video", stage.film, "--video-of", of, "--format", "png"},
                                      stage.folder.write("cells.pex", experiment));

    INFO(of << ": " << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const std::string expected = pixels_of(stage.folder / "out" / picture);
    const std::string bytes = read_all(stage.film);
    REQUIRE(bytes.size() >= expected.size());
    CHECK(bytes.substr(bytes.size() - expected.size()) == expected);
}

TEST_CASE("what a film cannot be is refused before the run") {
    const Stage stage;
    const auto refused = [&](const std::vector<std::string>& words) {
        const Outcome outcome = stage.run(words);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(fs::exists(stage.folder / "out" / "final.png"));
        return outcome.err;
    };
    const std::string film = stage.film;

    CHECK_THAT(refused({"--video", "film.avi"}), Contains("ends in '.avi'; allowed are .mp4, .webm and .gif"));
    CHECK_THAT(refused({"--video", "film"}), Contains("ends in nothing; allowed are"));
    CHECK_THAT(refused({"--video", film, "--fps", "0"}), Contains("'0' is not a whole number from 1 to 240"));
    CHECK_THAT(refused({"--video", film, "--fps", "60"}), Contains("too fast for a .gif, which shows up to 50"));
    CHECK_THAT(refused({"--video", film, "--every", "0"}), Contains("'0' is not a whole number"));
    for (const char* size : {"0x0", "641x480", "640", "640x", "640x480x3", "20000x20", "640X480", "-2x4"}) {
        CHECK_THAT(refused({"--video", film, "--size", size}), Contains("is not WIDTHxHEIGHT in pixels, both even"));
    }
    CHECK_THAT(refused({"--video", film, "--video-of", "W"}), Contains("has no such output; it has U"));
    CHECK_THAT(refused({"--every", "5"}), Contains("--every requires --video"));
    CHECK_THAT(refused({"--video", film, "--json", film}), Contains("is the file of --json; name another file"));
    (void)stage.folder.write("spots.gif", test::spots);
    const Outcome own = stage.run({"--video", stage.folder / "spots.gif"}, stage.folder / "spots.gif");
    CHECK_THAT(own.err, Contains("is what the run reads"));
    CHECK(read_all(stage.folder / "spots.gif") == test::spots);
}

TEST_CASE("without ffmpeg a film is refused with what to install") {
    const Stage stage("");
    test::Surroundings nothing = stage.surroundings();
    nothing.environment["PATH"] = (stage.folder / "bin").string();
    const Outcome outcome = test::command(
        {"run", stage.file, "--backend", "reference", "--out", stage.folder / "out", "--video", stage.film}, nothing);

    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Contains("program ffmpeg, which is not installed (on Debian: apt-get install ffmpeg)"));
}

TEST_CASE("an ffmpeg that fails ends the run with its last words, and leaves neither a film nor a piece of one") {
    const auto [script, words] =
        GENERATE(std::pair(std::string("head -c 10 >/dev/null; echo \"Unknown encoder 'libx264'\" >&2; exit 1\n"),
                           std::string("failed with exit code 1; its last words were: Unknown encoder 'libx264'")),
                 std::pair(std::string("kill -9 $$\n"), std::string("was ended by signal 9 and said nothing")),
                 std::pair(std::string("exit 0\n"), std::string("ended before the film did and said nothing")),
                 std::pair(std::string("cat >/dev/null; exit 0\n"), std::string("wrote nothing")),
                 std::pair(std::string("cat >/dev/null; echo 'Error closing file: No space left' >&2; exit 0\n"),
                           std::string("came to its end, but not without errors; its last words were: Error closing "
                                       "file: No space left")),
                 std::pair(std::string("cat >/dev/null; yes no | head -c 200000 >&2; echo disk full >&2; exit 3\n"),
                           std::string("disk full")));
    const Stage stage(script);
    (void)stage.folder.write("film.gif", "an earlier film");
    const Outcome outcome = stage.run({"--video", stage.film, "--every", "1"});

    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Contains("the film '" + stage.film + "' could not be made: ffmpeg ") && Contains(words));
    CHECK(outcome.err.size() < 2000);
    CHECK(read_all(stage.film) == "an earlier film");
    CHECK(test::names_in(stage.folder.path()) == std::vector<std::string>{"bin", "film.gif", "out", "spots.pex"});
}

TEST_CASE("an ffmpeg that hangs is ended, whether it takes no frames or does not come to its end") {
    using namespace std::chrono_literals;
    const std::string script = GENERATE(as<std::string>(), "exec sleep 1000\n", "cat >/dev/null; exec sleep 1000\n",
                                        "cat >/dev/null; exec >&- 2>&-; sleep 1000\n");
    const Stage stage(script);
    const std::string path = std::getenv("PATH");
    setenv("PATH", stage.surroundings().environment.at("PATH").c_str(), 1);
    std::string said;
    const auto start = std::chrono::steady_clock::now();
    try {
        pelage::app::Ffmpeg ffmpeg({}, 300ms);
        const std::string frame(1 << 20, 'x');
        for (int i = 0; i < 4; ++i) ffmpeg.write(frame.data(), frame.size());
        ffmpeg.finish();
    } catch (const pelage::Error& error) {
        said = error.what();
    }
    setenv("PATH", path.c_str(), 1);

    CHECK(said == "ffmpeg did nothing for 0.3 s and was ended and said nothing");
    CHECK(std::chrono::steady_clock::now() - start < 20s);
}

TEST_CASE("Ctrl-C leaves a film of what was run, and the printed command films the rest beside it") {
    const Stage stage;
    std::vector<std::string> words{
        program,   "run", stage.file, "--backend", "reference",    "--out", stage.folder / "out",
        "--every", "500", "--video",  stage.film,  "--iterations", "40000", "--checkpoint-every",
        "1000"};
    Child child(words, stage.surroundings());
    REQUIRE(test::wait_for(stage.folder / "out" / "checkpoint.pelage", child));
    child.signal(SIGINT);
    const Outcome outcome = child.wait();

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 130);
    const auto manifest = nlohmann::json::parse(read_all(stage.folder / "out" / "manifest.json"));
    const std::uint64_t reached = manifest.at("iterations");
    CHECK(frames_of(read_all(stage.film), 3 * 384 * 256).size() == reached / 500 + 1);
    CHECK_THAT(outcome.err, Contains("film-" + std::to_string(reached) + ".gif --every 500"));
}

TEST_CASE("a film of a resumed run begins with the state it goes on from") {
    const Stage stage;
    REQUIRE(stage.run({"--checkpoint-every", "25", "--iterations", "30"}).exit_code == 0);
    const Outcome outcome = stage.run(
        {"--resume", stage.folder / "out" / "checkpoint.pelage", "--video", stage.film, "--every", "10", "--quiet"});

    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.out.empty());
    CHECK(frames_of(read_all(stage.film), 3 * 384 * 256).size() == 5);  // 25, 30, 40, 50, 60
}

TEST_CASE("a film's name may hold anything") {
    const Stage stage;
    fs::create_directories(stage.folder / "it's a: \"new\" -folder");
    test::Surroundings there = stage.surroundings();
    there.folder = stage.folder / "it's a: \"new\" -folder";
    const Outcome outcome =
        test::command({"run", stage.file, "--backend", "reference", "--quiet", "--video=-y $(x) %d.gif"}, there);

    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(test::names_in(there.folder) == std::vector<std::string>{"-y $(x) %d.gif", "out"});
}

TEST_CASE("ffmpeg makes a film that plays: frames, size and colours are those of the pictures") {
    if (test::shell("ffmpeg -version && ffprobe -version").exit_code != 0) {
        WARN("SKIPPED: ffmpeg is not installed");
        return;
    }
    const Folder folder;
    const std::string smooth = test::spots + "output V colormap inferno range 2 6\n";
    const std::string ending = GENERATE(as<std::string>(), ".mp4", ".webm", ".gif");
    const std::string film = folder / ("film" + ending);
    const Outcome outcome =
        test::command({"run", folder.write("smooth.pex", smooth), "--backend", "reference", "--out", folder / "out",
                       "--format", "png", "--snap-every", "30", "--video", film, "--every", "30", "--fps", "25"});
    INFO(ending << ": " << outcome.err);
    REQUIRE(outcome.exit_code == 0);

    const Outcome probed = test::shell(
        "ffprobe -v error -count_frames -select_streams v -of csv=p=0 -show_entries "
        "stream=width,height,r_frame_rate,nb_read_frames " +
        film);
    CHECK_THAT(probed.out, Catch::StartsWith("384,256,25/1,3"));
    REQUIRE(test::shell("ffmpeg -v error -i " + film + " " + (folder / "frame%d.png").string()).exit_code == 0);
    for (const auto& [frame, picture] :
         std::map<std::string, std::string>{{"frame1.png", "0.png"}, {"frame3.png", "60.png"}}) {
        const std::string found = pixels_of(folder / frame), wanted = pixels_of(folder / "out" / picture);
        REQUIRE(found.size() == wanted.size());
        double sum = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            sum += std::abs(static_cast<std::uint8_t>(found[i]) - static_cast<std::uint8_t>(wanted[i]));
        }
        INFO(frame);
        CHECK(sum / static_cast<double>(found.size()) < 6);
    }
}
