// Drivers put signal handlers of their own in place of the application's (LLVM does so for all that end a process).
#pragma once

#include <array>
#include <csignal>

namespace pelage {

// While one lives, drivers may set handlers; in the end those from before are back.
class KeptHandlers {
public:
    KeptHandlers();
    ~KeptHandlers();
    KeptHandlers(const KeptHandlers&) = delete;
    KeptHandlers& operator=(const KeptHandlers&) = delete;

private:
    static constexpr std::array signals{SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP, SIGABRT, SIGBUS,  SIGFPE, SIGUSR1,
                                        SIGSEGV, SIGUSR2, SIGPIPE, SIGALRM, SIGTERM, SIGXCPU, SIGXFSZ, SIGSYS};
    std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace pelage
