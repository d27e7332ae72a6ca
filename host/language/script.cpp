// See script.hpp.
#include "language/script.hpp"

#include "language/previous.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::language {

namespace {

template <class Named>
std::optional<std::size_t> find(const std::vector<Named>& all, std::string_view name) {
    const auto has_name = [&](const Named& one) {
        if constexpr (std::is_same_v<Named, Chemical>)
            return one.name == name;
        else
            return one == name;
    };
    const auto found = std::find_if(all.begin(), all.end(), has_name);
    if (found == all.end()) return std::nullopt;
    return static_cast<std::size_t>(found - all.begin());
}

}  // namespace

Script::Script(const std::string& text, const std::string& source, std::filesystem::path folder, StartPictures pictures,
               const std::vector<Setting>& settings)
    : folder_(std::move(folder)), start_pictures_(pictures), settings_(settings), settings_used_(settings.size()) {
    experiment.text = text;
    experiment.source = source;
}

std::optional<std::size_t> Script::find_chemical(std::string_view name) const {
    return find(experiment.chemicals, name);
}

std::optional<std::size_t> Script::find_mapping(std::string_view name) const { return find(experiment.mappings, name); }

std::optional<std::size_t> Script::find_field(std::string_view name) const {
    const auto found = std::ranges::find(experiment.fields, name, &PlaceField::name);
    if (found == experiment.fields.end()) return std::nullopt;
    return static_cast<std::size_t>(found - experiment.fields.begin());
}

std::optional<std::size_t> Script::find_stencil(std::string_view name) const {
    const auto found = std::ranges::find(experiment.stencils, name, &NamedStencil::name);
    if (found == experiment.stencils.end()) return std::nullopt;
    return static_cast<std::size_t>(found - experiment.stencils.begin());
}

std::vector<std::string_view> Script::chemical_names() const {
    std::vector<std::string_view> names;
    for (const Chemical& one : experiment.chemicals) {
        if (!keeps_previous(one)) names.push_back(one.name);
    }
    return names;
}

std::vector<std::string_view> Script::field_names() const {
    std::vector<std::string_view> names;
    for (const PlaceField& one : experiment.fields) {
        if (!one.name.empty()) names.push_back(one.name);
    }
    return names;
}

std::string Script::chemicals_defined() const { return "defined here: " + listed(chemical_names()); }

std::size_t Script::chemical(Cursor& cursor) const {
    const Token& token = cursor.peek();
    if (cursor.done())
        cursor.fail(token, fmt::format("the line ends too early; a chemical is needed, {}", chemicals_defined()));
    if (const auto index = token.quoted ? std::nullopt : find_chemical(token.text)) {
        cursor.next();
        return *index;
    }
    cursor.fail(token, fmt::format("unknown chemical {}; {}{}", Cursor::shown(token), chemicals_defined(),
                                   suggestion(token.text, chemical_names())));
}

const Setting* Script::setting(std::string_view name) {
    const Setting* last = nullptr;
    for (std::size_t i = 0; i < settings_.size(); ++i) {
        if (settings_[i].name != name) continue;
        settings_used_[i] = true;
        last = &settings_[i];
    }
    return last;
}

void Script::replaces(const Token& token, const std::string& written) {
    replaced_.push_back({line_, token.offset, token.text.size(), written});
}

void Script::check_settings() const {
    for (std::size_t i = 0; i < settings_.size(); ++i) {
        if (settings_used_[i]) continue;
        std::vector<std::string_view> names;
        for (const Parameter& one : experiment.parameters) names.push_back(one.name);
        throw Error(fmt::format("--set {}={}: {} defines no parameter of that name; {}{}", shortened(settings_[i].name),
                                shortened(settings_[i].value), experiment.source,
                                names.empty() ? "it defines none" : "defined there: " + listed(names),
                                suggestion(settings_[i].name, names)));
    }
}

// From the last to the first, so that no place moves.
void Script::set_in_text() {
    for (auto one = replaced_.rbegin(); one != replaced_.rend(); ++one) {
        std::size_t begin = experiment.text.starts_with("\xef\xbb\xbf") ? 3 : 0;
        for (std::size_t line = 1; line < one->line; ++line) begin = experiment.text.find('\n', begin) + 1;
        experiment.text.replace(begin + one->offset, one->length, one->by);
    }
}

std::filesystem::path Script::resolve(std::string_view file_name) const {
    return folder_ / std::filesystem::path(file_name);  // an absolute name stays itself
}

void Script::create(const Cursor& cursor, const Token& at, const Statement& statement, std::size_t cells) {
    const bool matrix = std::holds_alternative<CreateMatrix>(statement);
    const bool volume = std::holds_alternative<CreateVolume>(statement);
    const bool mesh = std::holds_alternative<CreateMesh>(statement);
    if (cells_ > 0 && (matrix || matrix_ || volume || volume_ || mesh || mesh_)) {
        cursor.fail(
            at,
            "a matrix holds all cells, and so do charges, a volume and a mesh; give one 'create matrix', 'create "
            "charges', 'create volume' or 'create mesh' and no other 'create'");
    }
    if (cells > largest_cell_count - cells_) {
        cursor.fail(at, fmt::format("'{}' makes {} cells; at most {} are allowed", at.text, cells_ + cells,
                                    largest_cell_count));
    }
    matrix_ = matrix_ || matrix;
    volume_ = volume_ || volume;
    mesh_ = mesh_ || mesh;
    cells_ += cells;
    start(statement, cursor.place(at));
}

void Script::start(Statement statement, const StartPlace& place) {
    experiment.prepattern.push_back(std::move(statement));
    starts_.push_back(place);
}

void Script::begin_phase(std::string name, std::uint64_t steps) {
    Phase next = phase();
    next.name = std::move(name);
    next.begin = in_phase() ? phase_end_ : 0;
    next.rates.assign(experiment.chemicals.size(), std::nullopt);
    phase_end_ = next.begin + steps;
    experiment.phases.push_back(std::move(next));
}

void Script::outside_phases(const Cursor& cursor, const Token& at, std::string_view statement) const {
    if (!in_phase()) return;
    cursor.fail(at, fmt::format("'{}' holds for the whole run; write it before the first 'phase'", statement));
}

namespace {

void note_first(std::optional<Demand>& demand, const Cursor& cursor, const Token& at) {
    if (!demand) demand = Demand{cursor.place(at), std::string(at.text)};
}

}  // namespace

void Script::needs_matrix(const Cursor& cursor, const Token& at) { note_first(needs_matrix_, cursor, at); }

void Script::needs_lattice(const Cursor& cursor, const Token& at) { note_first(needs_lattice_, cursor, at); }

void Script::needs_plane(const Cursor& cursor, const Token& at) { note_first(needs_plane_, cursor, at); }

void Script::needs_volume(const Cursor& cursor, const Token& at) { note_first(needs_volume_, cursor, at); }

void Script::needs_depth(const Cursor& cursor, const Token& at) { note_first(needs_depth_, cursor, at); }

void Script::needs_mesh(const Cursor& cursor, const Token& at) { note_first(needs_mesh_, cursor, at); }

void Script::needs_places(const Cursor& cursor, const Token& at) { note_first(needs_places_, cursor, at); }

void Script::expands(const Cursor& cursor, const Token& at) {
    needs_matrix(cursor, at);
    expansions_.push_back(cursor.place(at));
}

void Script::shows_picture(const Cursor& cursor, const Token& file) {
    pictures_.push_back({experiment.chemicals.size(), cursor.place(file)});
}

void Script::draws_map(const Cursor& cursor, const Token& at) { note_first(draws_map_, cursor, at); }

void Script::refuses_matrix(const Cursor& cursor, const Token& at) { note_first(refuses_matrix_, cursor, at); }

}  // namespace pelage::language
