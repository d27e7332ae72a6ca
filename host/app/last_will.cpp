// See last_will.hpp. In the handler only calls that are safe there: another program removes the folder.
#include "app/last_will.hpp"

#include "opencl/pocl.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace pelage::app {

namespace {

void remove_folder(const char* folder) {
    const pid_t child = _Fork();
    if (child == 0) {
        execl("/bin/rm", "rm", "-rf", "--", folder, static_cast<char*>(nullptr));
        _exit(127);
    }
    if (child > 0) waitpid(child, nullptr, 0);
}

extern "C" void end_tidily(int signal) {
    std::signal(signal, SIG_DFL);
    if (const char* folder = pocl_folder_name()) remove_folder(folder);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    raise(signal);
    _exit(128 + signal);  // the first process of a container does not end by signals
}

}  // namespace

void tidy_when_killed() {
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGILL, SIGABRT, SIGBUS, SIGSEGV, SIGALRM, SIGTERM, SIGXCPU}) {
        struct sigaction before {};
        if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
        struct sigaction action {};
        action.sa_handler = end_tidily;
        sigfillset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace pelage::app
