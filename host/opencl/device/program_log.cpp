// See program_log.hpp.
#include "opencl/device/program_log.hpp"

#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>

namespace pelage {

namespace {

std::optional<std::filesystem::path> log_folder() {
    const char* const name = std::getenv("PELAGE_PROGRAMS_LOG");
    if (name == nullptr) return {};
    return name;
}

void keep_once(const std::string& name, const std::string& text) {
    const std::filesystem::path file = *log_folder() / name;
    if (!std::filesystem::exists(file)) write_file(file, text);
}

}  // namespace

void log_program(const std::string& source, const std::string& options) {
    if (!log_folder()) return;
    const std::string text = "// " + options + "\n" + source;
    keep_once(fmt::format("{:016x}.cl", std::hash<std::string>{}(text)), text);
}

void log_launch(const cl::Kernel& kernel) {
    if (!log_folder()) return;
    std::string name = kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
    while (!name.empty() && name.back() == '\0') name.pop_back();
    keep_once(name + ".launched", "");
}

}  // namespace pelage
