// See csv.hpp.
#include "io/csv.hpp"

#include "io/atomic_file.hpp"
#include "io/mesh_results.hpp"
#include "io/shape.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

namespace pelage {
namespace {

constexpr std::size_t bytes_at_once = 1 << 20;

// In quotes where it holds a comma, a quote or the end of a line (RFC 4180).
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

std::string head(const Experiment& experiment, const char* third) {
    std::string line = fmt::format("id,x,y,{}birth,neighbours,polarity_x,polarity_y", third);
    for (const auto& chemical : experiment.chemicals) line += fmt::format(",{}", quoted("conc " + chemical.name));
    for (const auto& chemical : experiment.chemicals) line += fmt::format(",{}", quoted("diff " + chemical.name));
    return line + "\n";
}

void append(fmt::memory_buffer& to, double value, Precision precision) {
    to.push_back(',');
    if (value == 0.0) {  // most of the polarities and many rates
        to.append(std::string_view(std::signbit(value) ? "-0" : "0"));
        return;
    }
    if (precision == Precision::single_)
        fmt::format_to(std::back_inserter(to), FMT_COMPILE("{:.9g}"), value);
    else
        fmt::format_to(std::back_inserter(to), FMT_COMPILE("{}"), value);
}

// `mesh`: may be null.
void append_cell(fmt::memory_buffer& to, const Snapshot& cells, const MeshSurface* mesh, std::size_t i,
                 Precision precision) {
    const auto add = [&](double value) { append(to, value, precision); };
    fmt::format_to(std::back_inserter(to), FMT_COMPILE("{}"), i);
    add(cells.x[i]);
    add(cells.y[i]);
    if (mesh != nullptr) add(mesh->mesh.vertices[i][2]);
    if (cells.volume()) fmt::format_to(std::back_inserter(to), FMT_COMPILE(",{}"), i / (cells.columns * cells.rows));
    fmt::format_to(std::back_inserter(to), FMT_COMPILE(",{},{}"), cells.birth[i], cells.neighbours[i]);
    add(cells.polarity_x[i]);
    add(cells.polarity_y[i]);
    for (const auto& values : cells.conc) add(values[i]);
    for (const auto& values : cells.diff) add(values[i]);
    to.push_back('\n');
}

}  // namespace

void write_csv(const std::filesystem::path& path, const Snapshot& snapshot, const Experiment& experiment,
               Precision precision) {
    check_shape(snapshot, experiment);
    AtomicFile file(path);
    const MeshSurface* mesh = surface_of(experiment);
    if (mesh != nullptr && mesh->cells() != snapshot.cells()) mesh = nullptr;
    file.write(head(experiment, mesh != nullptr ? "z," : snapshot.volume() ? "layer," : ""));
    fmt::memory_buffer buffer;
    for (std::size_t i = 0; i < snapshot.cells(); ++i) {
        append_cell(buffer, snapshot, mesh, i, precision);
        if (buffer.size() < bytes_at_once && i + 1 < snapshot.cells()) continue;
        file.write(buffer.data(), buffer.size());
        buffer.clear();
    }
    file.commit();
}

}  // namespace pelage
