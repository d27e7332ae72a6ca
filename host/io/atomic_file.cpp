// See atomic_file.hpp.
#include "io/atomic_file.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <system_error>

namespace pelage {

namespace fs = std::filesystem;

AtomicFile::AtomicFile(const fs::path& path) : path_(path), target_(path) {
    std::error_code ignored;
    if (fs::is_symlink(path, ignored)) {
        const auto real = fs::weakly_canonical(path, ignored);
        if (!ignored) target_ = real;
    }
    const auto status = fs::status(target_, ignored);
    if (fs::is_directory(status)) throw Error(fmt::format("cannot write '{}': it is a folder", path_.string()));
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        file_ = std::fopen(target_.c_str(), "wb");
    } else {
        open_aside();
    }
    check(file_ != nullptr);
}

AtomicFile::~AtomicFile() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    std::error_code ignored;
    if (!aside_.empty()) fs::remove(aside_, ignored);
}

void AtomicFile::open_aside() {
    static std::atomic<unsigned> serial{0};
    do {  // a name may be left over from a program that was killed
        aside_ = target_.parent_path() / fmt::format(".pelage-{}-{}.part", getpid(), serial++);
        file_ = std::fopen(aside_.c_str(), "wbx");
    } while (file_ == nullptr && errno == EEXIST);
}

void AtomicFile::check(bool good) {
    if (good) return;
    const auto reason = system_reason(errno);
    std::error_code ignored;
    if (file_ != nullptr) std::fclose(file_);
    file_ = nullptr;
    if (!aside_.empty()) fs::remove(aside_, ignored);
    failure_ = fmt::format("cannot write '{}': {}", path_.string(), reason);
    throw Error(failure_);
}

void AtomicFile::check_open() const {
    if (!failure_.empty()) throw Error(failure_);
    if (file_ == nullptr) throw Error(fmt::format("cannot write '{}': it is closed", path_.string()));
}

void AtomicFile::write(const void* bytes, std::size_t count) {
    check_open();
    check(std::fwrite(bytes, 1, count, file_) == count);
    position_ += count;
}

void AtomicFile::seek(std::uint64_t position) {
    check_open();
    check(::fseeko(file_, static_cast<off_t>(position), SEEK_SET) == 0);
    position_ = position;
}

void AtomicFile::sync() {
    check_open();
    check(std::fflush(file_) == 0);
    // Devices and pipes know no fsync.
    check(aside_.empty() || ::fsync(::fileno(file_)) == 0);
}

void AtomicFile::commit() {
    check_open();
    check(std::fflush(file_) == 0);
    std::FILE* const file = file_;
    file_ = nullptr;  // fclose ends the stream even when it fails
    check(std::fclose(file) == 0);
    check(aside_.empty() || std::rename(aside_.c_str(), target_.c_str()) == 0);
}

void write_file(const fs::path& path, std::string_view text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

}  // namespace pelage
