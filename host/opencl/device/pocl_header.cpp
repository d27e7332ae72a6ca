// See pocl_header.hpp. The header leaves out what it declares where its guard is defined already; macros and types come
// from another one.
#include "opencl/device/pocl_header.hpp"

#include "opencl/device/pocl.hpp"
#include "opencl/device/program.hpp"

#include <cstdlib>
#include <string_view>

namespace pelage {

namespace {

std::string_view wanted() {
    const char* const value = std::getenv("PELAGE_POCL_HEADER");
    return value == nullptr ? "" : value;
}

}  // namespace

std::optional<ProgramText> without_header(const Session& session, const std::string& source,
                                          const std::string& options) {
    const DeviceInfo& info = session.info();
    if (info.platform != pocl_platform || !info.processor() || wanted() == "always") return {};
    return ProgramText{kernel_text("pocl/builtins.cl") + "#line 1\n" + source, options + " -D_OPENCL_H_"};
}

bool header_may_help() { return wanted() != "never"; }

}  // namespace pelage
