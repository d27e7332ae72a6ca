// Why results could not be written.
#pragma once

#include "core/error.hpp"

#include <new>
#include <string>

namespace pelage::app {

// Writes results; empty: they are written.
template <class Write>
std::string failure_of(Write write) {
    try {
        write();
        return {};
    } catch (const Error& error) {
        return error.what();
    } catch (const std::bad_alloc&) {
        return "there is not enough memory to write the results";
    }
}

}  // namespace pelage::app
