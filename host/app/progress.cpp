// See progress.hpp.
#include "app/progress.hpp"

#include "app/say.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pelage::app {

namespace {

constexpr std::chrono::milliseconds bar_pause{100};
constexpr std::chrono::seconds log_pause{10};

std::size_t terminal_width() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

}  // namespace

std::string megas(double updates_per_second) {
    const double value = updates_per_second / 1e6;
    if (value >= 100) return fmt::format("{:.0f}", value);
    return value >= 10 ? fmt::format("{:.1f}", value) : fmt::format("{:.2g}", value);
}

std::string clock_time(double seconds) {
    if (!std::isfinite(seconds) || seconds > 1e9) return "?";
    const auto whole = static_cast<std::uint64_t>(std::ceil(std::max(seconds, 0.0)));
    const auto minutes = whole / 60;
    if (minutes < 60) return fmt::format("{}:{:02}", minutes, whole % 60);
    return fmt::format("{}:{:02}:{:02}", minutes / 60, minutes % 60, whole % 60);
}

std::string progress_line(const std::string& phase, std::uint64_t iteration, std::uint64_t last, double seconds_left,
                          double updates_per_second, std::size_t width) {
    const double part = last == 0 ? 1.0 : static_cast<double>(iteration) / static_cast<double>(last);
    const std::string name = phase.empty() ? "" : phase + "  ";
    const std::string end = grouped(last);
    // A bar keeps its length while the numbers grow; a log needs no columns.
    const bool bars = width != 0;
    const std::string text =
        fmt::format("{:>{}}/{}  {:>{}.0f}%  ETA {:>{}}  {:>{}} M updates/s", grouped(iteration), bars ? end.size() : 0,
                    end, std::floor(100 * part), bars ? 3 : 0, clock_time(seconds_left), bars ? 8 : 0,
                    megas(updates_per_second), bars ? 5 : 0);
    constexpr std::size_t smallest_bar = 12;
    std::string bar;
    if (width > name.size() + text.size() + smallest_bar) {
        const std::size_t inside = std::min<std::size_t>(width - name.size() - text.size() - 5, 40);
        const auto done = static_cast<std::size_t>(part * static_cast<double>(inside));
        bar = fmt::format("[{}{}]  ", std::string(done, '#'), std::string(inside - done, '-'));
    }
    std::string line = name + bar + text;
    if (width != 0 && line.size() >= width) line.resize(width - 1);
    return line;
}

Progress::Style Progress::fitting_style(bool quiet) {
    if (quiet) return Style::silent;
    return isatty(STDERR_FILENO) != 0 ? Style::bar : Style::log;
}

Progress::Progress(Style style, std::uint64_t last) : style_(style), last_(last) {}

bool Progress::too_soon() const {
    const auto since = Clock::now() - shown_;
    return style_ == Style::bar ? since < bar_pause : since < log_pause;
}

// The first stretch is not judged by: most of it may be compilation.
double Progress::seconds_left(std::uint64_t iteration, Clock::time_point now) {
    if (!warm_) {
        warm_ = Warm{iteration, now};
        return INFINITY;
    }
    const auto done = static_cast<double>(iteration - warm_->iteration);
    const double seconds = std::chrono::duration<double>(now - warm_->time).count();
    return done > 0 ? seconds * static_cast<double>(last_ - iteration) / done : INFINITY;
}

void Progress::show(const std::string& phase, std::uint64_t iteration, double updates) {
    if (style_ == Style::silent || too_soon()) return;
    const auto now = shown_ = Clock::now();
    const bool bar = style_ == Style::bar;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = seconds_left(iteration, now);
    const std::string line =
        progress_line(phase, iteration, last_, left, updates / seconds, bar ? terminal_width() : 0);
    say(stderr, "{}{}{}", bar ? "\r\x1b[K" : "", line, bar ? "" : "\n");
    std::fflush(stderr);
    drawn_ = bar;
}

void Progress::writing(const std::string& file, bool large) {
    const bool bar = style_ == Style::bar;
    if (style_ == Style::silent || (!large && (!bar || too_soon()))) return;
    shown_ = Clock::now();
    say(stderr, "{}writing {}{}", bar ? "\r\x1b[K" : "", file, bar ? " ..." : "\n");
    std::fflush(stderr);
    drawn_ = bar;
}

void Progress::clear() {
    if (!drawn_) return;
    put(stderr, "\r\x1b[K");
    drawn_ = false;
}

}  // namespace pelage::app
