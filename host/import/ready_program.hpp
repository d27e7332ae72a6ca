// The statements of a formula of Ready, carried out on terms: what each variable holds in the end.
#pragma once

#include "import/formula.hpp"

#include <map>
#include <set>
#include <string>

namespace pelage::imports {

class ReadyProgram {
public:
    // `variables`: those that may be assigned to, with what they hold at first. `meaning` knows all other names.
    ReadyProgram(std::map<std::string, TermRef, std::less<>> variables, Meaning& meaning, Problems& problems);

    // Throws Error for what cannot be read at all; what can be read but not carried over goes to the problems.
    void run(std::string_view text, const FormulaSource&);

    const TermRef& variable(std::string_view name) const;

private:
    class Runner;
    friend class Runner;

    std::map<std::string, TermRef, std::less<>> variables_;
    Meaning& meaning_;
    Problems& problems_;
};

bool is_ready_type(std::string_view word);  // float4, int, ...

}  // namespace pelage::imports
