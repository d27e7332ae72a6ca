// See parse.hpp: the loop over lines.
#include "language/parse.hpp"

#include "language/include.hpp"
#include "language/statements.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace pelage {

namespace {

using namespace language;

constexpr std::array<std::string_view, 13> statement_words{"define",  "use",  "create", "set",      "rule",
                                                           "phase",   "snap", "stop",   "colormap", "output",
                                                           "texture", "zoom", "include"};
constexpr std::array statement_parsers{parse_define,   parse_use,    parse_create,  parse_set,
                                       parse_rule,     parse_phase,  parse_snap,    parse_stop,
                                       parse_colormap, parse_output, parse_texture, parse_zoom};
static_assert(statement_words.size() == statement_parsers.size() + 1);  // joined_text() has carried out `include`

// The line to everything that has come with it, but for starts, some of which come at the end.
void note(Outline& outline, const Script& script, std::size_t line, std::string what) {
    outline.statements.push_back({line, std::move(what), outline.phases.size()});
    const Experiment& experiment = script.experiment;
    outline.chemicals.resize(experiment.chemicals.size(), line);
    outline.mappings.resize(experiment.mappings.size(), line);
    outline.phases.resize(experiment.phases.size(), line);
    outline.outputs.resize(script.outputs.size(), line);
}

void parse_line(Script& script, std::size_t number, std::string_view line, Outline* outline) {
    script.at_line(number);
    if (line.size() > largest_line) {
        throw error_at(script.experiment, {number, 1},
                       fmt::format("the line has {} bytes; at most {} are allowed", line.size(), largest_line));
    }
    Cursor cursor(script.experiment.where(number), number, line, script.experiment.parameters);
    if (cursor.done()) return;
    Cursor again = cursor;
    statement_parsers.at(cursor.choose(statement_words))(script, cursor);
    cursor.finish();
    if (outline == nullptr) return;
    const Token& first = again.next();
    note(*outline, script, number, fmt::format("{} {}", first.text, again.next().text));
}

void check_size(const std::string& source, std::size_t size) {
    if (size > largest_text) throw Error(fmt::format("{}: is longer than the {} bytes allowed", source, largest_text));
}

}  // namespace

Experiment parse_experiment(const std::string& text, const std::string& source_name,
                            const std::filesystem::path& folder, Outline* outline, StartPictures pictures,
                            const std::vector<Setting>& settings) {
    check_size(source_name, text.size());
    JoinedText joined = joined_text(text, source_name, folder);
    Script script(joined.text, source_name, folder, pictures, settings);
    script.experiment.included = std::move(joined.included);
    std::size_t number = 0;
    for (const std::string_view line : lines_of(joined.text)) parse_line(script, ++number, line, outline);
    Experiment experiment = script.finish();
    if (outline != nullptr) {
        for (std::size_t i = 0; i < experiment.prepattern.size(); ++i)
            outline->prepattern.push_back(script.line_of_start(i));
    }
    return experiment;
}

Experiment parse_experiment_file(const std::filesystem::path& path, Outline* outline, StartPictures pictures,
                                 const std::vector<Setting>& settings) {
    return parse_experiment(read_text(path), path.string(), path.parent_path(), outline, pictures, settings);
}

}  // namespace pelage
