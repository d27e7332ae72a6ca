// A checksum of a stream of bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pelage {

// FNV-1a over 64-bit little-endian words, the last one filled up with zeros, and then over the number of bytes; after
// each word the upper half is mixed into the lower one. Any change within one word changes the sum.
class Checksum {
public:
    void add(const void* bytes, std::size_t count) {
        const auto* from = static_cast<const char*>(bytes);
        total_ += count;
        while (count != 0 && filled_ != 0) {
            put(*from++);
            --count;
        }
        for (; count >= word_size; count -= word_size, from += word_size) {
            std::uint64_t word;
            std::memcpy(&word, from, word_size);
            mix(word);
        }
        while (count-- != 0) put(*from++);
    }

    std::uint64_t value() const {
        Checksum end = *this;
        while (end.filled_ != 0) end.put('\0');
        end.mix(total_);
        return end.sum_;
    }

private:
    static constexpr std::size_t word_size = 8;

    void put(char byte) {
        word_[filled_++] = byte;
        if (filled_ < word_size) return;
        std::uint64_t word;
        std::memcpy(&word, word_.data(), word_size);
        filled_ = 0;
        mix(word);
    }
    void mix(std::uint64_t word) {
        sum_ = (sum_ ^ word) * 0x100000001b3u;
        sum_ ^= sum_ >> 32;
    }

    std::uint64_t sum_ = 0xcbf29ce484222325u;
    std::uint64_t total_ = 0;
    std::array<char, word_size> word_{};
    std::size_t filled_ = 0;
};

}  // namespace pelage
