// The program ffmpeg as a child process that makes a film of the frames it is given.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace pelage::app {

inline constexpr const char* no_ffmpeg =
    "films are made by the program ffmpeg, which is not installed (on Debian: apt-get install ffmpeg)";

// Whether there is a program of that name where programs are looked for.
bool on_path(const std::string& program);

class Ffmpeg {
public:
    // Starts it with these arguments. When it takes no frame and uses no processor for `patience` it hangs. Throws
    // Error where it is not installed.
    explicit Ffmpeg(std::vector<std::string> arguments, std::chrono::milliseconds patience = std::chrono::seconds(30));
    ~Ffmpeg();  // ends it when it still runs
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

    // Both throw Error, with the last that it said, when it has ended, hangs or fails.
    void write(const char* bytes, std::size_t count);
    void finish();  // no more frames: waits until all are in the film

    void stop() { stopped_ = true; }  // from another thread: what is under way throws soon

private:
    using Clock = std::chrono::steady_clock;

    void start(std::vector<std::string> arguments);
    void wait_for_input();
    void listen();
    void look_alive();
    bool ended();
    void end();
    void close_pipes();
    [[noreturn]] void complain(const std::string& what);

    std::chrono::milliseconds patience_;
    std::atomic<bool> stopped_ = false;
    pid_t child_ = -1;
    int input_ = -1;   // what it reads
    int errors_ = -1;  // what it says
    std::optional<int> status_;
    std::string words_;         // the last that it said
    double used_ = 0;           // of the processor, when it was last seen at work
    Clock::time_point active_;  // then
};

}  // namespace pelage::app
