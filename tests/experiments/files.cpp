// Finds the files in experiments/ and the moments in them that are worth a short run.
#include "experiments/files.hpp"

#include <algorithm>
#include <fstream>

namespace test {

std::vector<std::filesystem::path> experiment_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(PELAGE_SOURCE "/experiments")) {
        const std::filesystem::path folder = entry.path().parent_path();
        // One has parts of experiments, which include them, the other an experiment whose network everyone brings
        // along.
        const bool part = folder.filename() == "gray-scott" || folder.filename() == "neural";
        if (entry.path().extension() == ".pex" && !part) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string remarks(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string text;
    for (std::string line; std::getline(in, line) && line.starts_with("//");) text += line.substr(2);
    return text;
}

std::string first_line(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

std::set<std::uint64_t> beginnings(const pelage::Experiment& experiment) {
    std::set<std::uint64_t> found{0};
    for (const pelage::Phase& phase : experiment.phases) found.insert(phase.begin);
    for (const pelage::Rule& rule : experiment.rules) {
        found.insert(rule.from);
        const auto* when = std::get_if<pelage::Compare>(&rule.condition);
        if (when != nullptr && when->left.quantity == pelage::Quantity::age) {
            found.insert(static_cast<std::uint64_t>(when->right.value));
        }
    }
    found.erase(found.lower_bound(experiment.last_iteration()), found.end());
    return found;
}

}  // namespace test
