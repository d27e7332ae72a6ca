// See run_options.hpp.
#include "app/run_options.hpp"

#include "app/read_experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace pelage::app {

NeighbourSearch RunOptions::neighbour_search() const {
    if (neighbours == "spatial-sorting") return NeighbourSearch::spatial_sorting;
    return neighbours == "kd-tree" ? NeighbourSearch::kd_tree : NeighbourSearch::bins;
}

std::vector<Format> RunOptions::format_list() const { return parse_formats(formats.empty() ? "exr,png,ply" : formats); }

std::filesystem::path RunOptions::folder() const {
    if (!out.empty()) return out;
    const std::string name = file == standard_input ? "stdin" : file.stem().string();
    return std::filesystem::path("out") / (random ? fmt::format("{}-{}", name, *random) : name);
}

std::string shell_quoted(const std::string& word) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || std::string("_-./=:,+@%").find(static_cast<char>(c)) != std::string::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

namespace {

// film.mp4 becomes film-5000.mp4.
std::filesystem::path film_from(const std::filesystem::path& file, std::uint64_t iteration) {
    const std::string name = fmt::format("{}-{}{}", file.stem().string(), iteration, file.extension().string());
    return std::filesystem::path(file).replace_filename(name);
}

std::vector<std::string> video_words(const VideoOptions& video, std::uint64_t iteration) {
    if (video.file.empty()) return {};
    std::vector<std::string> words{"--video", film_from(video.file, iteration).string()};
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) words.insert(words.end(), {option, value});
    };
    add("--video-of", video.of);
    add("--every", video.every == 0 ? "" : std::to_string(video.every));
    add("--fps", video.fps == VideoOptions{}.fps ? "" : std::to_string(video.fps));
    add("--size", video.size);
    return words;
}

}  // namespace

std::string resume_command(const RunOptions& options, const std::filesystem::path& checkpoint, std::uint64_t iteration,
                           std::int64_t seed) {
    std::vector<std::string> words{options.command, "run", options.file.string()};
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) words.insert(words.end(), {option, value});
    };
    add("--backend", options.backend);
    add("--device", options.device);
    add("--precision", options.precision == Precision::double_ ? "double" : "");
    add("--neighbours", options.neighbours == "bins" ? "" : options.neighbours);
    if (options.sorting.window != SpatialSorting{}.window) add("--window", std::to_string(options.sorting.window));
    for (const std::string& setting : options.settings) add("--set", setting);
    if (options.random) add("--random", std::to_string(*options.random));
    if (options.iterations) add("--iterations", std::to_string(*options.iterations));
    add("--seed", std::to_string(seed));
    add("--out", options.folder().string());
    add("--format", options.formats);
    add("--exr-type", options.exr_type == "float" ? "" : options.exr_type);
    add("--png-bits", options.png_bits == "8" ? "" : options.png_bits);
    if (options.snap_every != 0) add("--snap-every", std::to_string(options.snap_every));
    if (options.checkpoint_every != 0) add("--checkpoint-every", std::to_string(options.checkpoint_every));
    add("--json", options.json.string());
    add("--cells", options.cells == "circle" ? "" : options.cells);
    const std::vector<std::string> video = video_words(options.video, iteration);
    words.insert(words.end(), video.begin(), video.end());
    for (const auto& [set, option] :
         {std::pair(options.polarity_marks, "--polarity-marks"), std::pair(options.quiet, "--quiet"),
          std::pair(options.explain, "--explain"), std::pair(options.fast, "--fast"),
          std::pair(options.no_cache, "--no-cache"), std::pair(options.no_self_test, "--no-self-test"),
          std::pair(options.no_tune, "--no-tune"), std::pair(options.force, "--force")}) {
        if (set) words.emplace_back(option);
    }
    add("--resume", checkpoint.string());
    std::transform(words.begin(), words.end(), words.begin(), shell_quoted);
    const char* text = options.file == standard_input ? " < EXPERIMENT.pex" : "";
    return fmt::format("{}{}", fmt::join(words, " "), text);
}

}  // namespace pelage::app
