// Reads expressions of formulas into terms: C's operators, and in VisualPDE's dialect `^` for powers.
#pragma once

#include "import/formula_tokens.hpp"
#include "import/problems.hpp"
#include "import/term.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace pelage::imports {

inline constexpr int outside_vectors = -1;

enum class Dialect { opencl, visualpde };

// What names and functions mean. Both may add to the problems and give any term.
class Meaning {
public:
    virtual ~Meaning() = default;
    virtual TermRef of_name(const FormulaToken&) = 0;
    virtual TermRef of_call(const FormulaToken&, std::vector<TermRef> arguments) = 0;
    virtual bool is_type(std::string_view) const { return false; }  // in casts
    // `name.x`; empty where it cannot be told. A vector's parts are read one after another, in lane 0, 1, ..., and what
    // is outside of vectors in none.
    virtual std::optional<TermRef> of_part(const FormulaToken&, [[maybe_unused]] std::string_view part) {
        return std::nullopt;
    }
    virtual void look_at_lane(int) {}
};

class FormulaReader {
public:
    FormulaReader(const std::vector<FormulaToken>&, const FormulaSource&, Dialect, Meaning&, Problems&);

    // An expression up to a sign that cannot go on with it. Throws Error for what cannot be read at all.
    TermRef expression();

    const FormulaToken& now() const { return tokens_[at_]; }
    const FormulaToken& ahead(std::size_t count) const;
    FormulaToken next();
    bool take(std::string_view sign);
    void expect(std::string_view sign);
    bool done() const { return now().kind == FormulaToken::Kind::end; }
    [[noreturn]] void fail(const FormulaToken&, std::string_view what) const;
    void refuse(const FormulaToken&, std::string_view what);  // goes on

private:
    TermRef both();
    TermRef compared();
    TermRef sum();
    TermRef product();
    TermRef with_sign();
    TermRef power();
    TermRef atom();
    TermRef inside_parentheses();
    bool begins_vector() const;
    TermRef whole_vector(const TermRef& first);
    TermRef named();
    std::vector<TermRef> arguments();
    void refuse_parts_of_vectors();

    const std::vector<FormulaToken>& tokens_;
    const FormulaSource& source_;
    Dialect dialect_;
    Meaning& meaning_;
    Problems& problems_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

// A whole text as one expression. Throws Error where something is left over.
TermRef read_formula(std::string_view text, const FormulaSource&, Dialect, Meaning&, Problems&);

}  // namespace pelage::imports
