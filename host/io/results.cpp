// See results.hpp.
#include "io/results.hpp"

#include "core/error.hpp"
#include "io/result_plan.hpp"
#include "io/shape.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <system_error>

namespace pelage {
namespace {

void check_outputs(const Experiment& experiment) {
    if (experiment.chemicals.empty()) throw Error("an experiment without chemicals has no results");
    for (const auto& output : experiment.outputs) {
        if (output.chemical >= experiment.chemicals.size()) {
            throw Error(
                fmt::format("an output names chemical {}; there are {}", output.chemical, experiment.chemicals.size()));
        }
    }
}

}  // namespace

namespace {

std::string without_blanks(const std::string& text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

}  // namespace

std::vector<Format> parse_formats(const std::string& list) {
    static const auto& words = *new const std::map<std::string, Format>{
        {"exr", Format::exr}, {"png", Format::png}, {"npy", Format::npy}, {"csv", Format::csv},
        {"vti", Format::vtk}, {"vtp", Format::vtk}, {"vtk", Format::vtk}};
    std::vector<Format> formats;
    for (std::size_t at = 0; at <= list.size();) {
        const auto end = std::min(list.find(',', at), list.size());
        const auto word = without_blanks(list.substr(at, end - at));
        const auto found = words.find(word);
        if (found == words.end())
            throw Error(fmt::format("unknown format '{}'; allowed are exr, png, npy, csv and vti", word));
        if (std::find(formats.begin(), formats.end(), found->second) == formats.end()) formats.push_back(found->second);
        at = end + 1;
    }
    return formats;
}

std::vector<std::string> write_results(const std::filesystem::path& folder, const std::string& stem,
                                       const Snapshot& snapshot, const Experiment& experiment,
                                       const ResultOptions& options) {
    check_shape(snapshot, experiment);
    check_outputs(experiment);
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) throw Error(fmt::format("cannot make the folder '{}': {}", folder.string(), code.message()));
    return ResultPlan(folder, stem, snapshot, experiment, options).write();
}

}  // namespace pelage
