// See lz_text.hpp.
#include "import/lz_text.hpp"

#include <cstdint>
#include <vector>

namespace pelage::imports {

namespace {

constexpr std::string_view lz_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-$";

// Bits of a code come with the lowest one first, those of a character with the highest.
class BitReader {
public:
    explicit BitReader(std::string_view text) : text_(text) {}

    std::optional<std::uint32_t> bits(int count) {
        std::uint32_t value = 0;
        for (int i = 0; i < count; ++i) {
            if (left_ == 0 && !next_digit()) return std::nullopt;
            value |= (digit_ >> --left_ & 1u) << i;
        }
        return value;
    }

private:
    bool next_digit() {
        if (at_ == text_.size()) return false;
        const char c = text_[at_++] == ' ' ? '+' : text_[at_ - 1];  // a blank is a '+' in an address
        const std::size_t digit = lz_digits.find(c);
        if (digit == std::string_view::npos) return false;
        digit_ = static_cast<std::uint32_t>(digit);
        left_ = 6;
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::uint32_t digit_ = 0;
    int left_ = 0;
};

void append_utf8(std::string& text, std::uint32_t code) {
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80u) return add(code);
    if (code < 0x800u) {
        add(0xc0u | code >> 6);
    } else {
        if (code < 0x10000u) {
            add(0xe0u | code >> 12);
        } else {
            add(0xf0u | code >> 18);
            add(0x80u | (code >> 12 & 0x3fu));
        }
        add(0x80u | (code >> 6 & 0x3fu));
    }
    add(0x80u | (code & 0x3fu));
}

using Word = std::u16string;

class LzReader {
public:
    LzReader(std::string_view compressed, std::size_t most) : reader_(compressed), most_(most) {}

    std::optional<Word> read() {
        const auto first = reader_.bits(2);
        if (!first) return std::nullopt;
        if (*first == 2) return Word();
        Word last;
        if (*first > 1 || !letter(*first, last)) return std::nullopt;
        words_.push_back(last);
        result_ = last;
        while (true) {
            const auto code = reader_.bits(width_);
            if (!code) return std::nullopt;
            if (*code == 2) return result_;
            Word word;
            if (!word_of(*code, last, word)) return std::nullopt;
            result_ += word;
            if (result_.size() > most_) return std::nullopt;
            if (!last.empty()) remember(last + word[0]);
            last = std::move(word);
        }
    }

private:
    static constexpr std::size_t first_word = 3;  // the codes below are letters of 8 and 16 bits, and the end

    bool letter(std::uint32_t kind, Word& word) {
        const auto bits = reader_.bits(kind == 0 ? 8 : 16);
        if (bits) word = Word(1, static_cast<char16_t>(*bits));
        return bits.has_value();
    }

    bool word_of(std::uint32_t code, const Word& last, Word& word) {
        if (code < 2) {
            if (!letter(code, word)) return false;
            remember(word);
            return true;
        }
        const std::size_t index = code - first_word;
        if (index < words_.size()) {
            word = words_[index];
            return true;
        }
        word = last + last[0];
        return index == words_.size();
    }

    // Codes grow by a bit whenever so many more words are known; a new letter counts as well.
    void remember(Word word) {
        memory_ += word.size();
        if (memory_ <= 8 * most_) words_.push_back(std::move(word));
        if (--room_ == 0) room_ = std::size_t{1} << width_++;
    }

    BitReader reader_;
    std::size_t most_;
    std::vector<Word> words_;
    Word result_;
    std::size_t memory_ = 0;
    std::size_t room_ = 4;
    int width_ = 3;
};

}  // namespace

std::optional<std::string> from_lz_text(std::string_view compressed, std::size_t most) {
    const auto wide = LzReader(compressed, most).read();
    if (!wide) return std::nullopt;
    std::string text;
    for (std::size_t i = 0; i < wide->size(); ++i) {
        const std::uint32_t code = (*wide)[i];
        const bool pair = code >= 0xd800u && code < 0xdc00u && i + 1 < wide->size();
        const std::uint32_t second = pair ? (*wide)[i + 1] : 0u;
        const bool whole = second >= 0xdc00u && second < 0xe000u;
        append_utf8(text, whole ? 0x10000u + ((code - 0xd800u) << 10) + (second - 0xdc00u) : code);
        i += whole ? 1 : 0;
    }
    return text;
}

}  // namespace pelage::imports
