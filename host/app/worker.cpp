// See worker.hpp.
#include "app/worker.hpp"

#include "app/processor_time.hpp"
#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace pelage::app {

namespace {

struct Pipe {
    std::array<int, 2> ends{-1, -1};  // to read, to write

    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0) {
            throw Error("no pipe to a child process can be made: " + system_reason(errno));
        }
    }
};

// The children that there are, for a signal handler; of more than these it does not know.
std::array<std::atomic<pid_t>, 64> children{};

void replace_child(pid_t before, pid_t after) {
    for (auto& child : children) {
        pid_t expected = before;
        if (child.compare_exchange_strong(expected, after)) return;
    }
}

}  // namespace

void kill_workers() {
    for (auto& child : children) {
        const pid_t id = child.exchange(0);
        if (id <= 0) continue;
        kill(id, SIGKILL);
        waitpid(id, nullptr, 0);
    }
}

Worker::Worker(std::vector<std::string> arguments) {
    // A child that dies must be noticed by what it does not answer, not by a signal to us.
    std::signal(SIGPIPE, SIG_IGN);
    const Pipe to;
    const Pipe from;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to.ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, from.ends[1], STDOUT_FILENO);
    std::string program = "/proc/self/exe";
    std::vector<char*> words{program.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    const int error = posix_spawn(&child_, program.c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(to.ends[0]);
    close(from.ends[1]);
    input_ = to.ends[1];
    output_ = from.ends[0];
    if (error != 0) {
        close_pipes();
        throw Error("no child process can be started: " + system_reason(error));
    }
    replace_child(0, child_);
}

Worker::~Worker() {
    if (child_ > 0 && waits_ && !ended_) let_go();
    if (child_ > 0) end();
}

// What it has compiled it keeps at its end, and takes its private folder with it.
void Worker::let_go() {
    constexpr auto patience = std::chrono::seconds(5);
    constexpr auto pause = std::chrono::milliseconds(1);
    close(std::exchange(input_, -1));  // no more lines
    const auto start = std::chrono::steady_clock::now();
    while (!ended_ && std::chrono::steady_clock::now() - start < patience) {
        const pid_t found = waitpid(child_, nullptr, WNOHANG);
        if (found == 0) std::this_thread::sleep_for(pause);
        ended_ = found != 0 && !(found < 0 && errno == EINTR);
    }
    if (!ended_) return;
    replace_child(child_, 0);
    child_ = -1;
    close_pipes();
}

void Worker::close_pipes() {
    if (input_ >= 0) close(input_);
    if (output_ >= 0) close(output_);
    input_ = output_ = -1;
}

void Worker::ask(const std::string& line) {
    asked_ = std::chrono::steady_clock::now();
    waits_ = false;
    const std::string text = line + "\n";
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t count = write(input_, text.data() + written, text.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return;  // it has ended: take() will say so
        written += static_cast<std::size_t>(count);
    }
}

std::optional<std::string> Worker::take() {
    std::array<char, 4096> piece{};
    const ssize_t count = read(output_, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) return {};
    if (count <= 0) {
        ended_ = true;
        return {};
    }
    buffer_.append(piece.data(), static_cast<std::size_t>(count));
    return next();
}

std::optional<std::string> Worker::next() {
    for (auto end = buffer_.find('\n'); end != std::string::npos; end = buffer_.find('\n')) {
        const std::string line = buffer_.substr(0, end);
        buffer_.erase(0, end + 1);
        const auto start = line.find(answer_mark);  // a driver may have left a line unfinished before it
        if (start == std::string::npos) continue;
        waits_ = true;
        return line.substr(start + std::strlen(answer_mark));
    }
    return {};
}

double Worker::processor_seconds() const { return app::processor_seconds(child_); }

std::string Worker::end() {
    close_pipes();
    if (!ended_) kill(child_, SIGKILL);
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    replace_child(child_, 0);
    child_ = -1;
    ended_ = true;
    if (WIFSIGNALED(status)) return fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
    return fmt::format("exit code {}", WEXITSTATUS(status));
}

}  // namespace pelage::app
