// How far a run has come: a bar on a terminal, a line now and then in a log. Speaks on standard error.
#pragma once

#include "core/counted.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace pelage::app {

// "812", "5.2", "0.031": million cell-updates a second, three digits.
std::string megas(double updates_per_second);

// "0:42", "12:05", "3:07:00".
std::string clock_time(double seconds);

using pelage::counted;
using pelage::grouped;

class Progress {
public:
    enum class Style { silent, log, bar };

    // bar when standard error is a terminal, silent when told so.
    static Style fitting_style(bool quiet);

    Progress(Style, std::uint64_t last);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `updates`: cell updates since the start; shown at most ten times a second (bar) or every ten seconds (log).
    void show(const std::string& phase, std::uint64_t iteration, double updates);
    // A file is being written: shown when it is a large one, and on a terminal now and then any.
    void writing(const std::string& file, bool large);
    void clear();  // takes the bar away, so that other text can be printed

private:
    using Clock = std::chrono::steady_clock;

    struct Warm {  // the first moment that was shown
        std::uint64_t iteration = 0;
        Clock::time_point time;
    };

    bool too_soon() const;
    double seconds_left(std::uint64_t iteration, Clock::time_point now);

    Style style_;
    std::uint64_t last_;
    std::optional<Warm> warm_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_ = start_;
    bool drawn_ = false;
};

// One line of progress, at most `width` characters; 0: no bar, for a log.
std::string progress_line(const std::string& phase, std::uint64_t iteration, std::uint64_t last, double seconds_left,
                          double updates_per_second, std::size_t width);

}  // namespace pelage::app
