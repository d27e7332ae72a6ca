// The maps in experiments/maps: what their comments say can be swept.
#include "core/experiment.hpp"
#include "language/parse.hpp"
#include "support/process.hpp"
#include "sweep/design.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace pelage;

namespace {

// Words of "// Sweep [NAME]: WORDS", line by line.
std::vector<std::vector<std::string>> sweeps_of(const std::string& text) {
    std::vector<std::vector<std::string>> all;
    std::istringstream lines(text);
    const std::regex marked("// Sweep( [a-z0-9-]+)?: (.*)");
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, marked)) continue;
        std::istringstream words(found[2]);
        all.emplace_back();
        for (std::string word; words >> word;) all.back().push_back(word);
    }
    return all;
}

std::vector<sweep::Point> points_of(const std::vector<std::string>& words) {
    const bool sampled = std::ranges::find(words, "--samples") != words.end();
    std::vector<sweep::Axis> axes;
    std::vector<sweep::Range> ranges;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "--points") return sweep::read_points(PELAGE_SOURCE "/" + words[i + 1]);
        if (words[i] != "--vary") continue;
        if (sampled) ranges.push_back(sweep::parse_range(words[i + 1]));
        if (!sampled) axes.push_back(sweep::parse_axis(words[i + 1]));
    }
    return sampled ? sweep::samples(ranges, 40, true, 1) : sweep::grid(axes, 1);
}

}  // namespace

TEST_CASE("every map says how it is swept, with values that its parameters may have") {
    std::size_t maps = 0;
    for (const auto& entry : std::filesystem::directory_iterator(PELAGE_SOURCE "/experiments/maps")) {
        if (entry.path().extension() != ".pex") continue;
        ++maps;
        INFO(entry.path().string());
        const auto sweeps = sweeps_of(test::read_all(entry.path()));
        CHECK_FALSE(sweeps.empty());
        for (const auto& words : sweeps) {
            const std::vector<sweep::Point> points = points_of(words);
            CHECK(points.size() > 4);
            for (const sweep::Point& point : {points.front(), points.back()}) {
                CHECK_NOTHROW(parse_experiment_file(entry.path(), nullptr, StartPictures::left_out, point.settings));
            }
        }
    }
    CHECK(maps >= 8);
}
