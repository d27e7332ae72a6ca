// `pelage measure FILE...`: what patterns in arrays and pictures are like.
#include "app/commands.hpp"
#include "app/say.hpp"
#include "app/text_table.hpp"
#include "core/error.hpp"
#include "io/field.hpp"
#include "stats/statistics.hpp"

#include <fmt/format.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pelage::app {

namespace {

struct MeasureOptions {
    std::vector<std::string> files;
    std::string channel;
    bool wrap = false;
    bool json = false;
};

stats::Statistics measured(const std::string& file, const MeasureOptions& options) {
    const auto field = read_field(file, options.channel);
    return stats::statistics_of({field->values, field->columns, field->rows, options.wrap});
}

// Readers of pictures speak of the language's `channel NAME`.
std::string in_words_of_options(std::string message) {
    for (const auto& [word, option] : {std::pair<std::string, std::string>{"as in 'channel ", "as in '--channel "},
                                       {"leave the channel out", "leave --channel out"}}) {
        const std::size_t at = message.rfind(word);
        if (at != std::string::npos) message.replace(at, word.size(), option);
    }
    return message;
}

int measure(const MeasureOptions& options) {
    int exit_code = success;
    std::vector<TableLine> lines;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& file : options.files) {
        std::vector<std::pair<std::string, double>> values;
        try {
            values = stats::listed(measured(file, options));
        } catch (const Error& error) {
            say(stderr, "pelage: {}\n", in_words_of_options(error.what()));
            exit_code = bad_input;
            continue;
        }
        nlohmann::ordered_json one{{"file", file}};
        TableLine line{file}, heading{"FILE"};
        for (const auto& [name, value] : values) {
            one[name] = value;
            heading.push_back(name);
            line.push_back(fmt::format("{:.4g}", value));
        }
        if (lines.empty()) lines.push_back(heading);
        lines.push_back(line);
        all.push_back(one);
    }
    if (options.json)
        say("{}\n", all.dump(2));
    else
        say("{}", aligned(lines));
    return exit_code;
}

}  // namespace

void add_measure(CLI::App& app, int& exit_code) {
    auto* const command = app.add_subcommand("measure", "Measure patterns in arrays and pictures");
    auto options = std::make_shared<MeasureOptions>();
    command->add_option("FILE", options->files, "Arrays (.npy) and pictures (.exr, .png)")->required()->type_name("");
    command->add_option("--channel", options->channel, "Channel of pictures. Default: luminance, or the only one")
        ->type_name("NAME");
    command->add_flag("--wrap", options->wrap, "Opposite edges are neighbours, as in a torus");
    command->add_flag("--json", options->json, "The numbers as JSON");
    command->callback([options, &exit_code] { exit_code = measure(*options); });
}

}  // namespace pelage::app
