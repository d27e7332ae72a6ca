// One tile of a sweep: from its values to its files and its row of the table.
#pragma once

#include "app/sweep_design.hpp"
#include "app/sweeper.hpp"
#include "core/experiment.hpp"
#include "core/tissue.hpp"
#include "io/npy.hpp"
#include "sweep/table.hpp"
#include "sweep/tile.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace pelage::app {

class TileRunner {
public:
    // `text`: the experiment's. Keeps references to what it is given.
    TileRunner(const SweepOptions&, const SweepDesign&, const std::string& text, const sweep::Table&);

    // Throws Error where the text, with the tile's values, is not an experiment whose results can be measured.
    Experiment experiment(std::size_t tile) const;
    Experiment named_experiment(std::size_t tile) const;  // where it is wrong, the error says which tile it is
    std::uint64_t last_iteration(const Experiment&) const;

    // Runs it, writes its files and returns its row; empty: interrupted. Any thread.
    std::optional<std::string> run(Backend&, std::size_t tile) const;

    // The same in parts, for tiles that are run together.
    struct Ready {
        std::size_t tile = 0;
        std::shared_ptr<const Experiment> experiment;
        Snapshot initial;
        bool unstable = false;  // known before: it is not run
    };
    Ready ready(std::size_t tile) const;
    std::optional<std::string> run(Backend&, const Ready&) const;
    sweep::TileOptions course(const Ready&) const;
    // Writes the files of a tile that has run, and returns its row.
    std::string row(const Ready&, sweep::TileResult, double seconds) const;

    // Whether the files that the sheet and --format want are there; of arrays nothing is known here.
    bool has_files(std::size_t tile) const;
    // What the sheet shows of it; empty where it is not there, or damaged.
    std::optional<NpyArray> values_there(std::size_t tile) const;

private:
    std::filesystem::path values_of(std::size_t tile) const;
    // For messages: "tile 3 (K=0.05)".
    std::string name_of(std::size_t tile) const;
    template <class Work>  // does it; an error begins with that
    std::invoke_result_t<Work> named(std::size_t tile, Work work) const;
    Experiment read(const std::vector<Setting>&, const sweep::Point&) const;
    void keep(const Experiment&, std::size_t tile, const Snapshot&) const;

    const SweepOptions& options_;
    const SweepDesign& design_;
    const std::string& text_;
    const sweep::Table& table_;
    std::optional<double> steady_;
    std::filesystem::path folder_;  // of tiles
};

}  // namespace pelage::app
