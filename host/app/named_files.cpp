// See named_files.hpp.
#include "app/named_files.hpp"

#include "app/ledger.hpp"
#include "app/read_experiment.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <system_error>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;

// Beside the file that includes it, which stands before it in the list.
std::vector<fs::path> included_files(const fs::path& folder, const Experiment& experiment) {
    std::vector<fs::path> files;
    for (const IncludedLines& one : experiment.included) {
        fs::path beside = folder;
        for (std::size_t i = 0; i < files.size(); ++i) {
            const IncludedLines& outer = experiment.included[i];
            if (one.by >= outer.first && one.by <= outer.last) beside = files[i].parent_path();
        }
        files.push_back(beside / one.file);
    }
    return files;
}

// A name that a run gives to its results.
bool names_result(const std::string& name, const RunOptions& options) {
    if (name == "drawn.pex") return options.random.has_value();
    return name.starts_with("final.") || name.starts_with("texture.") || iteration_of(name).has_value();
}

void keep_from_results(const RunOptions& options, const std::vector<fs::path>& read) {
    for (const fs::path& file : read) {
        if (!names_result(file.filename().string(), options)) continue;
        if (!same_file(fs::absolute(file).parent_path(), options.folder())) continue;
        throw Error(fmt::format("'{}' is what the run reads, and its results would replace it; choose another --out",
                                file.string()));
    }
}

}  // namespace

bool same_file(const fs::path& one, const fs::path& other) {
    if (one.empty() || other.empty()) return false;
    std::error_code none_there;
    if (fs::equivalent(one, other, none_there)) return true;
    return fs::absolute(one).lexically_normal() == fs::absolute(other).lexically_normal();
}

void keep_inputs(const std::string& option, const fs::path& file, const std::vector<fs::path>& read,
                 const std::string& what) {
    for (const fs::path& one : read) {
        if (same_file(file, one))
            throw Error(fmt::format("{} {} is {}; name another file", option, file.string(), what));
    }
}

std::vector<fs::path> files_read(const fs::path& file, const Experiment& experiment) {
    const fs::path folder = file == standard_input ? fs::path(".") : file.parent_path();
    std::vector<fs::path> files = included_files(folder, experiment);
    if (file != standard_input) files.push_back(file);
    for (const InputFile& input : experiment.inputs) files.push_back(folder / input.name);
    return files;
}

void check_named_files(const RunOptions& options, const Experiment& experiment) {
    std::vector<fs::path> read = files_read(options.file, experiment);
    keep_from_results(options, read);
    read.push_back(options.resume);
    keep_inputs("--json", options.json, read, "what the run reads");
    keep_inputs("--video", options.video.file, read, "what the run reads");
    keep_inputs("--video", options.video.file, {options.json}, "the file of --json");
}

}  // namespace pelage::app
