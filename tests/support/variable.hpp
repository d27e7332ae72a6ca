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

}  // namespace test
