// See locked.hpp.
#include "io/locked.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
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
        if (lock_ < 0 || lock_own(lock_, path_)) return;
        close(lock_);
    }
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored;
    if (owner_ == getpid()) fs::remove_all(path_, ignored);
    if (lock_ >= 0) close(lock_);
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
