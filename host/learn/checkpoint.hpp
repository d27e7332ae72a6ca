// A training's state on disk, to the bit.
#pragma once

#include "learn/course.hpp"
#include "learn/settings.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace pelage::learn {

struct Identity {          // what makes two trainings one
    std::string settings;  // see settings.hpp
    std::string picture;   // SHA-256 of its file
    std::string backend;   // by its name
};

struct Saved {
    Identity identity;
    CourseState course;
    PoolStates pool;
};

// The file appears whole or not at all. Throws Error naming file and reason.
void write_saved(const std::filesystem::path&, const Identity&, const CourseState&, const PoolStates&);

// Throws Error when the file is no checkpoint of a training, damaged, or of another one than `now`: then saying what
// differs.
Saved read_saved(const std::filesystem::path&, const LearningShape&, const Identity& now);
Saved parse_saved(std::string_view bytes, const LearningShape&, const Identity& now, const std::string& name);

}  // namespace pelage::learn
