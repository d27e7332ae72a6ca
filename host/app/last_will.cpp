// See last_will.hpp. In the handler only calls that are safe there: another program removes the folder.
#include "app/last_will.hpp"

#include "app/commands.hpp"
#include "app/worker.hpp"
#include "core/allowance.hpp"
#include "opencl/device/device.hpp"
#include "opencl/device/pocl.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>

namespace pelage::app {

namespace {

constexpr std::array requests{SIGHUP, SIGINT, SIGQUIT, SIGALRM, SIGTERM, SIGXCPU};
constexpr std::array crashes{SIGILL, SIGABRT, SIGBUS, SIGSEGV};

// Made in the beginning: there may be no memory to make them when they are needed.
struct LastWords {
    std::string on_crash;  // empty: nothing is to be said
    std::string without_memory;
};
const LastWords* last_words = nullptr;

std::atomic<const char*> parting_words = nullptr;  // of a process that is asked to end
std::atomic<const char*> doomed_file = nullptr;
std::atomic_flag ending = ATOMIC_FLAG_INIT;

void remove_folder(const char* folder) {
    const pid_t child = _Fork();
    if (child == 0) {
        execl("/bin/rm", "rm", "-rf", "--", folder, static_cast<char*>(nullptr));
        _exit(127);
    }
    if (child > 0) waitpid(child, nullptr, 0);
}

// The first thread alone ends the process. Others may run on into what is being removed: nobody hears their complaints.
// Children compile in folders within ours, and have the standard error that we had: they go first.
void put_in_order(std::string_view words) {
    while (ending.test_and_set()) pause();
    if (!words.empty()) (void)!write(STDERR_FILENO, words.data(), words.size());
    if (const char* file = doomed_file.load()) unlink(file);
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nothing >= 0) dup2(nothing, STDERR_FILENO);
    kill_workers();
    if (const char* folder = pocl_folder_name()) remove_folder(folder);
}

bool is_crash(int signal) { return std::ranges::find(crashes, signal) != crashes.end(); }

extern "C" void end_tidily(int signal);

void handle(int signal) {
    struct sigaction action {};
    action.sa_handler = end_tidily;
    sigfillset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

void end_tidily(int signal) {
    if (!is_crash(signal)) {
        for (const int crash : crashes) handle(crash);  // of other threads; a driver may have put its own there
    }
    const bool short_of_memory = is_crash(signal) && !last_words->on_crash.empty() && drivers_started();
    const char* parting = is_crash(signal) ? nullptr : parting_words.load();
    if (short_of_memory)
        put_in_order(last_words->on_crash);
    else
        put_in_order(parting == nullptr ? std::string_view() : std::string_view(parting));
    if (short_of_memory) _exit(bad_input);
    std::signal(signal, SIG_DFL);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    raise(signal);
    _exit(128 + signal);  // the first process of a container does not end by signals
}

// An exception that passes through a driver leaves it with its locks taken, and whatever lets go of the driver's
// objects then waits for ever.
void end_without_memory() {
    if (!drivers_started()) throw std::bad_alloc();
    put_in_order(last_words->without_memory);
    _exit(bad_input);
}

LastWords words_for(const std::optional<ProcessLimit>& limit) {
    if (!limit) return {"", "pelage: out of memory\n"};
    const std::string allowed =
        fmt::format("this process may take {:.0f} MiB ({})\n", limit->bytes / (1 << 20), limit->option);
    return {"pelage: an OpenCL driver broke down, perhaps for want of memory: " + allowed,
            "pelage: out of memory: " + allowed};
}

}  // namespace

void tidy_when_killed() {
    if (last_words == nullptr) last_words = new LastWords(words_for(process_limit()));  // needed to the very end
    const auto unless_chosen = [](int signal) {
        struct sigaction before {};
        if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL) handle(signal);
    };
    std::ranges::for_each(requests, unless_chosen);
    std::ranges::for_each(crashes, unless_chosen);
    std::set_new_handler(end_without_memory);
}

void when_killed_say(const char* words) { parting_words = words; }

void when_killed_remove(const char* file) { doomed_file = file; }

void keep_ignored() {
    sigset_t ignored;
    sigemptyset(&ignored);
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGPIPE, SIGXFSZ, SIGXCPU}) {
        struct sigaction found {};
        if (sigaction(signal, nullptr, &found) == 0 && found.sa_handler == SIG_IGN) sigaddset(&ignored, signal);
    }
    pthread_sigmask(SIG_BLOCK, &ignored, nullptr);
}

void end_with_parent() {
    const pid_t parent = getppid();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) raise(SIGTERM);
}

}  // namespace pelage::app
