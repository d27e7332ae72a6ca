// Ready's pattern files (.vti): an image of VTK with an element RD that holds a rule, its parameters and how it starts.
// Facts are those of Ready's help pages "File Formats" and "Writing new rules".
#pragma once

#include "import/draft.hpp"
#include "import/names.hpp"
#include "import/problems.hpp"
#include "import/xml.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace pelage::imports {

// Throws Error for what is no such pattern, or one that has no like here.
Draft read_ready(const XmlDocument&, Problems&);

// What the parts of the reader share.
struct ReadyPattern {
    const XmlDocument& document;
    const XmlElement& rd;
    const XmlElement& rule;
    Problems& problems;
    Draft& draft;
    NewNames& names;
    std::vector<std::string> chemicals;                     // as Ready calls them: a, b, ...
    std::map<std::string, double, std::less<>> parameters;  // as Ready calls them
    bool one_dimensional = false;
    bool in_fours = true;  // formulas see four cells of a row at a time
    bool of_old_format = false;

    double value(const std::string& name_here) const;  // of a parameter; NaN: it is none
    bool is_parameter(const std::string& name_here) const;
    [[noreturn]] void fail(const XmlElement& at, std::string_view what) const;
    std::string required(const XmlElement&, std::string_view attribute) const;  // throws Error without it
    double required_number(const XmlElement&, std::string_view attribute) const;
};

std::string ready_chemical_name(std::size_t index);  // a, b, ..., z, aa, ...
double number_in(const std::string& text, const std::string& at,
                 std::string_view what);  // throws Error where it is none

void read_ready_rule(ReadyPattern&);   // rules and diffusion
void read_ready_start(ReadyPattern&);  // what the chemicals begin with

}  // namespace pelage::imports
