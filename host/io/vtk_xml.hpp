// Arrays and text in VTK's XML files.
#pragma once

#include "io/atomic_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pelage {

// Text as the value of an XML attribute.
std::string xml_escaped(std::string_view);

// Writes 3 bytes as 4 letters, as they come.
class Base64 {
public:
    explicit Base64(AtomicFile& file) : file_(file) {}
    void write(const void* bytes, std::size_t count);
    void finish();

private:
    void put_triple();

    AtomicFile& file_;
    std::array<std::uint8_t, 3> triple_{};
    std::size_t filled_ = 0;
    std::string letters_;
};

template <class T>
struct VtkType;
template <>
struct VtkType<float> {
    static constexpr std::string_view name = "Float32";
};
template <>
struct VtkType<double> {
    static constexpr std::string_view name = "Float64";
};
template <>
struct VtkType<std::uint8_t> {
    static constexpr std::string_view name = "UInt8";
};
template <>
struct VtkType<std::int32_t> {
    static constexpr std::string_view name = "Int32";
};
template <>
struct VtkType<std::int64_t> {
    static constexpr std::string_view name = "Int64";
};

void open_array(AtomicFile&, std::string_view type, std::string_view name, std::size_t components);
void close_array(AtomicFile&);

// <DataArray> of `count` numbers make(0), make(1), ... of type T, without holding them all.
template <class T, class Make>
void write_array(AtomicFile& file, std::string_view name, std::size_t components, std::size_t count, const Make& make) {
    open_array(file, VtkType<T>::name, name, components);
    Base64 base64(file);
    const std::uint64_t bytes = count * sizeof(T);
    base64.write(&bytes, sizeof bytes);
    std::array<T, 4096> block;
    for (std::size_t i = 0; i < count;) {
        std::size_t filled = 0;
        for (; filled < block.size() && i < count; ++filled, ++i) block[filled] = static_cast<T>(make(i));
        base64.write(block.data(), filled * sizeof(T));
    }
    base64.finish();
    close_array(file);
}

// The file's first and last lines; "TimeValue" is the simulated time, "iteration" a field beside it.
void open_vtk(AtomicFile&, std::string_view type, double time, std::uint64_t iteration,
              std::string_view attributes = "");
void close_vtk(AtomicFile&, std::string_view type);

}  // namespace pelage
