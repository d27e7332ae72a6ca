// See step_line.hpp.
#include "app/step_line.hpp"

#include "app/progress.hpp"
#include "app/say.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace pelage::app {

StepLine::StepLine(bool quiet, std::uint64_t last, std::uint64_t first)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), last_(last), first_(first) {}

void StepLine::show(std::uint64_t step, double loss) {
    const auto now = Clock::now();
    const std::chrono::duration<double> since = now - shown_;
    if (quiet_ || since.count() < (terminal_ ? 0.1 : 10.0)) return;
    shown_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double a_step = seconds / static_cast<double>(step - first_);
    const std::string told = std::isnan(loss) ? "none yet" : fmt::format("{:.4g}", loss);
    say(stderr, "{}step {} of {}  loss {}  {:.3g} s a step  ETA {}{}", terminal_ ? "\r\x1b[K" : "", grouped(step),
        grouped(last_), told, a_step, clock_time(a_step * static_cast<double>(last_ - step)), terminal_ ? "" : "\n");
    drawn_ = terminal_;
}

void StepLine::clear() {
    if (drawn_) say(stderr, "\r\x1b[K");
    drawn_ = false;
}

}  // namespace pelage::app
