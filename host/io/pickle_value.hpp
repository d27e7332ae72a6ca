// What a pickle of arrays is made of.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

struct PickleValue {
    enum class Kind {
        nothing,   // None
        number,    // a truth counts as 0 or 1
        text,      // characters or bytes: `bytes`
        list,      // list or tuple: `parts`
        function,  // `bytes` is "MODULE.NAME"
        type,      // of an array's numbers: `bytes` as in "f4", `little` once it is known
        array      // `bytes` or, of objects, `parts`; `shape`
    };
    Kind kind = Kind::nothing;
    std::int64_t number = 0;
    std::string_view bytes;
    std::vector<const PickleValue*> parts;
    std::vector<std::size_t> shape;
    const PickleValue* type = nullptr;  // of an array; null: not known yet
    bool little = false;
    bool fortran = false;
};

// All values live as long as this, so that lists may hold themselves.
struct PickleHeap {
    std::deque<PickleValue> values;
    std::deque<std::string> texts;  // those that are not in the file as they are

    PickleValue* make(PickleValue::Kind kind) {
        values.emplace_back().kind = kind;
        return &values.back();
    }
};

}  // namespace pelage
