// Random experiments on the reference and on the device, under settings that change from seed to seed.
#pragma once

#include "opencl/backend.hpp"
#include "verify/equal_runs.hpp"
#include "verify/random_experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace test {

// A shape and pictures that random experiments may name, in a folder that goes with it.
class RandomFiles {
public:
    RandomFiles();
    ~RandomFiles();
    RandomFiles(const RandomFiles&) = delete;
    RandomFiles& operator=(const RandomFiles&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    void offer(pelage::verify::RandomLimits&) const;

private:
    std::filesystem::path folder_;
};

// How an experiment is changed so that the programs compiled for it serve again.
struct Variation {
    std::size_t columns = 0;  // of a lattice that starts from no picture; 0: as it is
    std::size_t rows = 0;
    std::optional<std::int64_t> seed;  // empty: as it is

    pelage::Experiment of(pelage::Experiment) const;
    std::string text() const;
};

class RandomRuns {
public:
    // Few settings need few device programs beside those of the experiments themselves.
    explicit RandomRuns(bool few_settings);

    // Runs the seed's experiment on both backends, and as many variations of it in size and seed. Empty: equal.
    // Otherwise the seed, the settings, what differs first, the text, and what is left of it after taking out all lines
    // that the difference does not need.
    std::string check(std::uint64_t seed, pelage::verify::RandomLimits, std::size_t variations);

    std::size_t runs() const { return runs_; }
    std::size_t finite() const { return finite_; }
    std::uint64_t cells() const { return cells_; }  // at the ends of the runs, all together

private:
    struct Setting {
        std::string name;
        pelage::OpenclOptions options;
    };
    Setting setting(std::uint64_t seed) const;
    pelage::Backend& device(const Setting&);
    pelage::Backend& reference(pelage::Precision);
    pelage::Experiment parsed(const std::string& text) const;
    pelage::verify::EqualRun run(const pelage::Experiment&, const Setting&, std::uint64_t seed);
    std::string explain(const std::string& text, const Variation&, const Setting&, std::uint64_t seed,
                        const std::string& difference);

    RandomFiles files_;
    bool few_settings_;
    std::map<std::string, std::unique_ptr<pelage::OpenclBackend>> devices_;
    std::map<pelage::Precision, std::unique_ptr<pelage::Backend>> references_;
    std::size_t runs_ = 0, finite_ = 0;
    std::uint64_t cells_ = 0;
};

// What is left of the text after taking out, one after the other, lines without which it still fails.
std::string shrunk(const std::string& text, const std::function<bool(const std::string&)>& fails);

}  // namespace test
