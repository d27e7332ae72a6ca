// A child process that is given lines and answers each with one line: what it does may crash or hang.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace pelage::app {

// Answers are the lines of the child's standard output that begin with this: drivers may print there too.
inline constexpr const char* answer_mark = "pelage-answer ";

// Kills the children of all workers and waits until they are gone. A signal handler may call it.
void kill_workers();

class Worker {
public:
    explicit Worker(std::vector<std::string> arguments);  // of this same program
    ~Worker();                                            // a child that has answered is let go by itself
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void ask(const std::string& line);  // the answer to the one before must have come

    int output() const { return output_; }  // file descriptor, to wait for
    double processor_seconds() const;       // that the child has had
    std::chrono::steady_clock::time_point asked() const { return asked_; }

    // To be called when output() can be read: the answer, or nothing yet. Sets ended() when the child is no more.
    std::optional<std::string> take();
    std::optional<std::string> next();  // another answer that came with the one before
    void is_busy() { waits_ = false; }  // that answer was not the last one to what was asked
    bool ended() const { return ended_; }

    // Kills the child and tells how it ended: "signal 11 (Segmentation fault)", "exit code 3".
    std::string end();

private:
    void close_pipes();
    void let_go();

    pid_t child_ = -1;
    int input_ = -1;
    int output_ = -1;
    bool ended_ = false;
    bool waits_ = true;  // for the next line: nothing asked is unanswered
    std::string buffer_;
    std::chrono::steady_clock::time_point asked_;
};

}  // namespace pelage::app
