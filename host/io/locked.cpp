// See locked.hpp.
#include "io/locked.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <system_error>
#include <vector>

namespace pelage {

namespace fs = std::filesystem;

namespace {

bool lies_at(int file, const fs::path& path) {
    struct stat own {};
    struct stat there {};
    return fstat(file, &own) == 0 && lstat(path.c_str(), &there) == 0 && own.st_ino == there.st_ino &&
           own.st_dev == there.st_dev;
}

bool named(const std::string& name, const std::string& beginning, const std::string& ending) {
    return name.size() >= beginning.size() + ending.size() && name.rfind(beginning, 0) == 0 &&
           name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

void remove_unlocked(const fs::path& path) {
    const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return;
    struct stat status {};
    const bool ours =
        fstat(file, &status) == 0 && status.st_uid == geteuid() && (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode));
    std::error_code ignored;
    if (ours && flock(file, LOCK_EX | LOCK_NB) == 0 && lies_at(file, path)) fs::remove_all(path, ignored);
    close(file);
}

// " (1234)", as the owner of a lock wrote it; empty: it has not yet.
std::string owner_of(int file) {
    std::array<char, 16> text{};
    const ssize_t count = pread(file, text.data(), text.size(), 0);
    long process = 0;
    if (count <= 0) return {};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + count, process);
    return failure == std::errc{} && process > 0 ? fmt::format(" ({})", process) : std::string();
}

}  // namespace

bool lock_own(int file, const fs::path& path) {
    while (flock(file, LOCK_EX) != 0 && errno == EINTR) {
    }
    return lies_at(file, path);
}

void remove_left_over(const fs::path& folder, const std::string& beginning, const std::string& ending) {
    std::error_code failure;
    std::vector<fs::path> found;
    fs::directory_iterator at(folder, failure);
    for (; !failure && at != fs::directory_iterator(); at.increment(failure)) {
        if (named(at->path().filename().string(), beginning, ending)) found.push_back(at->path());
    }
    for (const fs::path& path : found) remove_unlocked(path);
}

PrivateFolder::PrivateFolder(const fs::path& parent, const std::string& beginning) : owner_(getpid()) {
    for (;;) {
        std::string pattern = (parent / (beginning + "XXXXXX")).string();
        if (mkdtemp(pattern.data()) == nullptr) {
            throw Error(fmt::format("no folder can be made in '{}': {}", parent.string(), system_reason(errno)));
        }
        path_ = pattern;
        lock_ = open(pattern.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock_ < 0 && errno == ENOENT) continue;  // somebody who tidies up was quicker
        if (lock_ < 0 || lock_own(lock_, path_)) return;
        close(lock_);
    }
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored;
    if (owner_ == getpid()) fs::remove_all(path_, ignored);
    if (lock_ >= 0) close(lock_);
}

FileLock::FileLock(const fs::path& file, const std::string& deed) : path_(file), owner_(getpid()) {
    while (!take(deed)) {
    }
}

bool FileLock::take(const std::string& deed) {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file_ < 0) throw Error(fmt::format("'{}' cannot be made: {}", path_.string(), system_reason(errno)));
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK) return true;
        const std::string owner = owner_of(file_);
        close(file_);
        throw Error(fmt::format("another process{} {} at this moment; name another file", owner, deed));
    }
    if (!lies_at(file_, path_)) {
        close(file_);
        return false;
    }
    const std::string own = fmt::format("{}\n", owner_);
    if (ftruncate(file_, 0) != 0 || write(file_, own.data(), own.size()) < 0) return true;  // the lock counts, not this
    return true;
}

FileLock::~FileLock() {
    std::error_code ignored;
    if (owner_ == getpid()) fs::remove(path_, ignored);
    close(file_);
}

FolderLock::FolderLock(const fs::path& folder) : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    close(file_);
    throw Error(fmt::format("another run writes into the folder {} at this moment; give this one its own with --out",
                            folder.string()));
}

FolderLock::~FolderLock() {
    if (file_ >= 0) close(file_);
}

}  // namespace pelage
