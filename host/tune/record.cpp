// See record.hpp.
#include "tune/record.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/checksum.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>

namespace pelage::tune {

namespace {

constexpr const char* format_name = "pelage tuning 1";

// A driver may not speak UTF-8.
std::string dumped(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

nlohmann::ordered_json json_of(const Key& key) {
    return {{"device", key.device},   {"version", key.version},
            {"driver", key.driver},   {"platform_version", key.platform_version},
            {"program", key.program}, {"precision", key.precision},
            {"fast", key.fast},       {"size", key.size},
            {"rules", key.rules}};
}

const Trial* fastest(const std::vector<Trial>& trials) {
    const Trial* best = nullptr;
    for (const Trial& trial : trials) {
        if (trial.verdict != Verdict::good) continue;
        if (best == nullptr || trial.updates_per_second > best->updates_per_second) best = &trial;
    }
    return best;
}

}  // namespace

Key make_key(const DeviceInfo& device, const std::string& program, Precision precision, bool fast,
             const Experiment& experiment) {
    return {device.name,
            device.version,
            device.driver,
            device.platform_version,
            program,
            precision == Precision::double_ ? "double" : "float",
            fast,
            size_class(lattice_size(experiment)),
            rules_class(experiment.text)};
}

const Trial* Record::find(const Candidate& candidate) const {
    const auto found = std::ranges::find(trials, candidate, &Trial::candidate);
    return found == trials.end() ? nullptr : &*found;
}

void Record::put(const Trial& trial) {
    const auto found = std::ranges::find(trials, trial.candidate, &Trial::candidate);
    if (found == trials.end()) {
        trials.push_back(trial);
    } else {
        *found = trial;
    }
}

Candidate Record::best() const {
    const Trial* defaults = find({});
    const Trial* best = fastest(trials);
    if (best == nullptr) return {};
    // Not yet tried, they are not to be judged by what others reach.
    if (defaults == nullptr) return {};
    if (defaults->verdict != Verdict::good) return best->candidate;
    return best->updates_per_second > (1 + least_gain) * defaults->updates_per_second ? best->candidate : Candidate{};
}

double Record::gain() const {
    const Trial* defaults = find({});
    const Trial* chosen = find(best());
    if (defaults == nullptr || chosen == nullptr || defaults->updates_per_second <= 0) return 0;
    return chosen->updates_per_second / defaults->updates_per_second - 1;
}

nlohmann::ordered_json to_json(const Record& record) {
    nlohmann::ordered_json json{{"format", format_name},           {"key", json_of(record.key)},
                                {"exhaustive", record.exhaustive}, {"complete", record.complete},
                                {"best", to_json(record.best())},  {"gain", record.gain()}};
    auto& trials = json["trials"] = nlohmann::ordered_json::array();
    for (const Trial& trial : record.trials) trials.push_back(to_json(trial));
    return json;
}

std::filesystem::path record_file(const std::filesystem::path& folder, const Key& key) {
    const std::string text = dumped(json_of(key), -1);
    Checksum sum;
    sum.add(text.data(), text.size());
    return folder / fmt::format("{:016x}.tuning", sum.value());
}

std::optional<Record> load_record(const std::filesystem::path& folder, const Key& key) {
    if (folder.empty()) return {};
    try {
        const auto json = nlohmann::ordered_json::parse(read_file(record_file(folder, key)));
        // As it was written: bytes that are not UTF-8 have been replaced in the file.
        if (json.at("format") != format_name || dumped(json.at("key"), -1) != dumped(json_of(key), -1)) return {};
        Record record;
        record.key = key;
        record.exhaustive = json.at("exhaustive").get<bool>();
        record.complete = json.at("complete").get<bool>();
        for (const auto& trial : json.at("trials")) record.put(trial_from_json(trial));
        return record;
    } catch (const Error&) {
        return {};
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

std::string store_record(const std::filesystem::path& folder, const Record& record) {
    if (folder.empty()) return "there is no folder for it";
    try {
        std::error_code ignored;
        std::filesystem::create_directories(folder, ignored);
        write_file(record_file(folder, record.key), dumped(to_json(record), 2) + "\n");
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

void forget_record(const std::filesystem::path& folder, const Key& key) {
    if (folder.empty()) return;
    std::error_code ignored;
    std::filesystem::remove(record_file(folder, key), ignored);
}

}  // namespace pelage::tune
