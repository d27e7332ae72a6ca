// Who runs which tile of a sweep, and where the rows of finished ones go: several threads, or several processes with
// several threads each.
#pragma once

#include "cluster/ranks.hpp"
#include "sweep/table.hpp"

#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace pelage::sweep {

// What the threads that run tiles see; any of them may call any of it at any time.
class Share {
public:
    Share() = default;
    virtual ~Share() = default;
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

    virtual std::optional<std::size_t> next() = 0;  // the tile to run; empty: there is no more to do
    virtual void finished(std::size_t tile, const std::string& row) = 0;
    // No further tile is handed out: a signal came, or something went wrong, which the exception tells.
    virtual void end(std::exception_ptr reason = nullptr) = 0;
};

// The one that has the table.
class Dealer : public Share {
public:
    // `there`: tiles that need not be run. `changed` is told after each row how many this sweep has run, with the
    // table locked.
    Dealer(Table&, std::size_t tiles, std::function<bool(std::size_t)> there, std::function<void(std::size_t)> changed);

    std::optional<std::size_t> next() override;
    void finished(std::size_t tile, const std::string& row) override;
    void end(std::exception_ptr reason) override;

    // Hands out tiles to the other ranks until all of them have left.
    void serve(cluster::Ranks&);

    std::size_t run() const { return run_; }
    bool ended() const { return ended_; }  // before all tiles were run
    std::exception_ptr failure() const { return failure_; }

private:
    void answer(cluster::Ranks&, const cluster::Message&, int& left);

    Table& table_;
    std::size_t tiles_, next_ = 0, run_ = 0;
    std::function<bool(std::size_t)> there_;
    std::function<void(std::size_t)> changed_;
    bool ended_ = false;
    std::exception_ptr failure_;
    std::mutex guard_;
};

// Asks the dealer, who is rank 0.
class Player : public Share {
public:
    explicit Player(cluster::Ranks& ranks) : ranks_(ranks) {}

    std::optional<std::size_t> next() override;
    void finished(std::size_t tile, const std::string& row) override;
    void end(std::exception_ptr reason) override;

    void leave();  // after the last thread; says what went wrong

private:
    cluster::Ranks& ranks_;
    bool ended_ = false, interrupted_ = false;
    std::string reason_;
    std::mutex guard_;
};

}  // namespace pelage::sweep
