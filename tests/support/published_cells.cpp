// See published_cells.hpp.
#include "support/published_cells.hpp"

#include "io/npy.hpp"
#include "language/parse.hpp"
#include "reference/neighbours/neighbours.hpp"
#include "support/shared.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace test {

using namespace pelage;

namespace {

nlohmann::json read_info(const std::filesystem::path& folder) {
    std::ifstream file(folder / "info.json");
    return nlohmann::json::parse(file);
}

std::filesystem::path folder_of(const std::string& name) { return shared("golden/pattern_explorer/" + name); }

void raise(double& largest, double value) { largest = std::max(largest, value); }

double entry(const std::map<std::string, double>& table, const std::string& key) {
    const auto found = table.find(key);
    return found == table.end() ? 0.0 : found->second;
}

Neighbours touching(const std::vector<double>& x, const std::vector<double>& y) {
    return neighbours_exact<double>(x, y, interaction_range);
}

}  // namespace

PublishedCells::PublishedCells(const std::string& name) : name_(name), folder_(folder_of(name)) {
    const nlohmann::json info = read_info(folder_);
    experiment_ = parse_experiment_file(shared("pex/" + info.at("pex").get<std::string>()));
    iterations_ = info.at("iterations").get<std::uint64_t>();
    for (const auto& [state, builds] : info.at("dev").items()) {
        for (const char* build : {"fma", "dbl"}) {
            if (!builds.contains(build) || !builds.at(build).contains("max")) continue;
            raise(noise_[state], builds.at(build).at("max"));
            raise(position_noise_[state], builds.at(build).at("pos"));
        }
    }
    for (const auto& entry : info.value("population", nlohmann::json::array())) {
        const auto text = entry.get<std::string>();  // "iteration:cells"
        const std::size_t colon = text.find(':');
        population_[std::stoull(text.substr(0, colon))] = std::stoul(text.substr(colon + 1));
    }
}

Experiment PublishedCells::reseeded(std::int64_t seed) const {
    Experiment experiment = experiment_;
    experiment.prepattern.push_back(UseSeed{seed});
    return experiment;
}

bool PublishedCells::has(const std::string& array) const { return std::filesystem::exists(folder_ / (array + ".npy")); }

std::vector<double> PublishedCells::array(const std::string& name) const {
    return read_npy(folder_ / (name + ".npy")).values;
}

std::vector<std::vector<double>> PublishedCells::by_chemical(const std::string& name) const {
    const std::vector<double> values = array(name);
    const std::size_t chemicals = experiment_.chemicals.size();
    std::vector<std::vector<double>> columns(chemicals, std::vector<double>(values.size() / chemicals));
    for (std::size_t i = 0; i < values.size(); ++i) columns[i % chemicals][i / chemicals] = values[i];
    return columns;
}

double PublishedCells::noise(const std::string& state) const { return entry(noise_, state); }
double PublishedCells::position_noise(const std::string& state) const { return entry(position_noise_, state); }

std::vector<std::string> published_cells() {
    std::vector<std::string> names;
    for (const auto& folder : std::filesystem::directory_iterator(shared("golden/pattern_explorer"))) {
        if (!folder.is_directory()) continue;
        const auto search = read_info(folder.path()).at("nns").get<std::string>();
        if (search.rfind("square grid", 0) != 0) names.push_back(folder.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<double> nearest_distances(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> distances(x.size(), std::numeric_limits<double>::infinity());
    const Neighbours near = touching(x, y);
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (const std::uint32_t j : near.of(i))
            distances[i] = std::min(distances[i], std::hypot(x[j] - x[i], y[j] - y[i]));
    }
    return distances;
}

double ks_distance(std::vector<double> a, std::vector<double> b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    double largest = 0.0;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        const double at = std::min(a[i], b[j]);
        while (i < a.size() && a[i] <= at) ++i;
        while (j < b.size() && b[j] <= at) ++j;
        largest = std::max(largest, std::abs(static_cast<double>(i) / static_cast<double>(a.size()) -
                                             static_cast<double>(j) / static_cast<double>(b.size())));
    }
    return largest;
}

double ks_limit(std::size_t a, std::size_t b, double chance) {
    const double n = static_cast<double>(a), m = static_cast<double>(b);
    return std::sqrt(-0.5 * std::log(chance / 2) * (n + m) / (n * m));
}

double quantile(std::vector<double> values, double share) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    std::sort(values.begin(), values.end());
    return values[std::min(at, values.size() - 1)];
}

double total_variation(const std::vector<double>& a, const std::vector<double>& b) {
    std::map<double, double> share;
    for (const double value : a) share[value] += 1.0 / static_cast<double>(a.size());
    for (const double value : b) share[value] -= 1.0 / static_cast<double>(b.size());
    double sum = 0.0;
    for (const auto& [value, difference] : share) sum += std::abs(difference);
    return sum / 2;
}

std::size_t count_features(const std::vector<double>& x, const std::vector<double>& y,
                           const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double middle = (*low + *high) / 2;
    const Neighbours near = touching(x, y);
    std::vector<char> seen(x.size(), 0);
    std::size_t features = 0;
    for (std::size_t start = 0; start < x.size(); ++start) {
        if (seen[start] != 0 || !(values[start] > middle)) continue;
        ++features;
        std::vector<std::size_t> open{start};
        seen[start] = 1;
        while (!open.empty()) {
            const std::size_t cell = open.back();
            open.pop_back();
            for (const std::uint32_t other : near.of(cell)) {
                if (seen[other] != 0 || !(values[other] > middle)) continue;
                seen[other] = 1;
                open.push_back(other);
            }
        }
    }
    return features;
}

}  // namespace test
