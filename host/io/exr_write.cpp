// See exr.hpp.
#include "core/error.hpp"
#include "io/exr.hpp"
#include "io/exr_stream.hpp"
#include "io/utf8.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>
#include <half.h>
#include <algorithm>
#include <thread>

namespace pelage {
namespace {

constexpr std::size_t lines_at_once = 256;                          // a multiple of the 16 lines of a ZIP block
constexpr std::size_t pixels_worth_threads = std::size_t{1} << 18;  // pixels

Imf::PixelType pixel_type(const ExrChannel& channel) { return channel.type == ExrType::half ? Imf::HALF : Imf::FLOAT; }

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
        header.channels().insert(channel.name, Imf::Channel(pixel_type(channel)));
    }
    for (const auto& [name, text] : attributes) {
        if (header.find(name) != header.end()) throw Error(fmt::format("attribute '{}' is one of EXR's own", name));
        header.insert(name, Imf::StringAttribute(valid_utf8(text)));
    }
    return header;
}

// Some lines of one channel as the file keeps them.
class Plane {
public:
    Plane(const ExrChannel& channel, std::size_t columns, std::size_t rows)
        : channel_(channel), columns_(columns), rows_(rows) {
        const auto size = columns * std::min(rows, lines_at_once);
        if (channel.type == ExrType::half)
            halves_.resize(size);
        else
            floats_.resize(size);
    }

    // The picture's lines first .. first + count - 1, from the top.
    Imf::Slice take(std::size_t first, std::size_t count) {
        return channel_.type == ExrType::half ? take(halves_, first, count) : take(floats_, first, count);
    }

private:
    template <class Sample>
    Imf::Slice take(std::vector<Sample>& samples, std::size_t first, std::size_t count) {
        for (std::size_t line = 0; line < count; ++line) {
            const double* const from = channel_.values.data() + (rows_ - 1 - first - line) * columns_;
            std::transform(from, from + columns_, samples.begin() + static_cast<std::ptrdiff_t>(line * columns_),
                           [](double value) { return static_cast<Sample>(static_cast<float>(value)); });
        }
        return Imf::Slice::Make(pixel_type(channel_), samples.data(), Imath::V2i(0, static_cast<int>(first)),
                                static_cast<std::int64_t>(columns_), static_cast<std::int64_t>(count));
    }

    const ExrChannel& channel_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<float> floats_;
    std::vector<half> halves_;
};

void write_pixels(Imf::OutputFile& file, std::size_t columns, std::size_t rows,
                  const std::vector<ExrChannel>& channels) {
    std::vector<Plane> planes;
    planes.reserve(channels.size());
    for (const auto& channel : channels) planes.emplace_back(channel, columns, rows);
    for (std::size_t first = 0; first < rows; first += lines_at_once) {
        const auto count = std::min(lines_at_once, rows - first);
        Imf::FrameBuffer buffer;
        for (std::size_t i = 0; i < channels.size(); ++i) buffer.insert(channels[i].name, planes[i].take(first, count));
        file.setFrameBuffer(buffer);
        file.writePixels(static_cast<int>(count));
    }
}

// Threads that compress, beside the one that writes; the library keeps them for all its files.
int helping_threads(std::size_t pixels) {
    if (pixels < pixels_worth_threads) return 0;
    static const int count = [] {
        const auto threads = static_cast<int>(std::min(16u, std::thread::hardware_concurrency()));
        if (threads < 2) return 0;
        try {
            Imf::setGlobalThreadCount(threads);
            return threads;
        } catch (const std::exception&) {  // the system grants no more threads
            return 0;
        }
    }();
    return count;
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
        Imf::OutputFile file(stream, header, helping_threads(columns * rows));
        write_pixels(file, columns, rows, channels);
    } catch (const std::exception& problem) {
        if (!aside.failure().empty()) throw Error(aside.failure());  // OpenEXR words it anew
        throw Error(fmt::format("cannot write '{}': {}", path.string(), problem.what()));
    }
    aside.commit();  // throws, too, when OpenEXR's destructor could not write
}

}  // namespace pelage
