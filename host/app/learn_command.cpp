// `pelage learn PICTURE`: its options.
#include "app/commands.hpp"
#include "app/training.hpp"
#include "app/validators.hpp"
#include "core/error.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace pelage::app {

namespace {

CLI::Validator within(const WholeLimit& limit) {
    return whole_number(static_cast<std::int64_t>(limit.least), limit.most, limit.multiple);
}

CLI::Validator within(const learn::RealLimit& limit) { return number(limit.least, limit.most); }

// Adds an option whose values, and the words of its help, come from the table of limits.
template <class Limit, class Value>
void add_limited(CLI::App& command, const Limit& limit, Value& value, const std::string& what,
                 const std::string& usual) {
    command.add_option(limit.option, value, fmt::format("{}: {}. Default: {}", what, allowed(limit), usual))
        ->type_name(std::is_same_v<Limit, WholeLimit> ? "N" : "X")
        ->transform(within(limit));
}

std::uint64_t number_in(std::string word, const WholeLimit& limit, const std::string& whole) {
    (void)trimmed()(word);
    const std::string failure = within(limit)(word);
    if (!failure.empty()) throw Error(fmt::format("{} {}: {}", limit.option, whole, failure));
    return std::stoull(word);
}

std::vector<std::string> parts_of(const std::string& text, char mark) {
    std::vector<std::string> parts(1);
    for (const char one : text) {
        if (one == mark)
            parts.emplace_back();
        else
            parts.back() += one;
    }
    return parts;
}

void take_iterations(const std::string& text, learn::Settings& settings) {
    const std::vector<std::string> parts = parts_of(text, ':');
    if (parts.size() != 2)
        throw Error(fmt::format("--iterations is written LOW:HIGH, two numbers as in 32:96, not '{}'", text));
    settings.fewest = number_in(parts[0], learn::limits::iterations, text);
    settings.most = number_in(parts[1], learn::limits::iterations, text);
}

void take_drops(const std::string& text, learn::Settings& settings) {
    settings.drops.clear();
    if (text == "never") return;
    for (const std::string& part : parts_of(text, ','))
        settings.drops.push_back(number_in(part, learn::limits::drop_at, text));
}

void add_system(CLI::App& command, learn::Settings& settings) {
    using namespace learning_limits;
    LearningShape& shape = settings.shape;
    add_limited(command, size, shape.side, "Cells along a side of the torus", "64");
    add_limited(command, chemicals, shape.chemicals, "Chemicals", "32");
    add_limited(command, hidden, shape.hidden, "Hidden values of the network", "128");
    add_limited(command, rotations, shape.rotations,
                "Angles by which the picture is turned, the best of which counts; 1: as it is", "8");
    add_limited(command, learn::limits::scale, settings.scale, "Pixels of the picture that become one cell",
                "its shorter side becomes the torus's");
    command.add_flag("--wrap", settings.wrap, "Opposite edges of the picture fit together");
}

void add_learning_course(CLI::App& command, learn::Settings& settings) {
    using namespace learn::limits;
    add_limited(command, steps, settings.steps, "Steps of learning, those before --resume included", "2000");
    add_limited(command, learning_limits::batch, settings.shape.batch, "Samples of a step", "4");
    add_limited(command, pool, settings.pool,
                "States that samples are taken from and given back to, not fewer than --batch", "1024");
    add_limited(command, seed_every, settings.seed_every,
                "Steps from one fresh seed state among the samples to the next", "32");
    command
        .add_option_function<std::string>(
            "--iterations", [&settings](const std::string& text) { take_iterations(text, settings); },
            fmt::format("How many a step makes at least and at most, each {}. Default: 32:96", allowed(iterations)))
        ->type_name("LOW:HIGH");
    command.add_option("--seed", settings.seed, "Seed of all random numbers. Default: 1")
        ->type_name("N")
        ->transform(whole_number(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
}

void add_optimiser(CLI::App& command, learn::Settings& settings) {
    using namespace learn::limits;
    add_limited(command, rate, settings.rate, "Learning rate of the optimiser, Adam", "0.001");
    add_limited(command, drop, settings.drop, "What the rate is multiplied by after each of --drop-at", "0.2");
    command
        .add_option_function<std::string>(
            "--drop-at", [&settings](const std::string& text) { take_drops(text, settings); },
            "Steps after which the rate drops, ascending, separated by commas, or never. Default: 1000,10000")
        ->type_name("LIST");
    add_limited(command, overflow, settings.overflow, "Weight of what chemicals have beyond -1 and 1", "1");
}

void add_learning_machine(CLI::App& command, LearnOptions& options) {
    command
        .add_option_function<std::size_t>(
            "--memory", [&options](std::size_t mebibytes) { options.settings.memory = mebibytes << 20; },
            fmt::format("MiB for the states of one step; with less, some are computed twice, to the same bits: {}. "
                        "Default: 1024",
                        allowed(learn::limits::memory)))
        ->type_name("MIB")
        ->transform(within(learn::limits::memory));
    command.add_option("--backend", options.backend, "What computes. Default: opencl where it can")
        ->type_name("reference|opencl")
        ->check(one_of({"reference", "opencl"}));
    command.add_option("--device", options.device, "OpenCL device, as in `pelage run`")->type_name("INDEX|NAME");
}

void add_learning_files(CLI::App& command, LearnOptions& options) {
    command
        .add_option("-o,--out", options.out,
                    "The model, an .npz; loss curve, preview and checkpoint lie beside it. Default: the picture's name")
        ->type_name("MODEL.npz");
    command.add_option("--preview-every", options.preview_every, "Steps from one preview to the next. Default: 100")
        ->type_name("N")
        ->transform(within(learn::limits::steps));
    command
        .add_option("--checkpoint-every", options.checkpoint_every,
                    "Steps from one checkpoint to the next; Ctrl-C and the end save one, too. Default: 1000")
        ->type_name("N")
        ->transform(within(learn::limits::steps));
    command.add_flag("--resume", options.resume, "Go on from the checkpoint beside the model, to the same bits");
    command.add_flag("--quiet", options.quiet, "Say nothing but errors");
}

}  // namespace

void add_learn(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<LearnOptions>();
    CLI::App* command = app.add_subcommand("learn", "Train a neural reaction to grow the texture of a picture");
    command->add_option("PICTURE", options->picture, "A PNG picture")->required()->type_name("");
    add_learning_files(*command, *options);
    add_system(*command, options->settings);
    add_learning_course(*command, options->settings);
    add_optimiser(*command, options->settings);
    add_learning_machine(*command, *options);
    command->callback([options, &exit_code] { exit_code = learn_texture(*options); });
}

}  // namespace pelage::app
