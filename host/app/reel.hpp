// The planes behind a run's pictures, kept until its end: then all pictures of an output can share one range of
// colours.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"
#include "io/colour.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pelage::app {

// For each output the range that its snapshots share; empty: it has its own.
using SharedRanges = std::vector<std::optional<ValueRange>>;

// For each output the values that it draws, one a cell; empty: they stand in the state.
using OutputValues = std::vector<std::optional<std::vector<double>>>;

inline constexpr const char* reel_name = ".pelage-reel";

// A hidden file in the run's folder. Only what pictures need is kept, in single precision.
class Reel {
public:
    // Takes up the file of the same run (`identity`) where it holds states up to `resumed_at`; else begins anew.
    Reel(std::filesystem::path folder, const Experiment&, std::string identity,
         std::optional<std::uint64_t> resumed_at);

    // Keeps what the state's pictures need; the ranges of all states so far. Throws Error when it cannot be written.
    SharedRanges keep(const Snapshot&);

    // Shows each state whose pictures have been drawn in other ranges than the last ones, with those. Only the arrays
    // that pictures need are filled in; the others are 0.
    using Draw = std::function<void(const Snapshot&, const SharedRanges&, const OutputValues&)>;
    void redraw(const Draw&);

    // Whether all pictures from that iteration can be drawn anew, as far as that is wanted.
    bool can_redraw(std::uint64_t iteration) const;

    void discard();  // the file goes

private:
    struct Record {
        std::uint64_t iteration = 0;
        long begin = 0;
        SharedRanges drawn;
    };
    struct Frame {
        Snapshot state;
        OutputValues values;
    };
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    bool shares() const;
    void open(bool anew);
    void take_up(std::uint64_t resumed_at);
    bool computes(std::size_t output) const;
    OutputValues computed(const Snapshot&) const;
    std::optional<Frame> read_record();
    void write_record(const Snapshot&, const OutputValues&);
    void widen(const Snapshot&, const OutputValues&);
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    const Experiment& experiment_;
    std::string identity_;
    SharedRanges ranges_;
    std::vector<Record> records_;
    std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace pelage::app
