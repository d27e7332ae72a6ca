// See draw_report.hpp.
#include "app/draw_report.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <string>

#include <spawn.h>
#include <sys/wait.h>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace pelage::app {

namespace {

std::filesystem::path plotter() {
    std::error_code failure;
    return std::filesystem::read_symlink("/proc/self/exe", failure).parent_path() / "pelage-plot";
}

}  // namespace

bool plotter_is_there() { return std::filesystem::exists(plotter()); }

void require_plotter() {
    if (plotter_is_there()) return;
    throw Error(
        fmt::format("plots are drawn by '{}', which is not there: install cairo (libcairo2-dev) and build again",
                    plotter().string()));
}

void draw_report(const std::filesystem::path& json, const std::filesystem::path& picture) {
    std::string program = plotter().string();
    std::string from = json.string();
    std::string to = picture.string();
    const std::array<char*, 4> words{program.data(), from.data(), to.data(), nullptr};
    pid_t child = 0;
    const int error = posix_spawn(&child, program.c_str(), nullptr, nullptr, words.data(), environ);
    if (error != 0) throw Error(fmt::format("'{}' cannot be started: {}", program, system_reason(error)));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status != 0) throw Error(fmt::format("'{}' drew no pictures of '{}'", program, from));
}

}  // namespace pelage::app
