// `pelage verify` on OpenCL implementations other than the one that all tests run on.
#pragma once

#include "support/process.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace test {

struct Verification {
    Outcome process;
    nlohmann::json report;  // null when none was written

    // What anybody wants to know when it is not as expected.
    std::string told() const { return process.out + process.err; }
    nlohmann::json result(const std::string& check) const;          // null: not among them
    std::vector<std::string> of(const std::string& verdict) const;  // names of checks
    std::vector<std::string> skipped() const { return of("skipped"); }
};

// pelage verify WORDS..., for each filter (all checks without one), with --json.
Verification verify(std::vector<std::string> words, const Surroundings&, const std::string& filter = "");

// Passed, and no cell differs from the reference. Fails the test, with what the command said, when not.
void require_equal_bits(const Verification&);

// Mesa's rusticl on llvmpipe.
Surroundings on_rusticl();
bool rusticl_missing();  // prints "SKIPPED: ..." when so

// Oclgrind, with its detection of data races, of accesses outside of buffers and of values never initialised. What it
// finds it says on the error stream.
Surroundings under_oclgrind();
bool oclgrind_missing();  // prints "SKIPPED: ..." when so

}  // namespace test
