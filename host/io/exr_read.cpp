// EXR pictures, whole or as fields; see exr.hpp and field.hpp. The header is checked before OpenEXR makes buffers from
// what it says.
#include "core/error.hpp"
#include "io/exr.hpp"
#include "io/exr_channels.hpp"
#include "io/exr_stream.hpp"
#include "io/field.hpp"
#include "io/file_bytes.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

namespace pelage {

bool ExrInput::read(char to[], int count) {
    const auto wanted = static_cast<std::uint64_t>(count);
    if (count < 0 || at_ > bytes_.size() || wanted > bytes_.size() - at_) {
        throw std::runtime_error("it ends too early");
    }
    std::memcpy(to, bytes_.data() + at_, wanted);
    at_ += wanted;
    return at_ < bytes_.size();
}

namespace {

void check_header(std::string_view bytes, const std::string& name) {
    if (bytes.size() < 8) throw std::runtime_error("it ends too early");
    int version = load<std::int32_t>(bytes.data() + 4);
    if (Imf::isTiled(version) || Imf::isMultiPart(version) || Imf::isNonImage(version)) {
        throw Error(fmt::format(
            "'{}' is a tiled, deep or multi-part EXR picture; only scan lines in one part are allowed", name));
    }
    ExrInput stream(bytes, name);
    stream.seekg(8);
    Imf::Header header;
    header.readFrom(stream, version);
    const auto& window = header.dataWindow();
    const auto columns = static_cast<std::int64_t>(window.max.x) - window.min.x + 1;
    const auto rows = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
    if (columns < 1 || rows < 1) throw std::runtime_error("its data window is empty");
    std::size_t cell_bytes = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        cell_bytes += it.channel().type == Imf::HALF ? 2 : 4;
    }
    const auto width = static_cast<std::size_t>(columns);
    const auto height = static_cast<std::size_t>(rows);
    check_picture_size(width, height, width * height * cell_bytes, bytes.size(), name);
}

std::vector<std::string> channel_names(const Imf::InputFile& file) {
    std::vector<std::string> names;
    const auto& list = file.header().channels();
    for (auto it = list.begin(); it != list.end(); ++it) names.emplace_back(it.name());
    return names;
}

// The values of the named channels as the file has them: top line first.
std::vector<std::vector<float>> read_planes(Imf::InputFile& file, const std::vector<std::string>& names) {
    const auto window = file.header().dataWindow();
    const auto count = static_cast<std::size_t>(window.max.x - window.min.x + 1) *
                       static_cast<std::size_t>(window.max.y - window.min.y + 1);
    std::vector<std::vector<float>> planes(names.size(), std::vector<float>(count));
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto& found = file.header().channels()[names[i]];
        if (found.xSampling != 1 || found.ySampling != 1)
            throw std::runtime_error("subsampled channels cannot be read");
        buffer.insert(names[i], Imf::Slice::Make(Imf::FLOAT, planes[i].data(), window));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return planes;
}

Attributes texts_of(const Imf::Header& header) {
    Attributes texts;
    for (auto it = header.begin(); it != header.end(); ++it) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
        if (text != nullptr) texts[it.name()] = text->value();
    }
    return texts;
}

using Choose = std::function<std::vector<std::string>(const std::vector<std::string>&, const Attributes&)>;

ExrPicture read_picture(std::string_view bytes, const std::string& name, const Choose& choose) {
    check_header(bytes, name);
    ExrInput stream(bytes, name);
    Imf::InputFile file(stream, 0);
    const auto window = file.header().dataWindow();
    auto texts = texts_of(file.header());
    ExrPicture picture{static_cast<std::size_t>(window.max.x - window.min.x) + 1,
                       static_cast<std::size_t>(window.max.y - window.min.y) + 1,
                       choose(channel_names(file), texts),
                       {},
                       std::move(texts)};
    for (const auto& plane : read_planes(file, picture.names)) {
        auto& values = picture.values.emplace_back(plane.size());
        for (std::size_t line = 0; line < picture.rows; ++line) {
            const auto* const from = plane.data() + line * picture.columns;
            std::copy(from, from + picture.columns, values.data() + (picture.rows - 1 - line) * picture.columns);
        }
    }
    return picture;
}

// Everything OpenEXR throws means one thing here.
template <class Work>
auto naming_the_file(const std::string& name, const Work& work) {
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error(fmt::format("'{}' is a corrupted EXR picture: {}", name, problem.what()));
    }
}

}  // namespace

ExrPicture parse_exr_picture(std::string_view bytes, const std::string& name) {
    return naming_the_file(
        name, [&] { return read_picture(bytes, name, [](const auto& names, const auto&) { return names; }); });
}

ExrPicture read_exr(const std::filesystem::path& path) { return parse_exr_picture(read_file(path), path.string()); }

Field parse_exr(std::string_view bytes, const std::string& channel, const std::string& name) {
    auto picture = naming_the_file(name, [&] {
        return read_picture(bytes, name, [&](const auto& names, const Attributes& texts) {
            const auto chemicals = texts.find(exr_chemicals);
            return wanted_channels(names, chemicals == texts.end() ? "" : chemicals->second, channel, name);
        });
    });
    auto& values = picture.values;
    if (values.size() == 3) {
        for (std::size_t i = 0; i < values[0].size(); ++i)
            values[0][i] = luminance(values[0][i], values[1][i], values[2][i]);
    }
    return {picture.columns, picture.rows, std::move(values[0])};
}

}  // namespace pelage
