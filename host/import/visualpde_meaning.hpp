// What the names in VisualPDE's expressions mean, and its parameters.
#pragma once

#include "import/formula.hpp"
#include "import/names.hpp"
#include "import/visualpde.hpp"
#include "import/visualpde_preset.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pelage::imports {

// A derivative as a sum of the cells around, in cells.
struct PdeDerivative {
    std::string_view kind;  // "xx", ... of u_xx
    int powers_of_dx;
    std::vector<std::string> weights;
};

class PdeMeaning final : public Meaning {
public:
    // The draft has the lattice's size already, and dx and dt as its first parameters.
    PdeMeaning(const PdePreset&, Draft&, NewNames&, Problems&, std::vector<std::string> species, double dx);

    // A field as a term. At the start there is no time yet.
    TermRef read(const std::string& text, std::string_view key, bool at_start = false);

    TermRef of_name(const FormulaToken&) override;
    TermRef of_call(const FormulaToken&, std::vector<TermRef> arguments) override;

    TermRef species(std::size_t index) const;
    TermRef dx() const;
    double value(const std::string& name_here) const;  // of a parameter; NaN: it is none
    bool is_constant(const TermRef&) const;            // made of numbers and parameters

private:
    struct Parameter {
        std::string text;
        std::optional<std::pair<double, double>> range;
        TermRef term;  // null: not read yet
        bool being_read = false;
    };

    void collect_parameters();
    void collect_parameter(std::string_view definition);
    TermRef parameter(const std::string& name, const FormulaToken&);
    TermRef length(std::string_view name, double value);
    std::optional<TermRef> of_domain(std::string_view name);
    std::optional<TermRef> random(std::string_view name) const;
    std::optional<TermRef> slope(const FormulaToken&);
    TermRef slope_of(const std::string& chemical, std::string_view kind, const FormulaToken&);
    std::string named_stencil(const PdeDerivative&);
    TermRef bump(const std::vector<TermRef>&);
    TermRef gauss(const std::vector<TermRef>&);
    TermRef refused(const FormulaToken&, std::string_view what);
    TermRef x() const;
    TermRef y() const;

    const PdePreset& preset_;
    Draft& draft_;
    NewNames& names_;
    Problems& problems_;
    std::vector<std::string> species_;
    double dx_;
    std::map<std::string, Parameter, std::less<>> parameters_;
    std::string where_;  // the field that is being read
    bool at_start_ = false;
    int depth_ = 0;
};

}  // namespace pelage::imports
