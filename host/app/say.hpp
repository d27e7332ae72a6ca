// Printing that never ends a run: what cannot be printed is lost, and nothing else.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace pelage::app {

void put(std::FILE* where, const std::string& text);

template <class... Words>
void say(std::FILE* where, fmt::format_string<Words...> format, Words&&... words) {
    put(where, fmt::format(format, std::forward<Words>(words)...));
}

// On standard output.
template <class... Words>
void say(fmt::format_string<Words...> format, Words&&... words) {
    put(stdout, fmt::format(format, std::forward<Words>(words)...));
}

// What was said on standard output leaves now, before what is said elsewhere.
void send();

// To be called first of all. Standard files that are closed are opened on nothing, so that no result gets their number
// and messages in it; and what is written to a closed pipe, or past the limit on file sizes, is an error of that call.
void prepare_printing();

// Whether all that was printed on standard output has arrived, or its reader has seen enough.
bool printed();

}  // namespace pelage::app
