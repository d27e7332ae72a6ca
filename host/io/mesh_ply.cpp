// PLY files; see mesh_file.hpp.
#include "io/atomic_file.hpp"
#include "io/file_bytes.hpp"
#include "io/mesh_file.hpp"

#include <fmt/format.h>

#include <cctype>

namespace pelage {

namespace {

constexpr std::size_t ply_bytes_at_once = 1 << 20;

// Collects numbers and hands them on in large pieces.
class PlyBytes {
public:
    explicit PlyBytes(AtomicFile& file) : file_(file) {}

    template <class T>
    void put(T value) {
        const auto* const bytes = reinterpret_cast<const char*>(&value);
        kept_.append(bytes, sizeof value);
        if (kept_.size() >= ply_bytes_at_once) flush();
    }
    void put(double value, Precision precision) {
        if (precision == Precision::double_) return put<double>(value);
        put<float>(static_cast<float>(value));
    }
    void flush() {
        file_.write(kept_.data(), kept_.size());
        kept_.clear();
    }

private:
    AtomicFile& file_;
    std::string kept_;
};

std::string ply_name(std::string text) {
    for (char& c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return text;
}

std::string ply_head(const Mesh& mesh, bool coloured, const std::vector<VertexValues>& values, Precision precision) {
    const char* const type = precision == Precision::double_ ? "double" : "float";
    std::string text = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment written by Pelage\nelement vertex {}\n", mesh.vertices.size());
    for (const char axis : {'x', 'y', 'z'}) text += fmt::format("property {} {}\n", type, axis);
    if (coloured) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    for (const VertexValues& one : values) text += fmt::format("property {} {}\n", type, ply_name(one.name));
    return text +
           fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangles.size());
}

}  // namespace

void write_mesh_ply(const std::filesystem::path& path, const Mesh& mesh, std::span<const Rgb> colours,
                    const std::vector<VertexValues>& values, Precision precision) {
    AtomicFile file(path);
    file.write(ply_head(mesh, !colours.empty(), values, precision));
    PlyBytes bytes(file);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        for (const double coordinate : mesh.vertices[i]) bytes.put(coordinate, precision);
        if (!colours.empty()) {
            for (const std::uint8_t channel : colours[i]) bytes.put<std::uint8_t>(channel);
        }
        for (const VertexValues& one : values) bytes.put(one.values[i], precision);
    }
    for (const Triangle& triangle : mesh.triangles) {
        bytes.put<std::uint8_t>(3);
        for (const std::uint32_t corner : triangle) bytes.put<std::uint32_t>(corner);
    }
    bytes.flush();
    file.commit();
}

}  // namespace pelage
