// See process.hpp.
#include "support/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace test {

namespace {

constexpr std::chrono::minutes patience{2};
constexpr std::chrono::milliseconds pause{2};

// In the child, between fork and exec.
[[noreturn]] void become(const std::vector<std::string>& words, const Surroundings& surroundings,
                         const std::filesystem::path& folder) {
    const int in = open((folder / "in").c_str(), O_RDONLY);
    const int out = open((folder / "out").c_str(), O_WRONLY | O_CREAT, 0600);
    const int err = open((folder / "err").c_str(), O_WRONLY | O_CREAT, 0600);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    for (const auto& [name, value] : surroundings.environment) setenv(name.c_str(), value.c_str(), 1);
    if (!surroundings.folder.empty() && chdir(surroundings.folder.c_str()) != 0) _exit(126);
    if (surroundings.largest_file != 0) {
        const rlimit limit{surroundings.largest_file, surroundings.largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
        signal(SIGXFSZ, SIG_IGN);
    }
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

}  // namespace

Folder::Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "pelage-test-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
}

std::string read_all(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Child::Child(const std::vector<std::string>& words, const Surroundings& surroundings)
    : patience_(surroundings.patience) {
    (void)folder_.write("in", surroundings.input);
    id_ = fork();
    REQUIRE(id_ >= 0);
    if (id_ == 0) become(words, surroundings, folder_.path());
}

Child::~Child() {
    if (!running()) return;
    kill(id_, SIGKILL);
    waitpid(id_, &status_, 0);
}

bool Child::running() {
    if (!ended_) ended_ = waitpid(id_, &status_, WNOHANG) == id_;
    return !ended_;
}

void Child::signal(int number) const { kill(id_, number); }

Outcome Child::wait() {
    const auto end = std::chrono::steady_clock::now() + patience_;
    while (running()) {
        if (std::chrono::steady_clock::now() > end)
            FAIL("the command did not end; it said: " << read_all(folder_ / "err"));
        std::this_thread::sleep_for(pause);
    }
    const int exit_code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    return {exit_code, read_all(folder_ / "out"), read_all(folder_ / "err")};
}

Outcome command(std::vector<std::string> words, const Surroundings& surroundings) {
    words.insert(words.begin(), PELAGE_COMMAND);
    return Child(words, surroundings).wait();
}

Outcome shell(const std::string& line, const Surroundings& surroundings) {
    return Child({"sh", "-c", line}, surroundings).wait();
}

pid_t child_of(pid_t parent, const std::string& word) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
        for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
            std::ifstream status(entry.path() / "stat");  // "PID (NAME) STATE PARENT ..."
            std::string line;
            if (!std::getline(status, line)) continue;
            std::istringstream rest(line.substr(line.rfind(')') + 1));
            char state = 0;
            pid_t above = 0;
            if (!(rest >> state >> above) || above != parent) continue;
            // Before it has become another program, its parent cannot go on either.
            if (read_all(entry.path() / "cmdline").find(word) != std::string::npos) {
                return std::stoi(entry.path().filename());
            }
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return 0;
}

bool wait_for(const std::filesystem::path& file, Child& child) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!std::filesystem::exists(file)) {
        if (!child.running() || std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(pause);
    }
    return true;
}

}  // namespace test
