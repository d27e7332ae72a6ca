// See ffmpeg.hpp.
#include "app/ffmpeg.hpp"

#include "app/processor_time.hpp"
#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace pelage::app {

namespace {

constexpr std::size_t most_words = 400;  // that are told of what it said
constexpr int roomy_pipe = 1 << 20;      // bytes; the fewer waits for each other the better
constexpr int pause_ms = 100;

struct SpawnActions {
    SpawnActions() { posix_spawn_file_actions_init(&list); }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&list); }
    posix_spawn_file_actions_t list;
};

// In a group of its own: Ctrl-C is for us, who then end the film in order. No signal is blocked.
struct SpawnAttributes {
    SpawnAttributes() {
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_init(&list);
        posix_spawnattr_setflags(&list, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
        posix_spawnattr_setpgroup(&list, 0);
        posix_spawnattr_setsigmask(&list, &none);
    }
    ~SpawnAttributes() { posix_spawnattr_destroy(&list); }
    posix_spawnattr_t list;
};

std::array<int, 2> make_pipe() {
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error("no pipe to ffmpeg can be made: " + system_reason(errno));
    return ends;
}

}  // namespace

bool on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/bin:/usr/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / program;
        std::error_code ignored;
        if (!std::filesystem::is_directory(file, ignored) && access(file.c_str(), X_OK) == 0) return true;
    }
    return false;
}

Ffmpeg::Ffmpeg(std::vector<std::string> arguments, std::chrono::milliseconds patience)
    : patience_(patience), active_(Clock::now()) {
    if (!on_path("ffmpeg")) throw Error(no_ffmpeg);
    std::signal(SIGPIPE, SIG_IGN);
    start(std::move(arguments));
}

void Ffmpeg::start(std::vector<std::string> arguments) {
    const auto to = make_pipe();
    const auto from = make_pipe();
    SpawnActions actions;
    posix_spawn_file_actions_adddup2(&actions.list, to[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions.list, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions.list, from[1], STDERR_FILENO);
    const SpawnAttributes attributes;
    std::string program = "ffmpeg";
    std::vector<char*> words{program.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    const int error = posix_spawnp(&child_, program.c_str(), &actions.list, &attributes.list, words.data(), environ);
    close(to[0]);
    close(from[1]);
    input_ = to[1];
    errors_ = from[0];
    if (error != 0) {
        child_ = -1;
        close_pipes();
        throw Error("ffmpeg cannot be started: " + system_reason(error));
    }
    fcntl(input_, F_SETFL, O_NONBLOCK);
    fcntl(errors_, F_SETFL, O_NONBLOCK);
    fcntl(input_, F_SETPIPE_SZ, roomy_pipe);
}

Ffmpeg::~Ffmpeg() {
    if (child_ > 0 && !status_) end();
    close_pipes();
}

void Ffmpeg::close_pipes() {
    for (int* file : {&input_, &errors_}) {
        if (*file >= 0) close(std::exchange(*file, -1));
    }
}

void Ffmpeg::write(const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t written = ::write(input_, bytes, count);
        if (written > 0) {
            bytes += written;
            count -= static_cast<std::size_t>(written);
            active_ = Clock::now();
        } else if (written < 0 && errno == EINTR) {
            continue;
        } else if (written < 0 && errno != EAGAIN) {
            finish();
            complain("ended before the film did");
        } else {
            wait_for_input();
        }
    }
}

// Waits for a moment, and hears what it says meanwhile.
void Ffmpeg::wait_for_input() {
    std::array<pollfd, 2> files{pollfd{input_, POLLOUT, 0}, pollfd{errors_, POLLIN, 0}};
    poll(files.data(), files.size(), pause_ms);
    listen();
    look_alive();
}

void Ffmpeg::listen() {
    std::array<char, 4096> piece{};
    while (errors_ >= 0) {
        const ssize_t count = read(errors_, piece.data(), piece.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 && errno == EAGAIN) return;
        if (count <= 0) {
            close(std::exchange(errors_, -1));
            return;
        }
        words_.append(piece.data(), static_cast<std::size_t>(count));
        if (words_.size() > 2 * most_words) words_.erase(0, words_.size() - most_words);
    }
}

void Ffmpeg::look_alive() {
    if (stopped_) throw Error("it was given up");
    const double used = processor_seconds(child_);
    if (used != used_) {
        used_ = used;
        active_ = Clock::now();
    }
    if (Clock::now() - active_ < patience_) return;
    end();
    complain(fmt::format("did nothing for {} s and was ended",
                         std::chrono::duration_cast<std::chrono::duration<double>>(patience_).count()));
}

bool Ffmpeg::ended() {
    int status = 0;
    pid_t found = 0;
    while ((found = waitpid(child_, &status, WNOHANG)) < 0 && errno == EINTR) {
    }
    if (found == child_) status_ = status;
    return status_.has_value();
}

// With all that it has started itself.
void Ffmpeg::end() {
    kill(-child_, SIGKILL);
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    status_ = status;
}

void Ffmpeg::finish() {
    if (input_ >= 0) close(std::exchange(input_, -1));
    active_ = Clock::now();
    int pause = 1;
    while (!ended()) {
        pollfd file{errors_, POLLIN, 0};
        poll(&file, 1, pause);
        pause = std::min(2 * pause, pause_ms);
        listen();
        look_alive();
    }
    listen();
    if (WIFSIGNALED(*status_)) complain(fmt::format("was ended by signal {}", WTERMSIG(*status_)));
    if (WEXITSTATUS(*status_) != 0) complain(fmt::format("failed with exit code {}", WEXITSTATUS(*status_)));
    if (!words_.empty()) complain("came to its end, but not without errors");
}

void Ffmpeg::complain(const std::string& what) {
    std::string said = words_.substr(words_.size() - std::min(words_.size(), most_words));
    const auto last = said.find_last_not_of(" \t\r\n");
    said.erase(last == std::string::npos ? 0 : last + 1);
    for (char& c : said) {
        if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
    }
    throw Error(said.empty() ? fmt::format("ffmpeg {} and said nothing", what)
                             : fmt::format("ffmpeg {}; its last words were: {}", what, said));
}

}  // namespace pelage::app
