// See npy_header.hpp. Format: numpy.lib.format.
#include "io/npy_header.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <cctype>
#include <charconv>

namespace pelage {
namespace {

class HeaderReader {
public:
    HeaderReader(std::string_view text, std::string_view name) : text_(text), name_(name) {}

    NpyHeader read() {
        NpyHeader header;
        unsigned seen = 0;
        expect('{');
        while (!accept('}')) {
            const auto key = string();
            expect(':');
            seen |= entry(key, header);
            if (!accept(',') && peek() != '}') fail("a ',' is missing in its header");
        }
        if (seen != 7) fail("its header must hold 'descr', 'fortran_order' and 'shape'");
        return header;
    }

private:
    unsigned entry(const std::string& key, NpyHeader& header) {
        if (key == "descr") {
            if (peek() == '[') fail("structured types cannot be read; allowed are plain numbers");
            header.descr = string();
            return 1;
        }
        if (key == "fortran_order") {
            header.fortran_order = truth();
            return 2;
        }
        if (key != "shape") fail(fmt::format("unknown entry '{}' in its header", key));
        header.shape = tuple();
        return 4;
    }

    std::string string() {
        const char quote = peek();
        if (quote != '\'' && quote != '"') fail("a name in quotes is missing in its header");
        const auto end = text_.find(quote, at_ + 1);
        if (end == std::string_view::npos) fail("a quote is not closed in its header");
        std::string value(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
        return value;
    }

    bool truth() {
        peek();
        for (const bool value : {true, false}) {
            const std::string_view word = value ? "True" : "False";
            if (text_.substr(at_, word.size()) != word) continue;
            at_ += word.size();
            return value;
        }
        fail("'fortran_order' must be True or False");
    }

    std::vector<std::size_t> tuple() {
        std::vector<std::size_t> values;
        expect('(');
        while (!accept(')')) {
            peek();
            std::size_t value = 0;
            const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
            if (error != std::errc()) fail("its shape must be a tuple of whole numbers");
            at_ = static_cast<std::size_t>(end - text_.data());
            values.push_back(value);
            if (!accept(',') && peek() != ')') fail("its shape must be a tuple of whole numbers");
        }
        return values;
    }

    char peek() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool accept(char wanted) {
        if (peek() != wanted) return false;
        ++at_;
        return true;
    }
    void expect(char wanted) {
        if (!accept(wanted)) fail(fmt::format("a '{}' is missing in its header", wanted));
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(fmt::format("'{}' cannot be read as an .npy array: {}", name_, what));
    }

    std::string_view text_;
    std::string_view name_;
    std::size_t at_ = 0;
};

}  // namespace

NpyHeader parse_npy_header(std::string_view text, std::string_view name) { return HeaderReader(text, name).read(); }

}  // namespace pelage
