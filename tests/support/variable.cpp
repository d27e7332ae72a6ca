// See variable.hpp.
#include "support/variable.hpp"

#include <cstdlib>

namespace test {

Variable::Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    if (value != nullptr) setenv(name, value, 1);
    if (value == nullptr) unsetenv(name);
}

Variable::~Variable() {
    if (before_) setenv(name_, before_->c_str(), 1);
    if (!before_) unsetenv(name_);
}

}  // namespace test
