// See error_case.hpp.
#include "language/error_case.hpp"

#include "core/error.hpp"
#include "language/parse.hpp"

#include <catch2/catch.hpp>

namespace test {

std::string message_of(const std::string& text) {
    try {
        pelage::parse_experiment(text, "t.pex", "/nowhere");
    } catch (const pelage::Error& error) {
        return error.what();
    }
    return "(none)";
}

void check_error(const ErrorCase& one) {
    const std::string found = message_of(one.prelude + one.text);

    INFO(one.text);
    CHECK(found == one.message);
}

}  // namespace test
