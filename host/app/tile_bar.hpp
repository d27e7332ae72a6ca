// How many tiles of a sweep are done: a line on a terminal that the next one replaces.
#pragma once

#include "app/progress.hpp"
#include "app/say.hpp"

#include <unistd.h>

#include <cstddef>
#include <cstdio>

namespace pelage::app {

class TileBar {
public:
    explicit TileBar(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}
    ~TileBar() { clear(); }
    TileBar(const TileBar&) = delete;
    TileBar& operator=(const TileBar&) = delete;

    void show(std::size_t done, std::size_t all, double seconds_a_tile) const {
        if (!shown_) return;
        say(stderr, "\r\x1b[Ktile {} of {}, {} left", grouped(done), grouped(all),
            clock_time(seconds_a_tile * static_cast<double>(all - done)));
    }
    void clear() const {
        if (shown_) say(stderr, "\r\x1b[K");
    }

private:
    bool shown_;
};

}  // namespace pelage::app
