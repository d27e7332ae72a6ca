// See mesh.hpp.
#include "language/mesh.hpp"

#include "core/error.hpp"
#include "core/surface.hpp"
#include "io/file_bytes.hpp"
#include "io/sha256.hpp"
#include "language/statements.hpp"
#include "mesh/read_obj.hpp"
#include "mesh/read_ply.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"
#include "mesh/tidy.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <utility>

namespace pelage::language {

namespace {

constexpr std::uintmax_t largest_mesh_file = std::uintmax_t{1} << 31;

std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

struct NamedMesh {
    Mesh mesh;
    std::vector<std::string> notes;  // of what was put right
};

NamedMesh read_mesh(const std::filesystem::path& path, std::string& digest) {
    const std::string name = path.string(), ending = ending_of(path);
    if (ending != ".obj" && ending != ".ply")
        throw Error(fmt::format("mesh '{}' is no .obj and no .ply file; these two are read", name));
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) && std::filesystem::file_size(path, error) > largest_mesh_file)
        throw Error(fmt::format("mesh '{}' is longer than the {} bytes allowed", name, largest_mesh_file));
    const std::string bytes = read_file(path);
    digest = sha256(bytes);
    Mesh mesh = ending == ".obj" ? parse_obj(bytes, name) : parse_ply(bytes, name);
    try {
        std::vector<std::string> notes = tidy(mesh);
        return {std::move(mesh), std::move(notes)};
    } catch (const Error& fault) {
        throw Error(fmt::format("mesh '{}': {}", name, fault.what()));
    }
}

NamedMesh read_named(Script& script, const Cursor& cursor, const Token& file) {
    try {
        std::string digest;
        NamedMesh mesh = read_mesh(script.resolve(file.text), digest);
        script.experiment.inputs.push_back({std::string(file.text), digest, true});
        return mesh;
    } catch (const Error& error) {
        cursor.fail(file, error.what());
    }
}

// What stands before the options: a file's name, or sizes.
NamedMesh parse_shape(Script& script, Cursor& cursor, const Token& at) {
    if (at.text == "mesh") return read_named(script, cursor, cursor.text("the mesh file's name"));
    if (at.text == "icosphere")
        return {icosphere(cursor.integer("the number of subdivisions", 0, largest_icosphere)), {}};
    const std::size_t around = cursor.integer("the number of vertices around", 4, largest_shape_count);
    const Token& second = cursor.peek();
    const std::size_t across = cursor.integer("the number of vertices across", 3, largest_shape_count);
    try {
        return {torus(around, across), {}};
    } catch (const Error& error) {
        cursor.fail(second, error.what());
    }
}

}  // namespace

void create_mesh(Script& script, Cursor& cursor, const Token& at) {
    static constexpr std::array<std::string_view, 2> words{"weights", "scale"};
    static constexpr std::array<std::string_view, 2> kinds{"uniform", "cotangent"};
    auto [mesh, notes] = parse_shape(script, cursor, at);
    MeshWeights weights = MeshWeights::uniform;
    Options options(words);
    while (const auto option = options.next(cursor)) {
        if (*option == 0) {
            weights = cursor.choose(kinds) == 0 ? MeshWeights::uniform : MeshWeights::cotangent;
            continue;
        }
        const Token& token = cursor.peek();
        const double scale = cursor.number("the scale", positive);
        for (Point& vertex : mesh.vertices) {
            vertex = scale * vertex;
            for (const double coordinate : vertex) {
                if (!(std::abs(coordinate) <= largest_coordinate))
                    cursor.fail(token, fmt::format("'{}' takes a vertex to {}; lengths up to {} are allowed",
                                                   token.text, coordinate, largest_coordinate));
            }
        }
    }
    const std::size_t vertices = mesh.vertices.size();
    try {
        script.create(cursor, at, CreateMesh{make_surface(std::move(mesh), weights, std::move(notes))}, vertices);
    } catch (const Error& error) {
        if (std::string(error.what()).starts_with(script.experiment.source)) throw;
        cursor.fail(at, error.what());
    }
}

}  // namespace pelage::language
