// `pelage learn PICTURE`: its options.
#include "app/commands.hpp"
#include "app/training.hpp"
#include "app/validators.hpp"
#include "core/error.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <charconv>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>

namespace pelage::app {

namespace {

constexpr std::uint64_t most_steps = 100'000'000;

template <class Number>
Number number_in(const std::string& word, const std::string& whole, const char* option) {
    Number value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc{} || end != word.data() + word.size() || word.empty())
        throw Error(fmt::format("{} '{}' is not understood: '{}' is no whole number", option, whole, word));
    return value;
}

void take_iterations(const std::string& text, learn::Settings& settings) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) throw Error(fmt::format("--iterations is written LOW:HIGH, not '{}'", text));
    settings.fewest = number_in<std::size_t>(text.substr(0, colon), text, "--iterations");
    settings.most = number_in<std::size_t>(text.substr(colon + 1), text, "--iterations");
    constexpr std::size_t most = 10'000;
    if (settings.most > most) throw Error(fmt::format("--iterations {} has more than {}", text, most));
}

void take_drops(const std::string& text, learn::Settings& settings) {
    settings.drops.clear();
    if (text == "never") return;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');)
        settings.drops.push_back(number_in<std::uint64_t>(word, text, "--drop-at"));
}

void add_system(CLI::App& command, learn::Settings& settings) {
    LearningShape& shape = settings.shape;
    command.add_option("--size", shape.side, "Cells along a side of the torus, a multiple of 16. Default: 64")
        ->type_name("N")
        ->transform(whole_number(1, 4096));
    command.add_option("--chemicals", shape.chemicals, "Chemicals, a multiple of 4. Default: 32")
        ->type_name("N")
        ->transform(whole_number(1, 4096));
    command.add_option("--hidden", shape.hidden, "Hidden values of the network, a multiple of 8. Default: 128")
        ->type_name("N")
        ->transform(whole_number(1, 4096));
    command
        .add_option("--rotations", shape.rotations,
                    "Angles by which the picture is turned, the best of which counts; 1: as it is. Default: 8")
        ->type_name("N")
        ->transform(whole_number(1, 4096));
    command
        .add_option("--scale", settings.scale,
                    "Pixels of the picture that become one cell. Default: its shorter side becomes the torus's")
        ->type_name("X");
    command.add_flag("--wrap", settings.wrap, "Opposite edges of the picture fit together");
}

void add_learning_course(CLI::App& command, learn::Settings& settings) {
    command.add_option("--steps", settings.steps, "Steps of learning, those before --resume included. Default: 2000")
        ->type_name("N")
        ->transform(whole_number(1, most_steps));
    command.add_option("--batch", settings.shape.batch, "Samples of a step. Default: 4")
        ->type_name("N")
        ->transform(whole_number(1, 4096));
    command.add_option("--pool", settings.pool, "States that samples are taken from and given back to. Default: 1024")
        ->type_name("N")
        ->transform(whole_number(1, 1'000'000));
    command
        .add_option("--seed-every", settings.seed_every,
                    "Steps from one fresh seed state among the samples to the next. Default: 32")
        ->type_name("N")
        ->transform(whole_number(1, most_steps));
    command
        .add_option_function<std::string>(
            "--iterations", [&settings](const std::string& text) { take_iterations(text, settings); },
            "How many a step makes at least and at most. Default: 32:96")
        ->type_name("LOW:HIGH");
    command.add_option("--seed", settings.seed, "Seed of all random numbers. Default: 1")
        ->type_name("N")
        ->transform(whole_number(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
}

void add_optimiser(CLI::App& command, learn::Settings& settings) {
    command.add_option("--rate", settings.rate, "Learning rate of the optimiser, Adam. Default: 0.001")->type_name("X");
    command.add_option("--drop", settings.drop, "What the rate is multiplied by after each of --drop-at. Default: 0.2")
        ->type_name("X");
    command
        .add_option_function<std::string>(
            "--drop-at", [&settings](const std::string& text) { take_drops(text, settings); },
            "Steps after which the rate drops, separated by commas, or never. Default: 1000,10000")
        ->type_name("LIST");
    command.add_option("--overflow", settings.overflow, "Weight of what chemicals have beyond -1 and 1. Default: 1")
        ->type_name("X");
}

void add_learning_machine(CLI::App& command, LearnOptions& options) {
    command
        .add_option_function<std::size_t>(
            "--memory", [&options](std::size_t mebibytes) { options.settings.memory = mebibytes << 20; },
            "MiB for the states of one step; with less, some are computed twice, to the same bits. Default: 1024")
        ->type_name("MIB")
        ->transform(whole_number(1, 1 << 20));
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
        ->transform(whole_number(1, most_steps));
    command
        .add_option("--checkpoint-every", options.checkpoint_every,
                    "Steps from one checkpoint to the next; Ctrl-C and the end save one, too. Default: 1000")
        ->type_name("N")
        ->transform(whole_number(1, most_steps));
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
