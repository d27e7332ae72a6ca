// `pelage learn`: from the command line to a trained network and what lies beside it.
#pragma once

#include "learn/settings.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace pelage::app {

struct LearnOptions {
    std::filesystem::path picture;
    std::filesystem::path out;  // empty: the picture's name with .npz
    learn::Settings settings;
    std::uint64_t preview_every = 100;
    std::uint64_t checkpoint_every = 1000;
    bool resume = false;
    std::string backend;  // empty: OpenCL where a device is usable, else the reference
    std::string device;   // empty: the best that is there
    bool quiet = false;
};

int learn_texture(const LearnOptions&);

}  // namespace pelage::app
