// See archive.hpp. Format: PKWARE's APPNOTE 6.3, sections 4.3.7, 4.3.12 and 4.3.16. The list at the end of the file is
// believed, not what stands before each packed file.
#include "io/archive.hpp"

#include "core/error.hpp"
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>

namespace pelage {

namespace {

constexpr std::string_view entry_magic{"PK\x01\x02", 4};
constexpr std::string_view end_magic{"PK\x05\x06", 4};
constexpr std::size_t entry_size = 46, end_size = 22, local_size = 30;  // without names

struct Entry {
    std::string name;
    unsigned flags = 0, method = 0;
    std::uint32_t checksum = 0;
    std::size_t packed = 0, size = 0, local = 0;
};

class ZipReader {
public:
    ZipReader(std::string_view bytes, const std::string& name, std::size_t most)
        : bytes_(bytes), name_(name), left_(most) {}

    std::map<std::string, std::string> read() {
        const std::size_t end = find_end();
        const std::size_t count = number<std::uint16_t>(end + 10);
        std::size_t at = number<std::uint32_t>(end + 16);
        std::map<std::string, std::string> files;
        for (std::size_t i = 0; i < count; ++i) {
            const Entry entry = read_entry(at);
            if (entry.name.ends_with('/')) continue;
            if (entry.size > left_) fail("it holds more than any network needs");
            left_ -= entry.size;
            if (!files.emplace(entry.name, unpacked(entry)).second)
                fail(fmt::format("it holds '{}' twice", entry.name));
        }
        return files;
    }

private:
    std::size_t find_end() const {
        if (bytes_.size() < end_size) fail("it is truncated");
        const std::size_t end = bytes_.rfind(end_magic, bytes_.size() - end_size);
        if (end == std::string_view::npos) fail("it is truncated: the list of its files is missing");
        return end;
    }

    Entry read_entry(std::size_t& at) const {
        if (piece(at, entry_size).substr(0, 4) != entry_magic) fail("the list of its files is damaged");
        Entry entry;
        entry.flags = number<std::uint16_t>(at + 8);
        entry.method = number<std::uint16_t>(at + 10);
        entry.checksum = number<std::uint32_t>(at + 16);
        entry.packed = number<std::uint32_t>(at + 20);
        entry.size = number<std::uint32_t>(at + 24);
        entry.local = number<std::uint32_t>(at + 42);
        const std::size_t name = number<std::uint16_t>(at + 28);
        const std::size_t extra = number<std::uint16_t>(at + 30), comment = number<std::uint16_t>(at + 32);
        entry.name = std::string(piece(at + entry_size, name));
        at += entry_size + name + extra + comment;
        return entry;
    }

    std::string unpacked(const Entry& entry) const {
        constexpr unsigned encrypted = 1, stored = 0, deflated = 8;
        if ((entry.flags & encrypted) != 0) fail(fmt::format("'{}' in it is encrypted", entry.name));
        const std::size_t before =
            local_size + number<std::uint16_t>(entry.local + 26) + number<std::uint16_t>(entry.local + 28);
        const std::string_view packed = piece(entry.local + before, entry.packed);
        std::string content;
        if (entry.method == stored)
            content = std::string(packed);
        else if (entry.method == deflated)
            content = inflated(packed, entry);
        else
            fail(fmt::format("'{}' in it is packed by method {}; allowed are 0 (stored) and 8 (deflate)", entry.name,
                             entry.method));
        const auto* data = reinterpret_cast<const Bytef*>(content.data());
        if (content.size() != entry.size || crc32(0, data, static_cast<uInt>(content.size())) != entry.checksum)
            fail(fmt::format("'{}' in it is damaged", entry.name));
        return content;
    }

    // Never more than the size that the list of files gives.
    std::string inflated(std::string_view packed, const Entry& entry) const {
        std::string content(entry.size, '\0');
        z_stream stream{};
        constexpr int without_header = -15;
        if (inflateInit2(&stream, without_header) != Z_OK) fail("zlib has no memory for it");
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
        stream.avail_in = static_cast<uInt>(packed.size());
        stream.next_out = reinterpret_cast<Bytef*>(content.data());
        stream.avail_out = static_cast<uInt>(content.size());
        const int result = inflate(&stream, Z_FINISH);
        const std::size_t made = stream.total_out;
        inflateEnd(&stream);
        if (result != Z_STREAM_END || made != content.size()) fail(fmt::format("'{}' in it is damaged", entry.name));
        return content;
    }

    std::string_view piece(std::size_t at, std::size_t size) const {
        if (at > bytes_.size() || size > bytes_.size() - at) fail("it is damaged: it points behind its end");
        return bytes_.substr(at, size);
    }
    template <class Integer>
    Integer number(std::size_t at) const {
        return load<Integer>(piece(at, sizeof(Integer)).data());
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(fmt::format("'{}' cannot be read as a zip archive: {}", name_, what));
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t left_;
};

// Little-endian.
void put(std::string& to, std::size_t number, std::size_t bytes) {
    for (; bytes > 0; --bytes, number >>= 8) to += static_cast<char>(number & 0xff);
}

// What stands before a file and in the list of files alike, from "version needed" to the length of the extra field.
void put_facts(std::string& to, const std::string& name, const std::string& content) {
    constexpr std::size_t version = 20, first_of_january_1980 = 0x21;
    const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
    put(to, version, 2);
    put(to, 0, 6);  // no flags, stored, midnight
    put(to, first_of_january_1980, 2);
    put(to, sum, 4);
    put(to, content.size(), 4);
    put(to, content.size(), 4);
    put(to, name.size(), 2);
    put(to, 0, 2);
}

}  // namespace

std::string zip_of(const std::map<std::string, std::string>& files) {
    std::string all, list;
    for (const auto& [name, content] : files) {
        list += entry_magic;
        put(list, 20, 2);  // made by version 2.0
        put_facts(list, name, content);
        put(list, 0, 10);  // no comment, first disk, no attributes
        put(list, all.size(), 4);
        list += name;
        all += zip_magic;
        put_facts(all, name, content);
        all += name + content;
    }
    const std::size_t begin = all.size();
    all += list;
    all += end_magic;
    put(all, 0, 4);
    put(all, files.size(), 2);
    put(all, files.size(), 2);
    put(all, list.size(), 4);
    put(all, begin, 4);
    put(all, 0, 2);
    return all;
}

std::map<std::string, std::string> parse_zip(std::string_view bytes, const std::string& name, std::size_t most) {
    return ZipReader(bytes, name, most).read();
}

}  // namespace pelage
