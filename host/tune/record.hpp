// What became of the candidates for one problem class on one device, kept on disk from run to run.
#pragma once

#include "tune/trial.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pelage::tune {

// All that a record depends on.
struct Key {
    std::string device;
    std::string version;
    std::string driver;
    std::string platform_version;
    std::string program;  // a checksum of it
    std::string precision;
    bool fast = false;
    std::string size;   // see size_class
    std::string rules;  // see rules_class

    bool operator==(const Key&) const = default;
};

Key make_key(const DeviceInfo&, const std::string& program, Precision, bool fast, const Experiment&);

struct Record {
    Key key;
    bool exhaustive = false;    // of the latest search
    bool complete = false;      // that search came to its end
    std::vector<Trial> trials;  // in the order in which they were made

    const Trial* find(const Candidate&) const;
    void put(const Trial&);  // in the place of an earlier trial of the same candidate

    // The fastest that is good, when it is faster than the defaults by more than what measurements wander; else the
    // defaults, unless these are struck out.
    Candidate best() const;
    double gain() const;  // of best() over the defaults: 0.25 for a quarter faster; 0: none, or not known
};

inline constexpr double least_gain = 0.03;

nlohmann::ordered_json to_json(const Record&);

std::filesystem::path record_file(const std::filesystem::path& folder, const Key&);

// A file that is missing, damaged or belongs to another key is simply not there.
std::optional<Record> load_record(const std::filesystem::path& folder, const Key&);

// The file appears whole or not at all. Why it could not be kept; empty: it was.
std::string store_record(const std::filesystem::path& folder, const Record&);

void forget_record(const std::filesystem::path& folder, const Key&);

}  // namespace pelage::tune
