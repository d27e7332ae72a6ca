// See exr.hpp.
#include "core/error.hpp"
#include "io/exr.hpp"
#include "io/exr_stream.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <algorithm>

namespace pelage {
namespace {

constexpr std::size_t lines_at_once = 256;  // a multiple of the 16 lines of a ZIP block

Imf::Header make_header(std::size_t columns, std::size_t rows, const std::vector<ExrChannel>& channels,
                        const Attributes& attributes) {
    Imf::Header header(static_cast<int>(columns), static_cast<int>(rows));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& channel : channels) {
        if (channel.name.empty() || header.channels().findChannel(channel.name) != nullptr) {
            throw Error(fmt::format("'{}' is not the name of one channel only", channel.name));
        }
        if (channel.values.size() != columns * rows) {
            throw Error(fmt::format("channel '{}' has {} values; needed are {} x {}", channel.name,
                                    channel.values.size(), columns, rows));
        }
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    }
    for (const auto& [name, text] : attributes) {
        if (header.find(name) != header.end()) throw Error(fmt::format("attribute '{}' is one of EXR's own", name));
        header.insert(name, Imf::StringAttribute(text));
    }
    return header;
}

// The picture's lines first .. first + count - 1, from the top.
void copy_lines(const ExrChannel& channel, std::size_t columns, std::size_t rows, std::size_t first, std::size_t count,
                std::vector<float>& to) {
    for (std::size_t line = 0; line < count; ++line) {
        const double* const from = channel.values.data() + (rows - 1 - first - line) * columns;
        std::transform(from, from + columns, to.begin() + static_cast<std::ptrdiff_t>(line * columns),
                       [](double value) { return static_cast<float>(value); });
    }
}

void write_pixels(Imf::OutputFile& file, std::size_t columns, std::size_t rows,
                  const std::vector<ExrChannel>& channels) {
    std::vector<std::vector<float>> planes(channels.size(),
                                           std::vector<float>(columns * std::min(rows, lines_at_once)));
    for (std::size_t first = 0; first < rows; first += lines_at_once) {
        const auto count = std::min(lines_at_once, rows - first);
        Imf::FrameBuffer buffer;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            copy_lines(channels[i], columns, rows, first, count, planes[i]);
            const Imath::V2i origin(0, static_cast<int>(first));
            buffer.insert(channels[i].name,
                          Imf::Slice::Make(Imf::FLOAT, planes[i].data(), origin, static_cast<std::int64_t>(columns),
                                           static_cast<std::int64_t>(count)));
        }
        file.setFrameBuffer(buffer);
        file.writePixels(static_cast<int>(count));
    }
}

}  // namespace

void write_exr(const std::filesystem::path& path, std::size_t columns, std::size_t rows,
               const std::vector<ExrChannel>& channels, const Attributes& attributes) {
    if (columns == 0 || rows == 0 || columns > 0x7fffffff || rows > 0x7fffffff || channels.empty()) {
        throw Error(fmt::format("cannot write '{}': {} x {} pixels of {} channels do not make an EXR picture",
                                path.string(), columns, rows, channels.size()));
    }
    AtomicFile aside(path);
    try {
        const auto header = make_header(columns, rows, channels, attributes);
        ExrOutput stream(aside, path.string());
        Imf::OutputFile file(stream, header, 0);
        write_pixels(file, columns, rows, channels);
    } catch (const std::exception& problem) {
        if (!aside.failure().empty()) throw Error(aside.failure());  // OpenEXR words it anew
        throw Error(fmt::format("cannot write '{}': {}", path.string(), problem.what()));
    }
    aside.commit();  // throws, too, when OpenEXR's destructor could not write
}

}  // namespace pelage
