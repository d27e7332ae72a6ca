// See interrupt.hpp.
#include "app/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace pelage::app {

namespace {

volatile std::sig_atomic_t mark = 0;

extern "C" void set_mark(int) { mark = 1; }

void handle(int signal, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
    mark = 0;
    for (const int signal : {SIGINT, SIGTERM}) handle(signal, set_mark, static_cast<int>(SA_RESETHAND) | SA_RESTART);
}

Interrupt::~Interrupt() {
    for (const int signal : {SIGINT, SIGTERM}) handle(signal, SIG_DFL, 0);
}

bool Interrupt::came() { return mark != 0; }

}  // namespace pelage::app
