// See ready_program.hpp.
#include "import/ready_program.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage::imports {

namespace {

constexpr std::array<std::string_view, 17> ready_types{"float",   "float2", "float4", "float8", "double",  "double2",
                                                       "double4", "int",    "int2",   "int4",   "uint",    "uint4",
                                                       "bool",    "long",   "long4",  "half",   "unsigned"};
constexpr std::array<std::string_view, 6> unknown_statements{"for", "while", "do", "switch", "return", "goto"};

template <std::size_t N>
bool one_of(std::string_view word, const std::array<std::string_view, N>& words) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

bool is_ready_type(std::string_view word) { return one_of(word, ready_types); }

// Gives a variable its value where it has one, and asks the other meaning for the rest.
class ReadyProgram::Runner final : public Meaning {
public:
    Runner(ReadyProgram& program, const std::vector<FormulaToken>& tokens, const FormulaSource& source)
        : program_(program), reader_(tokens, source, Dialect::opencl, *this, program.problems_) {}

    void statements() {
        while (!reader_.done()) statement();
    }

    TermRef of_name(const FormulaToken& token) override {
        const auto found = program_.variables_.find(token.text);
        return found == program_.variables_.end() ? program_.meaning_.of_name(token) : found->second;
    }
    TermRef of_call(const FormulaToken& token, std::vector<TermRef> arguments) override {
        return program_.meaning_.of_call(token, std::move(arguments));
    }
    bool is_type(std::string_view word) const override { return is_ready_type(word); }
    std::optional<TermRef> of_part(const FormulaToken& token, std::string_view part) override {
        const auto found = program_.variables_.find(token.text);
        const bool changed = found != program_.variables_.end() && !is_name(found->second);
        return changed ? std::nullopt : program_.meaning_.of_part(token, part);
    }
    void look_at_lane(int lane) override { program_.meaning_.look_at_lane(lane); }

private:
    void statement() {
        if (++depth_ > 50) reader_.fail(reader_.now(), "blocks are nested too deeply; at most 50 levels are allowed");
        one_statement();
        --depth_;
    }

    void one_statement() {
        const FormulaToken first = reader_.now();
        if (reader_.take(";")) return;
        if (reader_.take("{")) return block();
        if (first.text == "#") reader_.fail(first, "a directive of the preprocessor ('#') is not carried over");
        if (one_of(first.text, unknown_statements))
            reader_.fail(first, fmt::format("a statement '{}' is not carried over", first.text));
        if (first.text == "if") return branch();
        if (first.text == "const" || is_ready_type(first.text)) return declaration();
        assignment();
        reader_.expect(";");
    }

    void block() {
        while (!reader_.take("}")) {
            if (reader_.done()) reader_.fail(reader_.now(), "a block '{' is not closed");
            statement();
        }
    }

    // Both ways are gone; afterwards each variable holds what its way gave it.
    void branch() {
        reader_.next();
        reader_.expect("(");
        TermRef truth = reader_.expression();
        reader_.expect(")");
        const auto before = program_.variables_;
        statement();
        auto then = program_.variables_;
        program_.variables_ = before;
        if (reader_.now().text == "else") {
            reader_.next();
            statement();
        }
        for (auto& [name, value] : program_.variables_) {
            const auto other = then.find(name);
            if (other != then.end()) value = choice(truth, other->second, value);
        }
    }

    void declaration() {
        while (reader_.now().text == "const" || is_ready_type(reader_.now().text)) {
            whole_ = reader_.now().text.starts_with("int") || reader_.now().text.starts_with("uint");
            reader_.next();
        }
        do {
            const FormulaToken name = reader_.next();
            if (name.kind != FormulaToken::Kind::name) reader_.fail(name, "the name of a variable must stand here");
            if (reader_.now().text == "[")
                reader_.fail(name, fmt::format("'{}[]', an array, is not carried over", name.text));
            const bool given = reader_.take("=");
            store(name, given ? reader_.expression() : number_term(0.0));
        } while (reader_.take(","));
        whole_ = false;
        reader_.expect(";");
    }

    void assignment() {
        static constexpr std::array<std::string_view, 4> operations{"+=", "-=", "*=", "/="};
        const FormulaToken name = reader_.next();
        if (name.kind != FormulaToken::Kind::name)
            reader_.fail(name, fmt::format("'{}' cannot begin a statement of a formula", name.text));
        if (reader_.now().text == ".")
            reader_.fail(name, fmt::format("'{}.{}', a part of a vector, is not carried over", name.text,
                                           reader_.ahead(1).text));
        if (reader_.take("=")) return assign(name, reader_.expression());
        for (const std::string_view operation : operations) {
            if (!reader_.take(operation)) continue;
            const TermRef old = of_name(name);
            const TermRef by = reader_.expression();
            return assign(name, operation == "+="   ? plus(old, by)
                                : operation == "-=" ? minus(old, by)
                                : operation == "*=" ? times(old, by)
                                                    : over(old, by));
        }
        if (reader_.take("++")) return assign(name, plus(of_name(name), number_term(1.0)));
        if (reader_.take("--")) return assign(name, minus(of_name(name), number_term(1.0)));
        reader_.fail(reader_.now(), fmt::format("found '{}' behind '{}', where an assignment must stand",
                                                reader_.now().text, name.text));
    }

    void assign(const FormulaToken& name, TermRef value) {
        if (!program_.variables_.contains(name.text))
            reader_.refuse(
                name, fmt::format("'{}' is given a value but is no variable, chemical or delta_ of one", name.text));
        store(name, std::move(value));
    }

    void store(const FormulaToken& name, TermRef value) {
        if (whole_ && !is_leaf_number(value))
            value = choice(call_term("<", {value, number_term(0.0)}), call_term("ceil", {value}),
                           call_term("floor", {value}));
        program_.variables_[std::string(name.text)] = std::move(value);
    }

    ReadyProgram& program_;
    FormulaReader reader_;
    int depth_ = 0;
    bool whole_ = false;  // what is declared is a whole number
};

ReadyProgram::ReadyProgram(std::map<std::string, TermRef, std::less<>> variables, Meaning& meaning, Problems& problems)
    : variables_(std::move(variables)), meaning_(meaning), problems_(problems) {}

void ReadyProgram::run(std::string_view text, const FormulaSource& source) {
    const std::vector<FormulaToken> tokens = formula_tokens(text, source);
    try {
        Runner(*this, tokens, source).statements();
    } catch (const Error&) {
        problems_.check();  // what came before
        throw;
    }
}

const TermRef& ReadyProgram::variable(std::string_view name) const { return variables_.find(name)->second; }

}  // namespace pelage::imports
