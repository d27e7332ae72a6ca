// Runs the built `pelage` command as a process, as a user would.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace test {

// A fresh folder, gone with all it holds when the test ends.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::string write(const std::string& name, const std::string& text) const;  // returns the file's path

private:
    std::filesystem::path path_;
};

std::string read_all(const std::filesystem::path&);
std::vector<std::string> names_in(const std::filesystem::path& folder);  // sorted

struct Outcome {
    int exit_code = -1;  // 128 + signal when one killed it
    std::string out;
    std::string err;
};

struct Surroundings {
    std::map<std::string, std::string> environment;  // beside the test's own
    std::filesystem::path folder;                    // to start in; empty: the test's own
    std::size_t largest_file = 0;                    // bytes; writing more fails as on a full disk; 0: no limit
    std::chrono::seconds patience{120};              // how long it may take
    std::string input;                               // what it reads from standard input
};

class Child {
public:
    explicit Child(const std::vector<std::string>& words, const Surroundings& = {});
    ~Child();  // ends it when it still runs
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    pid_t id() const { return id_; }
    bool running();
    void signal(int number) const;
    Outcome wait();  // fails the test when it takes longer than it may

private:
    Folder folder_;
    std::chrono::seconds patience_;
    pid_t id_ = -1;
    int status_ = 0;
    bool ended_ = false;
};

inline const std::string program = PELAGE_COMMAND;

// pelage WORDS..., to its end.
Outcome command(std::vector<std::string> words, const Surroundings& = {});

// A line of the shell, to its end.
Outcome shell(const std::string& line, const Surroundings& = {});

// The child of a process that has this word in its command line, once it is there; 0: none came.
pid_t child_of(pid_t parent, const std::string& word);

// The file is there; false when the child ends or two minutes pass first.
bool wait_for(const std::filesystem::path&, Child&);

}  // namespace test
