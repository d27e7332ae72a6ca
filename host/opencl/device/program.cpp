// See program.hpp.
#include "opencl/device/program.hpp"

#include "opencl/device/cache.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/kept_handlers.hpp"
#include "opencl/device/kernel_sources.hpp"
#include "opencl/device/pocl.hpp"
#include "opencl/device/pocl_header.hpp"
#include "opencl/device/pocl_programs.hpp"
#include "opencl/device/program_log.hpp"
#include "opencl/device/schedule.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <new>
#include <optional>
#include <set>
#include <sstream>

namespace pelage {

namespace {

// Where the source of a failed build lies; says so if it could not be written.
std::string keep_source(const std::string& source) {
    std::error_code failure;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(failure);
    std::string path = (failure ? std::filesystem::path("/tmp") : folder) / "pelage-XXXXXX.cl";
    const int file = mkstemps(path.data(), 3);
    if (file < 0) return "(could not be written to " + path + ")";
    std::size_t written = 0;
    while (written < source.size()) {
        const ssize_t count = ::write(file, source.data() + written, source.size() - written);
        if (count <= 0) break;
        written += static_cast<std::size_t>(count);
    }
    ::close(file);
    return written == source.size() ? path : "(could not be written to " + path + ")";
}

[[noreturn]] void refuse(const Session& session, const cl::Program& program, const std::string& source,
                         const std::string& options, const cl::Error& error) {
    std::string log;
    try {
        log = program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(session.device());
    } catch (const cl::Error& no_log) {
        log = "(none: " + cl_error_name(no_log.err()) + ")";
    }
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
    throw Error(fmt::format(
        "device '{}' could not build a program ({})\n  driver:  {}\n  options: {}\n  source:  {}\n  log:\n{}",
        session.info().name, cl_error_name(error.err()), session.info().driver, options, keep_source(source), log));
}

// A compiler that ran out of memory may have left its locks behind: what a process does where `new` fails comes before
// any other call of the driver.
void told_of_missing_memory() {
    if (const std::new_handler handler = std::get_new_handler()) handler();
}

// Not cl::Program::build(), which asks for the log even of a program that was built.
void build(const Session& session, const cl::Program& program, const std::string& options) {
    const KeptHandlers handlers;
    const cl_device_id device = session.device()();
    const cl_int failure = clBuildProgram(program(), 1, &device, options.c_str(), nullptr, nullptr);
    if (failure == CL_OUT_OF_HOST_MEMORY) told_of_missing_memory();
    if (failure != CL_SUCCESS) throw cl::Error(failure, "clBuildProgram");
}

std::optional<cl::Program> from_brief_source(const Session& session, const std::string& source,
                                             const std::string& options) {
    const auto brief = without_header(session, source, options);
    if (!brief) return {};
    cl::Program program(session.context(), brief->source);
    try {
        build(session, program, brief->options);
    } catch (const cl::Error& error) {
        if (!header_may_help()) refuse(session, program, source, options, error);
        return {};
    }
    return program;
}

cl::Program from_source(const Session& session, const std::string& source, const std::string& options) {
    if (auto program = from_brief_source(session, source, options)) return std::move(*program);
    cl::Program program(session.context(), source);
    try {
        build(session, program, options);
    } catch (const cl::Error& error) {
        refuse(session, program, source, options, error);
    }
    return program;
}

std::optional<cl::Program> from_cache(const Session& session, const CacheKey& key, const std::string& options) {
    const auto binary = load_cached(cache_folder(), key);
    if (!binary) return {};
    try {
        cl::Program program(session.context(), {session.device()}, {*binary});
        build(session, program, options);
        return program;
    } catch (const cl::Error&) {
        return {};  // the driver no longer likes it: the source does
    }
}

void keep_binary(const cl::Program& program, const CacheKey& key) {
    try {
        const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
        if (!binaries.empty() && !binaries.front().empty()) store_cached(cache_folder(), key, binaries.front());
    } catch (const cl::Error&) {
        return;  // a driver without binaries: nothing to keep
    }
}

}  // namespace

const std::string& kernel_text(const std::string& name) {
    const auto found = kernel_sources().find(name);
    if (found == kernel_sources().end()) throw Error("there is no kernel file '" + name + "' in this build");
    log_kernel(name);
    return found->second;
}

Source& Source::file(const std::string& name) { return text(kernel_text(name)); }

Source& Source::file(const std::string& name, const std::map<std::string, std::string>& fills) {
    std::istringstream lines(kernel_text(name));
    std::set<std::string> filled;
    for (std::string line; std::getline(lines, line);) {
        const auto start = line.find_first_not_of(' ');
        if (start == std::string::npos || line.compare(start, 4, "//@ ") != 0) {
            text_ += line + "\n";
            continue;
        }
        const std::string key = line.substr(start + 4);
        const auto fill = fills.find(key);
        if (fill == fills.end())
            throw Error(fmt::format("kernel file '{}' asks for '{}', which is not given", name, key));
        text_ += fill->second;
        filled.insert(key);
    }
    for (const auto& [key, unused] : fills) {
        if (!filled.contains(key)) throw Error(fmt::format("kernel file '{}' has no place for '{}'", name, key));
    }
    return *this;
}

Source& Source::text(const std::string& emitted) {
    text_ += emitted;
    if (!text_.empty() && text_.back() != '\n') text_ += '\n';
    return *this;
}

CacheKey program_key(const Session& session, const std::string& plain, const std::string& options) {
    const DeviceInfo& info = session.info();
    const std::string source = scheduled(plain);
    const ProgramText text = without_header(session, source, options).value_or(ProgramText{source, options});
    return {text.source, text.options, info.name, info.version, info.driver, info.platform_version};
}

BuiltProgram build_program(const Session& session, const std::string& plain, const std::string& options) {
    const std::string source = scheduled(plain);
    log_program(source, options);
    return with_device(session.info().name, [&]() -> BuiltProgram {
        if (!session.options().use_cache) return {from_source(session, source, options)};
        const CacheKey key = program_key(session, plain, options);
        if (session.info().platform == pocl_platform && !session.options().cache_twice) {
            cl::Program program;
            const bool compiled =
                build_with_kept(session, key, [&] { program = from_source(session, source, options); });
            return {program, compiled};
        }
        if (auto program = from_cache(session, key, options)) return {std::move(*program), false};
        cl::Program program = from_source(session, source, options);
        keep_binary(program, key);
        return {program};
    });
}

}  // namespace pelage
