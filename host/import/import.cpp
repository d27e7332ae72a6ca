// See import.hpp.
#include "import/import.hpp"

#include "core/error.hpp"
#include "import/draft.hpp"
#include "import/problems.hpp"
#include "import/ready.hpp"
#include "import/visualpde.hpp"
#include "import/xml.hpp"
#include "io/atomic_file.hpp"
#include "io/npy.hpp"
#include "io/utf8.hpp"
#include "language/parse.hpp"

#include <fmt/format.h>

namespace pelage::imports {

namespace {

bool begins_xml(std::string_view bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '<';
}

Draft read_draft(std::string bytes, const std::string& name, Problems& problems) {
    if (begins_xml(bytes)) return read_ready(parse_xml(std::move(bytes), name), problems);
    return read_visualpde(std::move(bytes), name, problems);
}

// A text that the language refuses is an own fault of the reader; it is said with the line.
void check_experiment(const std::string& text, const std::string& name, const std::string& result) {
    try {
        (void)parse_experiment(text, result, ".", nullptr, StartPictures::left_out);
    } catch (const Error& error) {
        std::string_view message = error.what();
        std::size_t line = 0;
        if (message.starts_with(result + ":")) line = std::strtoul(error.what() + result.size() + 1, nullptr, 10);
        std::string_view rest = text;
        for (std::size_t i = 1; i < line && !rest.empty(); ++i)
            rest.remove_prefix(std::min(rest.size(), rest.find('\n') + 1));
        throw Error(fmt::format("{}: what it asks for is refused by the experiment language: {}; in `{}`", name,
                                message, rest.substr(0, std::min<std::size_t>(rest.find('\n'), 200))));
    }
}

}  // namespace

Import import_text(std::string bytes, const std::string& name, const std::string& base) {
    Problems problems;
    Draft draft = read_draft(std::move(bytes), name, problems);
    problems.check();
    Import result;
    result.notes = problems.notes();
    result.text = valid_utf8(text_of(draft, base, result.notes));
    result.columns = draft.columns;
    result.rows = draft.rows;
    check_experiment(result.text, name, base + ".pex");
    for (DraftChemical& chemical : draft.chemicals) {
        if (!chemical.picture.empty())
            result.pictures.push_back({picture_name(draft, chemical, base), std::move(chemical.picture)});
    }
    return result;
}

void write_import(const Import& made, const std::filesystem::path& experiment) {
    std::vector<std::filesystem::path> written;
    try {
        for (const Import::Picture& picture : made.pictures) {
            const auto path = experiment.parent_path() / picture.name;
            write_npy(path, {made.rows, made.columns}, picture.values, NpyType::float32);
            written.push_back(path);
        }
        write_file(experiment, made.text);
    } catch (const Error&) {
        std::error_code ignored;
        for (const auto& path : written) std::filesystem::remove(path, ignored);
        throw;
    }
}

}  // namespace pelage::imports
