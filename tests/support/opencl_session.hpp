// One OpenCL session a precision, shared by the tests of free cells.
#pragma once

#include "opencl/device/device.hpp"
#include "opencl/device/session.hpp"

namespace test {

inline const pelage::Session& session(pelage::Precision precision = pelage::Precision::single_) {
    using namespace pelage;
    const auto open = [](Precision wanted) {
        OpenclOptions options;
        options.precision = wanted;
        return Session(select_device(), options);
    };
    if (precision == Precision::double_) {
        static const Session of_double = open(Precision::double_);
        return of_double;
    }
    static const Session of_single = open(Precision::single_);
    return of_single;
}

}  // namespace test
