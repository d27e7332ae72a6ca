// Free cells of the published program: its experiments, the states it wrote out, and the statistics by which tissues
// that drew other random numbers are compared.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace test {

// One folder of golden/pattern_explorer.
class PublishedCells {
public:
    // Throws where the data or the experiment cannot be read; ask shared_missing first.
    explicit PublishedCells(const std::string& name);

    const std::string& name() const { return name_; }
    const pelage::Experiment& experiment() const { return experiment_; }
    // The same with other draws while it runs; its initial state stays.
    pelage::Experiment reseeded(std::int64_t seed) const;

    std::uint64_t iterations() const { return iterations_; }  // of state "final"
    bool has(const std::string& array) const;                 // "x_10", "conc_final"
    std::vector<double> array(const std::string&) const;
    std::vector<std::vector<double>> by_chemical(const std::string& array) const;  // "conc_10" as [chemical][cell]
    // Largest difference of a concentration (a position) that contraction or double precision makes in the published
    // program itself; 0: not known.
    double noise(const std::string& state) const;
    double position_noise(const std::string& state) const;
    const std::map<std::uint64_t, std::size_t>& population() const { return population_; }

private:
    std::string name_;
    std::filesystem::path folder_;
    pelage::Experiment experiment_;
    std::uint64_t iterations_ = 0;
    std::map<std::string, double> noise_, position_noise_;
    std::map<std::uint64_t, std::size_t> population_;
};

// Names of all cases that are not square grids.
std::vector<std::string> published_cells();

std::vector<double> nearest_distances(const std::vector<double>& x, const std::vector<double>& y);

// Two-sample Kolmogorov-Smirnov: the largest difference between the two cumulative distributions, and what it stays
// below with probability 1 - chance where both samples come from one distribution.
double ks_distance(std::vector<double> a, std::vector<double> b);
double ks_limit(std::size_t a, std::size_t b, double chance);

double quantile(std::vector<double> values, double share);  // the value below which `share` of them lie

// Half the sum of absolute differences of the shares: 0 the same, 1 nothing in common.
double total_variation(const std::vector<double>& a, const std::vector<double>& b);

// Connected groups of cells, nearer than 3, whose value lies above the middle between least and greatest.
std::size_t count_features(const std::vector<double>& x, const std::vector<double>& y,
                           const std::vector<double>& values);

}  // namespace test
