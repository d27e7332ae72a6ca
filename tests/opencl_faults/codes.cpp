// See codes.hpp.
#include "codes.hpp"

#include "opencl/device/cl_error.hpp"

namespace test {

const std::vector<cl_int>& standard_codes() {
    static const std::vector<cl_int> codes = [] {
        std::vector<cl_int> all;
        for (cl_int code = -1; code >= -19; --code) all.push_back(code);
        for (cl_int code = -30; code >= -68; --code) all.push_back(code);
        all.push_back(-1001);
        return all;
    }();
    return codes;
}

bool tells(const std::string& sentence, const std::string& name, cl_int code) {
    const auto says = [&](const std::string& words) { return sentence.find(words) != std::string::npos; };
    const bool of_machine = name == "clGetPlatformIDs" || name == "clGetPlatformInfo" || name == "clGetDeviceIDs";
    if (code == -1001 && name == "clGetPlatformIDs") return says("no OpenCL device is there");
    if (code == CL_DEVICE_NOT_FOUND && name == "clGetDeviceIDs") return says("no OpenCL device is there");
    return says(pelage::cl_error_name(code)) && (of_machine || says("device"));
}

}  // namespace test
