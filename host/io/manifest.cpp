// See manifest.hpp.
#include "io/manifest.hpp"

#include "io/atomic_file.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <ctime>
#include <nlohmann/json.hpp>

namespace pelage {
namespace {

nlohmann::ordered_json options_of(const Manifest& manifest) {
    auto options = nlohmann::ordered_json::object();
    for (const auto& [name, flag, value] : manifest.options) {
        auto& entry = options[name] = nullptr;
        if (flag)
            entry = value.has_value();
        else if (value)
            entry = *value;
    }
    return options;
}

nlohmann::ordered_json inputs_of(const Experiment& experiment) {
    auto inputs = nlohmann::ordered_json::array();
    for (const InputFile& input : experiment.inputs) {
        auto& entry = inputs.emplace_back(nlohmann::ordered_json{{"file", input.name}, {"sha256", nullptr}});
        if (!input.sha256.empty()) entry["sha256"] = input.sha256;
    }
    return inputs;
}

nlohmann::ordered_json to_json(const Manifest& manifest, const Experiment& experiment) {
    nlohmann::ordered_json json{{"backend", manifest.backend},
                                {"device", manifest.device},
                                {"driver", manifest.driver},
                                {"platform", manifest.platform},
                                {"precision", manifest.precision == Precision::double_ ? "double" : "float"},
                                {"seed", manifest.seed},
                                {"iterations", manifest.iterations},
                                {"time", manifest.time},
                                {"cells", manifest.cells},
                                {"columns", manifest.columns},
                                {"rows", manifest.rows},
                                {"seconds", manifest.seconds},
                                {"updates_per_second", manifest.updates_per_second},
                                {"started", iso_time(manifest.started)},
                                {"version", manifest.version},
                                {"build_options", manifest.build_options},
                                {"fast", manifest.fast},
                                {"files", manifest.files}};
    for (const auto& [key, text] : manifest.more_texts) json[key] = text;
    for (const auto& [key, number] : manifest.more_numbers) json[key] = number;
    for (const auto& [key, count] : manifest.more_counts) json[key] = count;
    json["options"] = options_of(manifest);
    auto& parameters = json["parameters"] = nlohmann::ordered_json::object();
    for (const Parameter& one : experiment.parameters) parameters[one.name] = one.value;
    json["inputs"] = inputs_of(experiment);
    auto& phases = json["phases"] = nlohmann::ordered_json::array();
    for (const auto& phase : experiment.phases) phases.push_back(phase.name);
    json["experiment"] = {{"source", experiment.source}, {"text", experiment.text}};
    return json;
}

}  // namespace

std::string iso_time(std::chrono::system_clock::time_point time) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

std::string manifest_text(const Manifest& manifest, const Experiment& experiment) {
    // Text that is not UTF-8 gets replacement characters.
    return to_json(manifest, experiment).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_manifest(const std::filesystem::path& path, const Manifest& manifest, const Experiment& experiment) {
    write_file(path, manifest_text(manifest, experiment));
}

}  // namespace pelage
