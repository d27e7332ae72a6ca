// See formula.hpp: a recursive descent, one function for each level of precedence.
#include "import/formula.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage::imports {

namespace {

constexpr int deepest_formula = 200;

class OneDeeper {
public:
    explicit OneDeeper(int& depth) : depth_(depth) { ++depth_; }
    ~OneDeeper() { --depth_; }
    OneDeeper(const OneDeeper&) = delete;
    OneDeeper& operator=(const OneDeeper&) = delete;

private:
    int& depth_;
};

std::string shown_token(const FormulaToken& token) {
    constexpr std::size_t longest = 40;
    return token.kind == FormulaToken::Kind::end ? "the end" : fmt::format("'{}'", token.text.substr(0, longest));
}

// A number stands for a truth in C as it does here; but `a == b` of numbers must not be taken for one.
TermRef as_truth(const TermRef& term) { return is_truth(term) ? term : call_term("!=", {term, number_term(0.0)}); }

}  // namespace

FormulaReader::FormulaReader(const std::vector<FormulaToken>& tokens, const FormulaSource& source, Dialect dialect,
                             Meaning& meaning, Problems& problems)
    : tokens_(tokens), source_(source), dialect_(dialect), meaning_(meaning), problems_(problems) {}

const FormulaToken& FormulaReader::ahead(std::size_t count) const {
    return tokens_[std::min(at_ + count, tokens_.size() - 1)];
}

FormulaToken FormulaReader::next() {
    const FormulaToken token = now();
    if (!done()) ++at_;
    return token;
}

bool FormulaReader::take(std::string_view sign) {
    if (now().kind != FormulaToken::Kind::sign || now().text != sign) return false;
    ++at_;
    return true;
}

void FormulaReader::expect(std::string_view sign) {
    if (!take(sign)) fail(now(), fmt::format("found {} where '{}' must stand", shown_token(now()), sign));
}

void FormulaReader::fail(const FormulaToken& token, std::string_view what) const {
    throw Error(fmt::format("{}: {}", source_.at(token.line), what));
}

void FormulaReader::refuse(const FormulaToken& token, std::string_view what) {
    problems_.refuse(fmt::format("{}: {}", source_.at(token.line), what));
}

TermRef FormulaReader::expression() {
    const OneDeeper deeper(depth_);
    if (depth_ > deepest_formula)
        fail(now(), fmt::format("the formula is nested too deeply; at most {} levels are allowed", deepest_formula));
    TermRef left = both();
    while (take("||")) left = call_term("or", {as_truth(left), as_truth(both())});
    if (!take("?")) return left;
    const TermRef then = expression();
    expect(":");
    return choice(as_truth(left), then, expression());
}

TermRef FormulaReader::both() {
    TermRef left = compared();
    while (take("&&")) left = call_term("and", {as_truth(left), as_truth(compared())});
    return left;
}

TermRef FormulaReader::compared() {
    static constexpr std::array<std::string_view, 6> signs{"==", "!=", "<=", ">=", "<", ">"};
    TermRef left = sum();
    for (bool more = true; more;) {
        more = false;
        for (const std::string_view sign : signs) {
            if (!take(sign)) continue;
            left = call_term(sign, {left, sum()});
            more = true;
        }
    }
    return left;
}

TermRef FormulaReader::sum() {
    TermRef left = product();
    while (true) {
        if (take("+"))
            left = plus(left, product());
        else if (take("-"))
            left = minus(left, product());
        else
            return left;
    }
}

TermRef FormulaReader::product() {
    TermRef left = with_sign();
    while (true) {
        const FormulaToken at = now();
        if (take("*")) {
            left = times(left, with_sign());
        } else if (take("/")) {
            left = over(left, with_sign());
        } else if (take("%")) {
            refuse(at, "the remainder '%' of whole numbers is not carried over");
            (void)with_sign();
        } else {
            return left;
        }
    }
}

TermRef FormulaReader::with_sign() {
    const OneDeeper deeper(depth_);
    if (depth_ > 2 * deepest_formula) fail(now(), "there are too many signs one after another");
    if (take("+")) return with_sign();
    if (take("-")) return negated(with_sign());
    if (take("!")) return call_term("not", {as_truth(with_sign())});
    return power();
}

TermRef FormulaReader::power() {
    const TermRef base = atom();
    const FormulaToken at = now();
    if (!take("^")) return base;
    if (dialect_ == Dialect::opencl) refuse(at, "'^' of whole numbers is not carried over");
    const TermRef exponent = with_sign();
    for (const double small : {2.0, 3.0, 4.0}) {
        if (is_number(exponent, small)) return call_term("^", {base, exponent});
    }
    if (is_number(exponent, 1.0)) return base;
    return call_term("pow", {base, exponent});
}

TermRef FormulaReader::atom() {
    const FormulaToken token = now();
    if (token.kind == FormulaToken::Kind::number) {
        ++at_;
        return number_term(token.value);
    }
    if (token.kind == FormulaToken::Kind::name) return named();
    if (take("(")) return inside_parentheses();
    fail(token, fmt::format("found {} where a value must stand", shown_token(token)));
}

// A value, or a cast before one; `(float4)(a, b, c, d)` is a vector whose parts differ.
TermRef FormulaReader::inside_parentheses() {
    if (now().kind == FormulaToken::Kind::name && meaning_.is_type(now().text) && ahead(1).text == ")") {
        const FormulaToken type = next();
        next();
        const TermRef value = with_sign();
        if (type.text.starts_with("int") || type.text.starts_with("uint"))
            return choice(call_term("<", {value, number_term(0.0)}), call_term("ceil", {value}),
                          call_term("floor", {value}));
        return value;
    }
    const bool vector = begins_vector();
    if (vector) meaning_.look_at_lane(0);
    TermRef value = expression();
    if (vector) value = whole_vector(value);
    expect(")");
    refuse_parts_of_vectors();
    return value;
}

// Whether a comma comes before these parentheses are closed.
bool FormulaReader::begins_vector() const {
    int inside = 0;
    for (std::size_t i = at_; i < tokens_.size(); ++i) {
        const std::string_view text = tokens_[i].text;
        if (text == ";" || text == "{") return false;
        if (text == "," && inside == 0) return true;
        if (text == "(" || text == "[") ++inside;
        if ((text == ")" || text == "]") && --inside < 0) return false;
    }
    return false;
}

// Four cells of a row side by side are one formula where each part says of its cell what the first says of its own.
TermRef FormulaReader::whole_vector(const TermRef& first) {
    const FormulaToken comma = now();
    int lane = 1;
    bool alike = true;
    for (; take(","); ++lane) {
        meaning_.look_at_lane(lane);
        alike = text_of(expression()) == text_of(first) && alike;
    }
    meaning_.look_at_lane(outside_vectors);
    if (!alike || lane != 4) refuse(comma, "a vector whose parts are different formulas is not carried over");
    return first;
}

TermRef FormulaReader::named() {
    const FormulaToken name = next();
    if (take("(")) {
        TermRef value = meaning_.of_call(name, arguments());
        refuse_parts_of_vectors();
        return value;
    }
    if (now().text == "[") {
        refuse(name, fmt::format("'{}[...]', a value at another place, is not carried over", name.text));
        next();
        (void)expression();
        while (take(",")) (void)expression();
        expect("]");
        return number_term(1.0);
    }
    if (now().text == "." && ahead(1).kind == FormulaToken::Kind::name) {
        if (const auto part = meaning_.of_part(name, ahead(1).text)) {
            at_ += 2;
            return *part;
        }
    }
    TermRef value = meaning_.of_name(name);
    refuse_parts_of_vectors();
    return value;
}

std::vector<TermRef> FormulaReader::arguments() {
    std::vector<TermRef> all;
    if (take(")")) return all;
    do all.push_back(expression());
    while (take(","));
    expect(")");
    return all;
}

void FormulaReader::refuse_parts_of_vectors() {
    const FormulaToken dot = now();
    if (!take(".")) return;
    refuse(dot, fmt::format("'.{}', a part of a vector, is not carried over", now().text));
    if (now().kind == FormulaToken::Kind::name) next();
}

TermRef read_formula(std::string_view text, const FormulaSource& source, Dialect dialect, Meaning& meaning,
                     Problems& problems) {
    const std::vector<FormulaToken> tokens = formula_tokens(text, source);
    FormulaReader reader(tokens, source, dialect, meaning, problems);
    TermRef term = reader.expression();
    if (!reader.done())
        reader.fail(reader.now(), fmt::format("{} follows a formula that is complete", shown_token(reader.now())));
    return term;
}

}  // namespace pelage::imports
