// A film of a run: frames are drawn, and given to ffmpeg, in a thread beside the simulation.
#pragma once

#include "app/ffmpeg.hpp"
#include "app/film_painter.hpp"
#include "app/film_plan.hpp"
#include "core/tissue.hpp"
#include "io/atomic_file.hpp"
#include "io/draw_cells.hpp"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace pelage::app {

class Film {
public:
    // Begins with the tissue's state as it is. Throws Error when the file cannot be begun or ffmpeg is not there.
    Film(FilmPlan, const Tissue&, const CellDrawing&);
    ~Film();  // without end(): there is no film
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    const FilmPlan& plan() const { return plan_; }

    // Films the tissue's state; waits while too many frames are still to be drawn. After a failure it does nothing.
    void take(const Tissue&);

    // What went wrong, in a sentence; empty: nothing.
    std::string failure() const;

    // All frames are drawn and the film gets its name. Throws Error when it could not be made.
    void end();

    std::uint64_t frames() const { return frames_; }  // so far
    double waited() const { return waited_; }         // seconds, by take()

    static double bytes(const FilmPlan&, const Experiment&, double cells);  // of memory

private:
    void draw_all();  // the other thread
    std::optional<Shot> next_shot();
    void fail(const std::string& reason);
    void close();

    FilmPlan plan_;
    const Experiment& experiment_;
    std::size_t most_;  // shots that wait to be drawn
    AtomicFile file_;
    std::uint64_t frames_ = 0;
    double waited_ = 0;

    mutable std::mutex lock_;  // of what follows
    std::condition_variable changed_;
    std::vector<Shot> waiting_;  // first comes first
    std::vector<Shot> used_;     // for their memory
    bool closed_ = false;
    std::string failure_;

    std::optional<FilmPainter> painter_;  // the thread's alone, like what follows
    std::string bytes_;
    std::optional<Ffmpeg> ffmpeg_;
    std::thread thread_;
};

}  // namespace pelage::app
