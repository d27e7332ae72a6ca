// See interrupt.hpp.
#include "app/interrupt.hpp"

#include "app/last_will.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>

namespace pelage::app {

namespace {

constexpr std::array<int, 4> signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

volatile std::sig_atomic_t mark = 0;
std::array<struct sigaction, signals.size()> before;
volatile std::sig_atomic_t waiting = 0;  // whether the alarm is ours
struct sigaction before_alarm;

constexpr unsigned patience = 3;  // seconds
constexpr char hint[] =
    "\npelage: stopping after what is being computed; Ctrl-C again ends at once, without a checkpoint\n";

extern "C" void tell_of_second(int) {
    const int error = errno;
    if (write(STDERR_FILENO, hint, sizeof hint - 1) < 0) errno = error;  // nobody reads it
    errno = error;
}

// Until a first Ctrl-C the alarm is whoever's it was: it ends the process where nobody else wants it.
void wait_for_alarm() {
    struct sigaction action {};
    action.sa_handler = tell_of_second;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    if (sigaction(SIGALRM, &action, &before_alarm) != 0) return;
    waiting = 1;
    alarm(patience);
}

extern "C" void set_mark(int signal) {
    mark = 1;
    if (signal == SIGXCPU) return;  // it comes again every second
    if (signal == SIGINT) wait_for_alarm();
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
    when_killed_say(nullptr);
}

Interrupt::~Interrupt() {
    if (waiting != 0) {
        alarm(0);
        sigaction(SIGALRM, &before_alarm, nullptr);
        waiting = 0;
    }
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before[i], nullptr);
}

bool Interrupt::came() { return mark != 0; }

}  // namespace pelage::app
