// See vtk_xml.hpp.
#include "io/vtk_xml.hpp"

#include "io/utf8.hpp"

#include <fmt/format.h>

namespace pelage {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t letters_at_once = 1 << 18;

}  // namespace

std::string xml_escaped(std::string_view text) {
    std::string result;
    for (const char c : valid_utf8(text)) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

void Base64::put_triple() {
    const auto bits = static_cast<unsigned>(triple_[0] << 16 | triple_[1] << 8 | triple_[2]);
    for (const unsigned shift : {18u, 12u, 6u, 0u}) letters_ += alphabet[bits >> shift & 63u];
    triple_ = {};
    filled_ = 0;
}

void Base64::write(const void* bytes, std::size_t count) {
    const auto* from = static_cast<const std::uint8_t*>(bytes);
    for (std::size_t i = 0; i < count; ++i) {
        triple_[filled_++] = from[i];
        if (filled_ == 3) put_triple();
    }
    if (letters_.size() < letters_at_once) return;
    file_.write(letters_);
    letters_.clear();
}

void Base64::finish() {
    const std::size_t missing = filled_ == 0 ? 0 : 3 - filled_;
    if (missing != 0) put_triple();
    letters_.replace(letters_.size() - missing, missing, missing, '=');
    file_.write(letters_);
    letters_.clear();
}

void open_array(AtomicFile& file, std::string_view type, std::string_view name, std::size_t components) {
    file.write(fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n", type,
                           xml_escaped(name), components));
}

void close_array(AtomicFile& file) { file.write("\n</DataArray>\n"); }

void open_vtk(AtomicFile& file, std::string_view type, double time, std::uint64_t iteration,
              std::string_view attributes) {
    file.write(fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "<{0}{1}{2}>\n<FieldData>\n"
        "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{3}</DataArray>\n"
        "<DataArray type=\"Int64\" Name=\"iteration\" NumberOfTuples=\"1\" format=\"ascii\">{4}</DataArray>\n"
        "</FieldData>\n",
        type, attributes.empty() ? "" : " ", attributes, time, iteration));
}

void close_vtk(AtomicFile& file, std::string_view type) { file.write(fmt::format("</{}>\n</VTKFile>\n", type)); }

}  // namespace pelage
