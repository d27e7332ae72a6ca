// See atomic_file.hpp.
#include "io/atomic_file.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"
#include "io/locked.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <set>
#include <system_error>

namespace pelage {

namespace fs = std::filesystem;

namespace {

constexpr const char* aside_beginning = ".pelage-";
constexpr const char* aside_ending = ".part";

// What programs that were killed have left there; once a folder is enough.
void tidy(const fs::path& folder) {
    static std::mutex guard;
    static std::set<fs::path>& tidied = *new std::set<fs::path>;  // never destroyed: files are written to the end
    {
        const std::lock_guard lock(guard);
        if (!tidied.insert(folder).second) return;
    }
    remove_left_over(folder, aside_beginning, aside_ending);
}

}  // namespace

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
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    tidy(folder);
    for (;;) {
        aside_ = folder / fmt::format("{}{}-{}{}", aside_beginning, getpid(), serial++, aside_ending);
        file_ = std::fopen(aside_.c_str(), "wbxe");
        if (file_ == nullptr && errno == EEXIST) continue;  // it was left by a program that was killed
        if (file_ == nullptr || lock_own(::fileno(file_), aside_)) return;
        std::fclose(file_);
    }
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
    if (count == 0) return;  // of an empty vector, whose data may be a null pointer
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
    const int lock = ::fcntl(::fileno(file_), F_DUPFD_CLOEXEC, 0);  // nobody tidies it up before it has its name
    std::FILE* const file = file_;
    file_ = nullptr;  // fclose ends the stream even when it fails
    const bool closed = std::fclose(file) == 0;
    const bool named = closed && (aside_.empty() || std::rename(aside_.c_str(), target_.c_str()) == 0);
    const int reason = errno;
    if (lock >= 0) ::close(lock);
    errno = reason;
    check(named);
}

void write_file(const fs::path& path, std::string_view text) {
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

}  // namespace pelage
