// See tile_batches.hpp.
#include "app/tile_batches.hpp"

#include "core/error.hpp"
#include "sweep/tile.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <span>
#include <utility>

namespace pelage::app {

namespace {

using Tiles = std::vector<TileRunner::Ready>;

class Together {
public:
    Together(const TileRunner& runner, OpenclBackend& backend, const FinishedTile& finished)
        : runner_(runner), backend_(backend), finished_(finished) {}

    bool run(Tiles tiles) const {
        const std::size_t room = backend_.batch_room(*tiles[0].experiment, tiles[0].initial);
        for (std::size_t begin = 0; begin < tiles.size(); begin += std::max<std::size_t>(room, 1)) {
            const std::size_t count = std::min(std::max<std::size_t>(room, 1), tiles.size() - begin);
            if (!run_some(std::span(tiles).subspan(begin, count))) return false;
        }
        return true;
    }

    bool alone(const TileRunner::Ready& tile) const {
        const auto row = runner_.run(backend_, tile);
        if (row) finished_(tile.tile, *row);
        return row.has_value();
    }

private:
    // Where others have taken the device's memory, half of them may still fit.
    bool run_some(std::span<TileRunner::Ready> tiles) const {
        if (tiles.size() == 1) return alone(tiles[0]);
        std::unique_ptr<Batch> batch;
        const auto start = std::chrono::steady_clock::now();
        try {
            batch = backend_.make_batch(starts_of(tiles));
        } catch (const Error&) {
            const std::size_t half = tiles.size() / 2;
            return run_some(tiles.first(half)) && run_some(tiles.subspan(half));
        }
        std::vector<const Experiment*> experiments;
        for (TileRunner::Ready& tile : tiles) {
            experiments.push_back(tile.experiment.get());
            tile.initial = {};  // the device has it
        }
        const auto tell = [&](std::size_t member, sweep::TileResult result) {
            const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            const double share = spent / static_cast<double>(tiles.size());
            finished_(tiles[member].tile, runner_.row(tiles[member], std::move(result), share));
        };
        return sweep::run_tiles(*batch, experiments, runner_.course(tiles[0]), tell);
    }

    static std::vector<BatchStart> starts_of(std::span<const TileRunner::Ready> tiles) {
        std::vector<BatchStart> starts;
        for (const TileRunner::Ready& tile : tiles) starts.push_back({tile.experiment, tile.initial});
        return starts;
    }

    const TileRunner& runner_;
    OpenclBackend& backend_;
    const FinishedTile& finished_;
};

}  // namespace

std::size_t tiles_a_batch(const Footprint& tile, std::uint64_t last, std::size_t tiles, std::size_t jobs,
                          double memory) {
    constexpr double cells_that_fill = 1 << 20;  // a card, with the batches of other threads
    constexpr double updates = 1e12;             // a card does 10^11 in a second, of all threads
    constexpr double states = 4.0, part = 0.25;  // of each tile, held by who looks at them; of the memory
    const auto threads = static_cast<double>(jobs);
    const double by_work = updates / (tile.cells * static_cast<double>(std::max<std::uint64_t>(last, 1)));
    const double by_memory = part * memory / (threads * states * tile.a_snapshot * tile.cells);
    const double most = std::min({cells_that_fill / tile.cells, by_work, by_memory});
    const std::size_t fair = (tiles + jobs - 1) / jobs;  // so that each thread has some
    return std::max<std::size_t>(1, std::min(fair, static_cast<std::size_t>(std::max(most, 0.0))));
}

bool run_together(const TileRunner& runner, OpenclBackend& backend, const std::vector<std::size_t>& tiles,
                  const FinishedTile& finished) {
    const Together together(runner, backend, finished);
    std::map<std::pair<std::uint64_t, std::string>, Tiles> groups;  // by end and structure
    for (const std::size_t tile : tiles) {
        TileRunner::Ready ready = runner.ready(tile);
        const std::string structure = ready.unstable ? "" : backend.structure(*ready.experiment, ready.initial);
        if (!structure.empty())
            groups[{runner.last_iteration(*ready.experiment), structure}].push_back(std::move(ready));
        else if (!together.alone(ready))
            return false;
    }
    for (auto& [key, group] : groups) {
        if (!together.run(std::move(group))) return false;
    }
    return true;
}

}  // namespace pelage::app
