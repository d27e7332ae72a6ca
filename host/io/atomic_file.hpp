// A file that appears whole or not at all: written aside in the same folder, then renamed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace pelage {

// Every call throws Error naming the file and the system's reason (no such folder, full disk, ...); the file that was
// there before is then still there, and the half-written one is gone. A device or pipe ("/dev/stdout") is written
// straight, a symbolic link is followed.
class AtomicFile {
public:
    explicit AtomicFile(const std::filesystem::path&);
    ~AtomicFile();  // without commit(): nothing happened
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(const void* bytes, std::size_t count);
    void write(std::string_view text) { write(text.data(), text.size()); }
    void seek(std::uint64_t position);
    std::uint64_t position() const { return position_; }
    void sync();  // waits until the bytes are on the disk
    void commit();

    // What the first failed call threw, and every call after it throws again; empty: all is well.
    const std::string& failure() const { return failure_; }

    // Where it lies until commit(), for another program to write it; empty: there is no such place.
    const std::filesystem::path& aside() const { return aside_; }

private:
    void open_aside();
    void check_open() const;
    void check(bool good);  // throws when not, after removing what was written

    std::filesystem::path path_;    // as the caller named it
    std::filesystem::path target_;  // what is replaced in the end
    std::filesystem::path aside_;   // empty: target_ is written straight
    std::FILE* file_ = nullptr;
    std::uint64_t position_ = 0;
    std::string failure_;
};

void write_file(const std::filesystem::path&, std::string_view text);

}  // namespace pelage
