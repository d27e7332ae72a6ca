// See ledger.hpp. The journal is a text: the identity of a run on its first line, then a name a line; names with a '-'
// before them are of other runs.
#include "app/ledger.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "io/format.hpp"
#include "io/sha256.hpp"
#include "io/utf8.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

namespace pelage::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* manifest_name = "manifest.json";
constexpr const char* journal_name = ".pelage-results";

std::string text_of(const fs::path& file) {
    try {
        return read_file(file);
    } catch (const Error&) {
        return {};
    }
}

// A name that a run gives: of a file in the folder itself, of a kind that we write.
bool possible(const std::string& name) {
    if (name.empty() || name.front() == '.' || name.find('/') != std::string::npos) return false;
    return name.ends_with(".pelage") ||
           std::ranges::any_of(format_endings(), [&](const std::string& ending) { return name.ends_with(ending); });
}

std::string word(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string identity_in(const Json& manifest) {
    const auto seed = manifest.find("seed");
    const auto experiment = manifest.find("experiment");
    if (seed == manifest.end() || !seed->is_number_integer() || experiment == manifest.end()) return {};
    const bool is_double = word(manifest, "precision") == "double";
    return run_identity(word(*experiment, "text"), seed->get<std::int64_t>(),
                        is_double ? Precision::double_ : Precision::single_);
}

std::vector<InputFile> inputs_in(const Json& manifest) {
    std::vector<InputFile> inputs;
    const auto found = manifest.find("inputs");
    if (found == manifest.end() || !found->is_array()) return inputs;
    for (const auto& input : *found) {
        if (input.is_object()) inputs.push_back({word(input, "file"), word(input, "sha256")});
    }
    return inputs;
}

}  // namespace

std::optional<std::uint64_t> iteration_of(const std::string& name) {
    std::uint64_t iteration = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), iteration);
    if (error != std::errc{} || end == name.data() || *end != '.') return std::nullopt;
    return iteration;
}

std::string run_identity(const std::string& experiment_text, std::int64_t seed, Precision precision) {
    return sha256(fmt::format("{}\n{} {}", valid_utf8(experiment_text), seed, static_cast<int>(precision)));
}

Ledger::Ledger(fs::path folder, std::string identity, std::optional<std::uint64_t> resumed_at)
    : folder_(std::move(folder)), identity_(std::move(identity)), resumed_at_(resumed_at) {
    read_manifest();
    read_journal();
}

// A run that failed before it had a file of its own leaves no trace.
Ledger::~Ledger() {
    if (!journal_open_ || cleared_) return;
    std::error_code ignored;
    const bool traces = std::any_of(files_.begin(), files_.end(), [&](const std::string& file) {
        const bool earlier = std::find(earlier_.begin(), earlier_.end(), file) != earlier_.end();
        return !earlier && fs::exists(folder_ / file, ignored);
    });
    if (!traces) fs::remove(folder_ / journal_name, ignored);
}

void Ledger::read_manifest() {
    const auto manifest = Json::parse(text_of(folder_ / manifest_name), nullptr, false);
    if (!manifest.is_object() || !manifest.contains("files") || !manifest["files"].is_array()) return;
    const bool same_run = identity_in(manifest) == identity_;
    for (const auto& file : manifest["files"]) {
        if (file.is_string()) take_over(file.get<std::string>(), same_run);
    }
}

void Ledger::read_journal() {
    std::error_code ignored;
    const auto there = fs::symlink_status(folder_ / journal_name, ignored);
    if (fs::exists(there) && !fs::is_regular_file(there)) {
        throw Error(fmt::format("'{}' is not what an earlier run leaves, but a link, a folder or a pipe: remove it",
                                (folder_ / journal_name).string()));
    }
    std::istringstream journal(text_of(folder_ / journal_name));
    std::string line;
    std::getline(journal, line);
    const bool same_run = line == identity_;
    while (std::getline(journal, line)) {
        const bool other = line.starts_with('-');
        take_over(other ? line.substr(1) : line, same_run && !other);
    }
}

void Ledger::take_over(const std::string& file, bool same_run) {
    if (!possible(file)) return;
    const bool own = same_run && resumed_at_.has_value();
    const auto iteration = iteration_of(file);
    if (own && iteration && *iteration <= *resumed_at_) return add_own(file);
    earlier_.push_back(file);
}

void Ledger::add_own(const std::string& file) {
    if (own_.insert(file).second) files_.push_back(file);
}

void Ledger::begin(const std::vector<std::string>& files) {
    std::ofstream journal(folder_ / journal_name, journal_open_ ? std::ios::app : std::ios::trunc);
    if (!journal_open_) {
        journal << identity_ << '\n';
        for (const auto& name : files_) journal << name << '\n';
        // Until they are gone, a run that comes after this one must know of the earlier ones too.
        for (const auto& name : earlier_) journal << '-' << name << '\n';
    }
    journal_open_ = true;
    for (const auto& file : files) {
        journal << file << '\n';
        add_own(file);
    }
    if (!journal.flush()) throw Error(fmt::format("cannot write '{}'", (folder_ / journal_name).string()));
}

void Ledger::written() {
    if (cleared_) return;
    cleared_ = true;
    std::error_code ignored;
    for (const auto& file : earlier_) {
        if (own_.count(file) == 0 && fs::is_regular_file(fs::symlink_status(folder_ / file, ignored)))
            fs::remove(folder_ / file, ignored);
    }
    if (!earlier_.empty()) fs::remove(folder_ / manifest_name, ignored);
    earlier_.clear();
    journal_open_ = false;
    begin({});
}

void Ledger::finish() {
    std::error_code ignored;
    fs::remove(folder_ / journal_name, ignored);
    journal_open_ = false;
}

std::vector<InputFile> earlier_inputs(const fs::path& checkpoint, const std::string& identity) {
    const auto manifest = Json::parse(text_of(checkpoint.parent_path() / manifest_name), nullptr, false);
    if (!manifest.is_object() || identity_in(manifest) != identity) return {};
    return inputs_in(manifest);
}

}  // namespace pelage::app
