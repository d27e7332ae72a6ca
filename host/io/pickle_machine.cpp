// See pickle_machine.hpp. Format: Python's pickletools.
#include "io/pickle_machine.hpp"

#include "io/file_bytes.hpp"
#include "io/pickle_build.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <vector>

namespace pelage {

namespace {

using Kind = PickleValue::Kind;

class PickleMachine {
public:
    PickleMachine(std::string_view bytes, const std::string& name, PickleHeap& heap)
        : bytes_(bytes), name_(name), heap_(heap), calls_(heap, name, bytes.size()) {}

    const PickleValue& run() {
        while (true) {
            const auto code = read<std::uint8_t>();
            if (code == '.') return *pop();
            if (code == 0x97 || code == 0x98) fail("its numbers lie outside of it, in buffers of protocol 5");
            if (!push_plain(code) && !push_text(code) && !handle_memory(code) && !handle_structure(code))
                fail(
                    fmt::format("it asks for operation 0x{:02x}; a model needs none but those that make arrays", code));
        }
    }

private:
    bool push_plain(unsigned code) {
        switch (code) {
            case 'N':
                push(heap_.make(Kind::nothing));
                return true;
            case 0x88:
            case 0x89:
                return push_number(code == 0x88 ? 1 : 0);
            case 'K':
                return push_number(read<std::uint8_t>());
            case 'M':
                return push_number(read<std::uint16_t>());
            case 'J':
                return push_number(read<std::int32_t>());
            case 0x8a:
                return push_number(long_number());
            default:
                return false;
        }
    }

    bool push_text(unsigned code) {
        switch (code) {
            case 'U':
            case 'C':
            case 0x8c:
                return push_piece(read<std::uint8_t>());
            case 'T':
            case 'B':
            case 'X':
                return push_piece(read<std::uint32_t>());
            case 0x8d:
            case 0x8e:
            case 0x96:
                return push_piece(read<std::uint64_t>());
            default:
                return false;
        }
    }

    bool handle_memory(unsigned code) {
        switch (code) {
            case 'q':
                memory_[read<std::uint8_t>()] = top();
                return true;
            case 'r':
                memory_[read<std::uint32_t>()] = top();
                return true;
            case 0x94:
                memory_[static_cast<std::uint32_t>(memory_.size())] = top();
                return true;
            case 'h':
                return recall(read<std::uint8_t>());
            case 'j':
                return recall(read<std::uint32_t>());
            case 0x80:
                return protocol(read<std::uint8_t>());
            case 0x95:
                read<std::uint64_t>();  // the length of a frame, which only saves a reader's time
                return true;
            default:
                return false;
        }
    }

    bool handle_structure(unsigned code) {
        switch (code) {
            case '(':
                marks_.push_back(stack_.size());
                return true;
            case ')':
            case ']':
                push(heap_.make(Kind::list));
                return true;
            case 't':
                return push_list(stack_.size() - pop_mark());
            case 0x85:
            case 0x86:
            case 0x87:
                return push_list(code - 0x84);
            case 'a':
                return append(1);
            case 'e':
                return append(stack_.size() - pop_mark());
            case 'c':
            case 0x93:
                return push_function(code == 'c');
            case 'R':
            case 'b':
                return call(code == 'R');
            default:
                return false;
        }
    }

    bool protocol(unsigned version) {
        if (version < 2 || version > 5) fail(fmt::format("its protocol is {}; allowed are 2 to 5", version));
        return true;
    }

    bool push_number(std::int64_t number) {
        PickleValue* value = heap_.make(Kind::number);
        value->number = number;
        return push(value);
    }
    bool push_piece(std::uint64_t size) {
        PickleValue* value = heap_.make(Kind::text);
        value->bytes = piece(size);
        return push(value);
    }

    std::int64_t long_number() {
        const std::string_view digits = piece(read<std::uint8_t>());
        if (digits.size() > 8) fail("it holds a whole number that is too large");
        std::uint64_t number = digits.empty() || (static_cast<unsigned char>(digits.back()) & 0x80u) == 0 ? 0 : ~0ull;
        for (std::size_t i = digits.size(); i-- > 0;) number = number << 8 | static_cast<unsigned char>(digits[i]);
        return static_cast<std::int64_t>(number);
    }

    bool recall(std::uint32_t place) {
        const auto found = memory_.find(place);
        if (found == memory_.end()) fail("it refers to what is not there");
        return push(found->second);
    }

    std::size_t pop_mark() {
        if (marks_.empty() || marks_.back() > stack_.size()) fail("it is damaged: a list has no begin");
        const std::size_t mark = marks_.back();
        marks_.pop_back();
        return mark;
    }

    bool push_list(std::size_t count) {
        PickleValue* list = heap_.make(Kind::list);
        take(count, *list);
        return push(list);
    }
    bool append(std::size_t count) {
        if (count >= stack_.size()) fail("it is damaged: it appends to nothing");
        PickleValue* list = stack_[stack_.size() - count - 1];
        if (list->kind != Kind::list) fail("it appends to what is no list");
        take(count, *list);
        return true;
    }
    void take(std::size_t count, PickleValue& list) {
        if (count > stack_.size()) fail("it is damaged: a list lacks its parts");
        list.parts.insert(list.parts.end(), stack_.end() - static_cast<std::ptrdiff_t>(count), stack_.end());
        stack_.resize(stack_.size() - count);
    }

    bool push_function(bool in_lines) {
        if (in_lines) {
            const std::string module = line();
            return push(calls_.function(module, line()));
        }
        const PickleValue* function = pop();
        const PickleValue* module = pop();
        if (function->kind != Kind::text || module->kind != Kind::text) fail("it asks for what has no name");
        return push(calls_.function(std::string(module->bytes), std::string(function->bytes)));
    }
    std::string line() {
        const std::size_t end = bytes_.find('\n', at_);
        if (end == std::string_view::npos) fail("it is truncated");
        const std::string_view text = piece(end - at_);
        ++at_;
        return std::string(text);
    }

    bool call(bool function) {
        const PickleValue* state = pop();
        if (function) return push(calls_.call(*pop(), *state));
        calls_.build(*top(), *state);
        return true;
    }

    bool push(PickleValue* value) {
        stack_.push_back(value);
        return true;
    }
    PickleValue* top() const {
        if (stack_.empty()) fail("it is damaged: it uses what is not there");
        return stack_.back();
    }
    PickleValue* pop() {
        PickleValue* value = top();
        stack_.pop_back();
        return value;
    }

    std::string_view piece(std::uint64_t size) {
        if (size > bytes_.size() - at_) fail("it is truncated");
        const std::string_view found = bytes_.substr(at_, static_cast<std::size_t>(size));
        at_ += found.size();
        return found;
    }
    template <class Integer>
    Integer read() {
        return load<Integer>(piece(sizeof(Integer)).data());
    }
    [[noreturn]] void fail(const std::string& what) const { pickle_refused(name_, what); }

    std::string_view bytes_;
    const std::string& name_;
    PickleHeap& heap_;
    PickleCalls calls_;
    std::size_t at_ = 0;
    std::vector<PickleValue*> stack_;
    std::vector<std::size_t> marks_;
    std::map<std::uint32_t, PickleValue*> memory_;
};

}  // namespace

const PickleValue& run_pickle(std::string_view bytes, const std::string& name, PickleHeap& heap) {
    return PickleMachine(bytes, name, heap).run();
}

}  // namespace pelage
