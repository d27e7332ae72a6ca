// Which files in a run's folder are results, of this run and of those before it, so that two runs never mix.
#pragma once

#include "io/manifest.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

namespace pelage::app {

// What makes two runs one: a run and the one that goes on from its checkpoint.
std::string run_identity(const std::string& experiment_text, std::int64_t seed, Precision);

// Earlier results are those that a manifest in the folder lists, and those of a run that was killed before it could
// write one: their names stand in a journal. They stay until this run has a file of its own, and then go; a resumed run
// keeps the snapshots up to its own beginning when they are its own. Files that nothing lists are the user's.
class Ledger {
public:
    Ledger(std::filesystem::path folder, std::string identity, std::optional<std::uint64_t> resumed_at);
    ~Ledger();
    Ledger(const Ledger&) = delete;
    Ledger& operator=(const Ledger&) = delete;

    void begin(const std::vector<std::string>& files);  // notes them in the journal, before they are written
    void written();                                     // they are there: earlier results go
    void finish();                                      // the manifest is there: no journal is needed any more

    // All results of this run so far, kept ones first.
    const std::vector<std::string>& files() const { return files_; }

private:
    void read_manifest();
    void read_journal();
    void take_over(const std::string& file, bool same_run);
    void add_own(const std::string& file);

    std::filesystem::path folder_;
    std::string identity_;
    std::optional<std::uint64_t> resumed_at_;
    std::vector<std::string> earlier_;  // to go
    std::vector<std::string> files_;
    std::unordered_set<std::string> own_;  // the same names
    bool cleared_ = false;
    bool journal_open_ = false;
};

// The iteration of a snapshot's file: "250.png", "250.U.npy"; nothing for others.
std::optional<std::uint64_t> iteration_of(const std::string& file);

// What the manifest beside a checkpoint says of the files its run started from, if that is the same run.
std::vector<InputFile> earlier_inputs(const std::filesystem::path& checkpoint, const std::string& identity);

}  // namespace pelage::app
