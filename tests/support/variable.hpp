// Environment variables for the time of a test.
#pragma once

#include <optional>
#include <string>

namespace test {

// A variable while it lives; nullptr: not set.
class Variable {
public:
    Variable(const char* name, const char* value);
    ~Variable();
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> before_;
};

// While one lives PoCL compiles programs as they are written, in half the time, and Pelage keeps them in a folder
// beside that of the others. For tests that need many programs to see what these compute; what PoCL's optimiser makes
// of programs is seen by others, and by these where PELAGE_OPTIMISED is set (ctest -L long).
class Unoptimised {
public:
    Unoptimised();

private:
    std::optional<Variable> flags_, cache_;
};

}  // namespace test
