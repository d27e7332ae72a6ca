// See include.hpp.
#include "language/include.hpp"

#include "core/error.hpp"
#include "language/cursor.hpp"
#include "language/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

namespace pelage::language {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view word = "include";

bool includes(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return false;
    line.remove_prefix(first);
    if (!line.starts_with(word)) return false;
    line.remove_prefix(word.size());
    return line.empty() || line[0] == ' ' || line[0] == '\t' || line[0] == '"' || line[0] == '(' ||
           line.starts_with("//");
}

class Joiner {
public:
    explicit Joiner(std::string source) { joined_.source = std::move(source); }

    // `file`: where the text stands; empty: nowhere.
    void add(std::string_view text, const fs::path& file, const fs::path& folder) {
        std::error_code ignored;
        open_.push_back(fs::weakly_canonical(file, ignored));
        for (const std::string_view line : lines_of(text)) {
            ++line_;
            if (includes(line))
                include(line, folder);
            else
                append(line);
        }
        open_.pop_back();
    }

    JoinedText finish() { return {std::move(text_), std::move(joined_.included)}; }

private:
    void append(std::string_view line) {
        if (text_.size() + line.size() >= largest_text)
            throw Error(fmt::format("{}: with what it includes it is longer than the {} bytes allowed",
                                    joined_.where(line_), largest_text));
        text_.append(line);
        text_ += '\n';
    }

    void include(std::string_view line, const fs::path& folder) {
        const std::vector<Parameter> none;
        constexpr std::size_t deepest = 16;
        Cursor cursor(joined_.where(line_), line_, line, none);
        cursor.expect(word);
        const Token& name = cursor.text("the included file's name");
        cursor.finish();
        const fs::path path = folder / fs::path(name.text);
        std::error_code ignored;
        if (std::ranges::find(open_, fs::weakly_canonical(path, ignored)) != open_.end())
            cursor.fail(name, fmt::format("{} includes itself", Cursor::shown(name)));
        if (open_.size() > deepest) cursor.fail(name, fmt::format("more than {} files include each other", deepest));
        if (!fs::is_regular_file(path, ignored))
            cursor.fail(name, fmt::format("{} is no file that can be read; it is looked for as '{}'",
                                          Cursor::shown(name), path.string()));
        append(fmt::format("// {}", line));
        take_lines(std::string(name.text), path);
        ++line_;
        append(fmt::format("// end of \"{}\"", name.text));
    }

    void take_lines(const std::string& name, const fs::path& path) {
        const std::size_t place = joined_.included.size();
        joined_.included.push_back({line_ + 1, 0, line_, name});
        add(read_text(path), path, path.parent_path());
        joined_.included[place].last = line_;
    }

    Experiment joined_;  // its source and included lines, which tell where a line is
    std::string text_;
    std::size_t line_ = 0;        // of the joined text
    std::vector<fs::path> open_;  // files whose lines are being taken
};

}  // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // byte order mark of UTF-8
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string read_text(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        throw Error(fmt::format("{}: is a folder; an experiment is a text file", path.string()));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(fmt::format("{}: cannot be opened; give the name of an experiment file", path.string()));
    std::string text;
    std::array<char, 1 << 16> part{};
    while (text.size() <= largest_text && (file.read(part.data(), part.size()), file.gcount() > 0)) {
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) throw Error(fmt::format("{}: cannot be read", path.string()));
    return text;
}

JoinedText joined_text(const std::string& text, const std::string& source, const fs::path& folder) {
    if (std::ranges::none_of(lines_of(text), includes)) return {text, {}};
    Joiner joiner(source);
    joiner.add(text, folder / fs::path(source).filename(), folder);
    return joiner.finish();
}

}  // namespace pelage::language
