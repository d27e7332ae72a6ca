// A run's state on disk, to the bit, and what is needed to go on with it.
#pragma once

#include "core/snapshot.hpp"
#include "core/tissue.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace pelage {

struct CheckpointInfo {
    std::string experiment;  // whole text
    std::string source;      // its file's name
    std::string folder;      // where that lies: pictures named in the text are relative to it
    Precision precision = Precision::single_;
    std::int64_t seed = 1;
    std::string backend;
    std::string device;
    std::string version;  // of the program that wrote it

    bool operator==(const CheckpointInfo&) const = default;
};

struct Checkpoint {
    Snapshot snapshot;
    CheckpointInfo info;
};

// The file appears whole or not at all, and is on the disk when this returns. Throws Error naming file and reason.
void write_checkpoint(const std::filesystem::path&, const Snapshot&, const CheckpointInfo&);

// Throws Error when the file is not a checkpoint, newer than this program knows, truncated, or corrupted.
Checkpoint read_checkpoint(const std::filesystem::path&);
Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name);  // the same from memory

}  // namespace pelage
