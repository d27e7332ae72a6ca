// Files and folders that belong to a living process: it holds a lock on them, which ends with it however it ends.
#pragma once

#include <filesystem>
#include <string>

namespace pelage {

// Takes the lock on what is open as `file` and says whether it still lies at `path`: somebody who tidies up may have
// come between its making and its locking. Where the file system knows no locks, nobody tidies up.
bool lock_own(int file, const std::filesystem::path& path);

// Removes what lies in `folder` under a name that begins and ends so, is ours and is no longer locked: it was left by
// a process that was killed. What cannot be removed stays.
void remove_left_over(const std::filesystem::path& folder, const std::string& beginning, const std::string& ending);

// A folder for this process alone, gone with all it holds when the object goes; after a kill it goes with the next
// remove_left_over().
class PrivateFolder {
public:
    // A new folder in `parent`, its name beginning so. Throws Error naming the system's reason.
    PrivateFolder(const std::filesystem::path& parent, const std::string& beginning);
    ~PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    int lock_ = -1;
    int owner_;  // a process: a copy of it that forked must not remove the folder
};

// While one lives, no other process can have one for the same file, which is made for it and goes with it. A process
// that is killed leaves the file, but no lock. Where the file system knows no locks, everybody can.
class FileLock {
public:
    // `deed`: what the one who has it does, for the message: "another process (1234) DEED at this moment". Throws Error
    // where another process has it, or the file cannot be made.
    FileLock(const std::filesystem::path& file, const std::string& deed);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

private:
    bool take(const std::string& deed);  // false: its last owner removed the file meanwhile

    std::filesystem::path path_;
    int file_ = -1;
    int owner_;
};

// While one lives, no other process can have one for the same folder. Where the file system knows no locks, everybody
// can.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);  // throws Error where another process has it
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int file_ = -1;
};

}  // namespace pelage
