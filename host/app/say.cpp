// See say.hpp.
#include "app/say.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <initializer_list>

namespace pelage::app {

namespace {

int failure = 0;  // what errno said when standard output could not be written

void note(std::FILE* where, bool good) {
    if (!good && where == stdout && failure == 0) failure = errno;
}

}  // namespace

void put(std::FILE* where, const std::string& text) {
    note(where, std::fwrite(text.data(), 1, text.size(), where) == text.size());
    if (where == stderr) std::fflush(where);
}

void prepare_printing() {
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(file, F_GETFD) >= 0 || errno != EBADF) continue;
        // The lowest number that is free is this one. Opened the other way round: using it still fails.
        if (open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void send() { note(stdout, std::fflush(stdout) == 0); }

bool printed() {
    send();
    return failure == 0 || failure == EPIPE;
}

}  // namespace pelage::app
