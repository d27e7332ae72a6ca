// See ready.hpp.
#include "import/ready.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

namespace pelage::imports {

namespace {

constexpr std::size_t most_chemicals = 100;

std::string without_blanks(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

const XmlElement& image_of(const XmlDocument& document) {
    const XmlElement& root = document.root;
    if (root.name != "VTKFile")
        throw Error(fmt::format("{}: is no file of VTK; found <{}>", document.at(root), root.name));
    if (root.child("RD") == nullptr)
        throw Error(fmt::format("{}: holds no element RD, so it is no pattern of Ready", document.at(root)));
    const XmlElement* image = root.child("ImageData");
    if (image == nullptr)
        throw Error(fmt::format("{}: is a pattern on a mesh or other grid; only images (ImageData) can be carried over",
                                document.at(root)));
    return *image;
}

std::array<std::size_t, 3> size_of(const XmlDocument& document, const XmlElement& element, std::string_view attribute) {
    const std::string* text = element.attribute(attribute);
    std::array<long, 6> extent{};
    const char* at = text == nullptr ? nullptr : text->data();
    const char* const end = text == nullptr ? nullptr : at + text->size();
    for (long& one : extent) {
        while (at != end && *at == ' ') ++at;
        const auto [next, error] = std::from_chars(at, end, one);
        if (at == end || error != std::errc())
            throw Error(fmt::format("{}: {} must be six whole numbers", document.at(element), attribute));
        at = next;
    }
    std::array<std::size_t, 3> size{};
    for (std::size_t i = 0; i < 3; ++i) {
        const long low = extent[2 * i], high = extent[2 * i + 1];
        constexpr long far = 1L << 40;
        if (low < -far || high > far || high < low)
            throw Error(fmt::format("{}: {} '{}' is no extent of an image", document.at(element), attribute, *text));
        size[i] = static_cast<std::size_t>(high - low + 1);
    }
    return size;
}

void read_size(const XmlDocument& document, Draft& draft) {
    const XmlElement& image = image_of(document);
    const auto size = size_of(document, image, "WholeExtent");
    if (size[2] > 1) {
        throw Error(fmt::format("{}: the image has three dimensions, {} x {} x {}; patterns of two are carried over",
                                document.at(image), size[0], size[1], size[2]));
    }
    if (size[0] > most_cells / size[1])
        throw Error(fmt::format("{}: the image of {} x {} cells is too large; at most {} cells can be carried over",
                                document.at(image), size[0], size[1], most_cells));
    const XmlElement* piece = image.child("Piece");
    if (piece == nullptr) throw Error(fmt::format("{}: the image has no Piece", document.at(image)));
    if (size_of(document, *piece, "Extent") != size)
        throw Error(fmt::format("{}: the image is made of several pieces, or its Extent is not the WholeExtent",
                                document.at(*piece)));
    draft.columns = size[0];
    draft.rows = size[1];
}

std::size_t count_of_chemicals(const ReadyPattern& pattern) {
    for (const char* name : {"formula", "kernel"}) {
        const XmlElement* body = pattern.rule.child(name);
        if (body == nullptr) continue;
        const double count = pattern.required_number(*body, "number_of_chemicals");
        if (!(count >= 1.0 && count <= double{most_chemicals}) || count != std::floor(count))
            pattern.fail(*body, fmt::format("number_of_chemicals must be a whole number from 1 to {}", most_chemicals));
        return static_cast<std::size_t>(count);
    }
    return 2;
}

void read_parameters(ReadyPattern& pattern) {
    for (const XmlElement& element : pattern.rule.children) {
        if (element.name != "param") continue;
        const std::string name = without_blanks(pattern.required(element, "name"));
        const std::string text = without_blanks(element.text);
        const double value = number_in(text, pattern.document.at(element), "a parameter's value");
        if (pattern.parameters.contains(name)) {
            pattern.problems.note(fmt::format("{}: parameter '{}' is given again; the first value is taken",
                                              pattern.document.at(element), name));
            continue;
        }
        pattern.parameters[name] = value;
        const std::string here = pattern.names.of(name);
        if (here != name) pattern.problems.note(fmt::format("parameter '{}' is called '{}' here", name, here));
        pattern.draft.parameters.push_back({here, number_term(value), {}});
    }
}

void read_chemicals(ReadyPattern& pattern) {
    const std::size_t count = count_of_chemicals(pattern);
    for (std::size_t i = 0; i < count; ++i) {
        pattern.chemicals.push_back(ready_chemical_name(i));
        const std::string& original = pattern.chemicals.back();
        DraftChemical chemical;
        chemical.name = pattern.names.of(original);
        if (chemical.name != original)
            pattern.problems.note(fmt::format("chemical '{}' is called '{}' here", original, chemical.name));
        pattern.draft.chemicals.push_back(std::move(chemical));
    }
}

void read_time_step(ReadyPattern& pattern) {
    const auto step = pattern.parameters.find("timestep");
    if (step == pattern.parameters.end()) {
        pattern.problems.note(fmt::format("{}: the rule has no parameter 'timestep'; a time step of 1 is taken",
                                          pattern.document.at(pattern.rule)));
    } else if (!(step->second > 0.0)) {
        pattern.fail(pattern.rule, fmt::format("the time step must be above 0; it is {:g}", step->second));
    } else {
        pattern.draft.time_step = name_term(pattern.names.of("timestep"));
    }
}

std::string setting(const ReadyPattern& pattern, std::string_view name) {
    const XmlElement* settings = pattern.rd.child("render_settings");
    const XmlElement* one = settings == nullptr ? nullptr : settings->child(name);
    const std::string* value = one == nullptr ? nullptr : one->attribute("value");
    return value == nullptr ? "" : *value;
}

void read_output(ReadyPattern& pattern) {
    std::string shown = setting(pattern, "active_chemical");
    if (std::ranges::find(pattern.chemicals, shown) == pattern.chemicals.end()) shown = pattern.chemicals[0];
    std::string line = "output " + pattern.names.of(shown);
    const std::string low = setting(pattern, "low"), high = setting(pattern, "high");
    if (!low.empty() && !high.empty()) {
        const std::string at = pattern.document.at(*pattern.rd.child("render_settings"));
        const double from = number_in(low, at, "'low'"), to = number_in(high, at, "'high'");
        if (from < to) line += fmt::format(" range {} {}", number_text(from), number_text(to));
    }
    pattern.draft.outputs.push_back(line + " colormap viridis");
}

void read_heading(ReadyPattern& pattern) {
    const std::string* name = pattern.rule.attribute("name");
    pattern.draft.heading.push_back(
        fmt::format("{}, carried over from a pattern of Ready.", name == nullptr || name->empty() ? "A rule" : *name));
    if (pattern.draft.outputs.empty()) return;
    pattern.draft.heading.push_back("Such patterns run without an end; `stop` is of this importer.");
}

// Unused ones would be warned of, and `timestep` is always used.
void drop_unused_parameters(ReadyPattern& pattern) {
    std::string text = text_of(pattern.draft, "", {});
    text.erase(0, text.find("define chemical"));
    std::erase_if(pattern.draft.parameters, [&](const DraftParameter& one) { return !has_word(text, one.name); });
}

}  // namespace

double ReadyPattern::value(const std::string& name_here) const {
    for (const DraftParameter& one : draft.parameters) {
        if (one.name == name_here)
            return value_of(one.value, [](const std::string&) { return std::numeric_limits<double>::quiet_NaN(); });
    }
    return std::numeric_limits<double>::quiet_NaN();
}

bool ReadyPattern::is_parameter(const std::string& name_here) const { return !std::isnan(value(name_here)); }

void ReadyPattern::fail(const XmlElement& at, std::string_view what) const {
    throw Error(fmt::format("{}: {}", document.at(at), what));
}

std::string ReadyPattern::required(const XmlElement& element, std::string_view attribute) const {
    const std::string* text = element.attribute(attribute);
    if (text == nullptr) fail(element, fmt::format("'{}' has no '{}'", element.name, attribute));
    return *text;
}

double ReadyPattern::required_number(const XmlElement& element, std::string_view attribute) const {
    return number_in(without_blanks(required(element, attribute)), document.at(element),
                     fmt::format("'{}' of '{}'", attribute, element.name));
}

std::string ready_chemical_name(std::size_t index) {
    std::string name;
    for (std::size_t rest = index + 1; rest > 0; rest = (rest - 1) / 26)
        name.insert(0, 1, static_cast<char>('a' + (rest - 1) % 26));
    return name;
}

double number_in(const std::string& text, const std::string& at, std::string_view what) {
    double value = 0.0;
    const char* first = text.data();
    const char* const end = first + text.size();
    if (first != end && *first == '+') ++first;
    const auto [rest, error] = std::from_chars(first, end, value);
    const bool suffix = rest != end && rest + 1 == end && *rest == 'f';
    if (error != std::errc() || (rest != end && !suffix) || !std::isfinite(value) ||
        std::fabs(value) > double{std::numeric_limits<float>::max()})
        throw Error(fmt::format("{}: {} must be a number; found '{}'", at, what, text.substr(0, 40)));
    return value;
}

Draft read_ready(const XmlDocument& document, Problems& problems) {
    Draft draft;
    NewNames names;
    image_of(document);
    const XmlElement& rd = *document.root.child("RD");
    const XmlElement* rule = rd.child("rule");
    if (rule == nullptr) throw Error(fmt::format("{}: the pattern has no rule", document.at(rd)));
    ReadyPattern pattern{document, rd, *rule, problems, draft, names, {}, {}, false, true, false};
    read_size(document, draft);
    pattern.one_dimensional = draft.rows == 1;
    const std::string* format = rd.attribute("format_version");
    pattern.of_old_format = format != nullptr && std::atoi(format->c_str()) < 6;
    const std::string* wrap = rule->attribute("wrap");
    draft.edge = wrap == nullptr || *wrap == "1" ? "wrap" : "no-flux";
    read_chemicals(pattern);
    read_parameters(pattern);
    read_time_step(pattern);
    read_ready_rule(pattern);
    read_ready_start(pattern);
    problems.check();
    read_output(pattern);
    read_heading(pattern);
    drop_unused_parameters(pattern);
    return draft;
}

}  // namespace pelage::imports
