// See random_runs.hpp.
#include "support/random_runs.hpp"

#include "core/error.hpp"
#include "core/prepattern.hpp"
#include "core/space.hpp"
#include "io/exr.hpp"
#include "io/npy.hpp"
#include "io/picture.hpp"
#include "language/parse.hpp"
#include "language/shape.hpp"
#include "opencl/backend.hpp"
#include "reference/backend.hpp"
#include "verify/dice.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <variant>
#include <vector>

using namespace pelage;
using namespace pelage::verify;

namespace test {

namespace {

constexpr std::size_t columns = 19, rows = 11;  // of the pictures

// Values between 0 and 1 without any symmetry.
std::vector<double> field(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<double> values(columns * rows);
    for (double& value : values) value = dice.real(0.0, 1.0);
    return values;
}

Variation draw_variation(Dice& dice, std::size_t cells) {
    Variation variation;
    if (dice.chance(80)) {
        const std::size_t most = std::min<std::size_t>(cells, 140);
        variation.columns = dice.from_to(1, dice.pick<std::size_t>({3, 20, most}));
        variation.rows = dice.from_to(1, std::max<std::size_t>(1, cells / variation.columns));
    }
    if (dice.chance(70)) variation.seed = static_cast<std::int64_t>(dice.word());
    return variation;
}

}  // namespace

RandomFiles::RandomFiles() {
    std::string name = (std::filesystem::temp_directory_path() / "pelage-random-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Error("no folder could be made in the temporary folder");
    folder_ = name;
    std::ofstream(folder_ / "leaf.txt") << "  AooaX\n BAo abx\n\n  Cc . oo\n zZ qq\n";
    std::ofstream(folder_ / "dot.txt") << "o";
    write_npy(folder_ / "field.npy", {rows, columns}, field(1));
    const std::vector<double> u = field(2);
    const std::vector<double> v = field(3);
    // Without a channel's name Y is meant.
    write_exr(folder_ / "field.exr", columns, rows, {{"U", u}, {"Y", v}}, {});
    Picture picture(columns, rows);
    Dice dice(4);
    for (Rgb& pixel : picture.pixels) {
        for (std::uint8_t& part : pixel) part = static_cast<std::uint8_t>(dice.below(256));
    }
    write_png(folder_ / "field.png", picture);
}

RandomFiles::~RandomFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

void RandomFiles::offer(RandomLimits& limits) const {
    limits.shapes.clear();
    for (const char* name : {"leaf.txt", "dot.txt"}) {
        limits.shapes.push_back({name, language::count_letters(language::read_shape(folder_ / name))});
    }
    limits.pictures = {{"field.npy", columns, rows, {}},
                       {"field.exr", columns, rows, {"U", "Y"}},
                       {"field.png", columns, rows, {"R", "G", "B"}}};
}

Experiment Variation::of(Experiment experiment) const {
    if (seed) experiment.seed = seed;
    const auto pictured = [](const Chemical& chemical) { return chemical.initial != nullptr; };
    const bool lattice = std::holds_alternative<Lattice>(space_of(experiment));
    if (columns == 0 || !lattice || std::ranges::any_of(experiment.chemicals, pictured)) return experiment;
    resize_lattice(experiment, columns, rows);
    const std::size_t last = columns * rows - 1;
    for (Statement& statement : experiment.prepattern) {
        if (auto* set = std::get_if<SetCells>(&statement)) {
            set->first = std::min(set->first, last);
            set->last = std::min(set->last, last);
        }
    }
    return experiment;
}

std::string Variation::text() const {
    return (columns == 0 ? "size as written" : fmt::format("{} x {}", columns, rows)) +
           (seed ? fmt::format(", seed {}", *seed) : "");
}

RandomRuns::RandomRuns(bool few_settings) : few_settings_(few_settings) {}

RandomRuns::Setting RandomRuns::setting(std::uint64_t seed) const {
    Dice dice(seed + 0x5e771e55u);
    OpenclOptions options;
    const auto ways = {Path::streamed, Path::step, Path::shared, Path::tiled, Path::streamed, Path::step};
    options.path = ways.begin()[seed % ways.size()];
    if (dice.chance(few_settings_ ? 15 : 25)) options.precision = Precision::double_;
    // After that many programs one tests by itself which rules act.
    options.variants = few_settings_ ? (dice.chance(15) ? 1 : 0) : dice.pick<std::size_t>({0, 1, 3, 16});
    if (dice.chance(50)) options.width = dice.pick<std::size_t>({1, 2, 4, 8, 16});
    if (!few_settings_ && dice.chance(30)) options.work_group = dice.pick<std::size_t>({1, 3, 8, 64});
    options.guarded = dice.chance(30);
    // A program to be kept is compiled for group sizes that no run here may ask for.
    options.use_cache = options.cache_twice = !few_settings_ && dice.chance(20);
    if (!few_settings_ && dice.chance(50)) {
        options.cut.depth = dice.pick<std::size_t>({0, 1, 3, 8, 24});
        options.cut.columns = dice.pick<std::size_t>({0, 5, 16, 100});
        options.cut.rows = dice.pick<std::size_t>({0, 1, 6, 16});
        options.cut.group = dice.pick<std::size_t>({0, 1, 3, 64});
    }
    const LatticeCut& cut = options.cut;
    return {fmt::format("{}, cut {} {} {} {}, {}, {} variants, width {}, work-group {}{}{}", word(options.path),
                        cut.depth, cut.columns, cut.rows, cut.group,
                        options.precision == Precision::double_ ? "double" : "float", options.variants, options.width,
                        options.work_group, options.guarded ? ", guarded" : "", options.use_cache ? ", cached" : ""),
            options};
}

Backend& RandomRuns::device(const Setting& setting) {
    auto& backend = devices_[setting.name];
    if (!backend) backend = opencl_backend(setting.options);
    return *backend;
}

Backend& RandomRuns::reference(Precision precision) {
    auto& backend = references_[precision];
    if (!backend) backend = reference_backend(precision);
    return *backend;
}

Experiment RandomRuns::parsed(const std::string& text) const {
    return parse_experiment(text, "random.pex", files_.folder());
}

EqualRun RandomRuns::run(const Experiment& experiment, const Setting& setting, std::uint64_t seed) {
    return run_both(experiment, reference(setting.options.precision), device(setting), seed);
}

std::string RandomRuns::check(std::uint64_t seed, RandomLimits limits, std::size_t variations) {
    files_.offer(limits);
    const std::string text = random_experiment(seed, limits);
    const Experiment experiment = parsed(text);
    Setting chosen = setting(seed);
    if (!device(chosen).why_not(experiment).empty()) {
        chosen.options.precision = Precision::single_;  // a device without double
        chosen.name += " refused, float instead";
    }
    Dice dice(seed ^ 0x7a71e5u);
    for (std::size_t i = 0; i <= variations; ++i) {
        const Variation variation = i == 0 ? Variation{} : draw_variation(dice, limits.cells);
        const EqualRun result = run(variation.of(experiment), chosen, seed + i);
        ++runs_;
        if (result.finite) ++finite_;
        cells_ += result.cells;
        if (!result.difference.empty()) return explain(text, variation, chosen, seed + i, result.difference);
    }
    return "";
}

std::string RandomRuns::explain(const std::string& text, const Variation& variation, const Setting& setting,
                                std::uint64_t seed, const std::string& difference) {
    const std::uint64_t end = parsed(text).last_iteration();
    const std::string core = shrunk(text, [&](const std::string& less) {
        try {
            const Experiment smaller = parsed(less);
            return smaller.last_iteration() <= end && !run(variation.of(smaller), setting, seed).difference.empty();
        } catch (const Error&) {
            return false;  // no longer an experiment
        }
    });
    return fmt::format("{}, {}, stretches of seed {}\n{}\n{}\nThe difference needs no more than\n{}", setting.name,
                       variation.text(), seed, difference, text, core);
}

std::string shrunk(const std::string& text, const std::function<bool(const std::string&)>& fails) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line + "\n");
    const auto joined = [&](std::size_t without) {
        std::string rest;
        for (std::size_t i = 0; i < lines.size(); ++i) rest += i == without ? "" : lines[i];
        return rest;
    };
    for (bool again = true; again;) {
        again = false;
        for (std::size_t i = lines.size(); i-- > 0;) {
            if (!fails(joined(i))) continue;
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
            again = true;
        }
    }
    return joined(lines.size());
}

}  // namespace test
