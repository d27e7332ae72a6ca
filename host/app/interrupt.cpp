// See interrupt.hpp.
#include "app/interrupt.hpp"

#include <array>
#include <csignal>
#include <cstddef>

namespace pelage::app {

namespace {

constexpr std::array<int, 4> signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

volatile std::sig_atomic_t mark = 0;
std::array<struct sigaction, signals.size()> before;

extern "C" void set_mark(int signal) {
    mark = 1;
    if (signal == SIGXCPU) return;  // it comes again every second
    for (std::size_t i = 0; i < signals.size(); ++i) {
        if (signals[i] == signal) sigaction(signal, &before[i], nullptr);
    }
}

}  // namespace

Interrupt::Interrupt() {
    mark = 0;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before[i]);
        if (before[i].sa_handler == SIG_IGN) continue;  // as nohup wants it, or a shell for what runs behind
        struct sigaction action {};
        action.sa_handler = set_mark;
        action.sa_flags = SA_RESTART;
        sigemptyset(&action.sa_mask);
        sigaction(signals[i], &action, nullptr);
    }
}

Interrupt::~Interrupt() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before[i], nullptr);
}

bool Interrupt::came() { return mark != 0; }

}  // namespace pelage::app
