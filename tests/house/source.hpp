// Where the sources of the house stand.
#pragma once

#include <filesystem>

inline const std::filesystem::path source = PELAGE_SOURCE;
