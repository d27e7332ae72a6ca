// What the tests of files share: a folder of their own, small tissues, bytes.
#pragma once

#include "core/experiment.hpp"
#include "core/snapshot.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace test {

// A fresh folder that goes when the test ends.
class Scratch {
public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    const std::filesystem::path& folder() const { return folder_; }
    std::vector<std::string> names() const;  // of the files in it, hidden ones too, in order

private:
    std::filesystem::path folder_;
};

// Files cannot grow past `bytes` while it lives: writing further fails as on a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(std::size_t bytes);
    ~FileSizeLimit();
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    unsigned long before_;
};

void put(const std::filesystem::path&, std::string_view bytes);
std::string get(const std::filesystem::path&);

// The text of the Error that the call throws; empty when it throws none.
std::string error_of(const std::function<void()>&);

// Counts the beginnings of `bytes`, and the texts with one byte changed, that `parse` takes without an Error.
// Other exceptions pass through.
std::size_t accepted_beginnings(std::string_view bytes, const std::function<void(std::string_view)>& parse);
std::size_t accepted_changes(std::string_view bytes, const std::function<void(std::string_view)>& parse);

// Two chemicals, U and V, whose values differ everywhere.
pelage::Experiment experiment();
pelage::Snapshot lattice(std::size_t columns, std::size_t rows);
pelage::Snapshot cells(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace test
