// See pickle_build.hpp.
#include "io/pickle_build.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pelage {

namespace {

using Kind = PickleValue::Kind;

constexpr std::array<std::string_view, 7> known_functions{"numpy.core.multiarray._reconstruct",
                                                          "numpy._core.multiarray._reconstruct",
                                                          "numpy.core.numeric._frombuffer",
                                                          "numpy._core.numeric._frombuffer",
                                                          "numpy.ndarray",
                                                          "numpy.dtype",
                                                          "_codecs.encode"};

bool is(const PickleValue& list, std::size_t place, Kind kind) {
    return list.kind == Kind::list && place < list.parts.size() && list.parts[place]->kind == kind;
}

}  // namespace

void pickle_refused(const std::string& name, const std::string& what) {
    throw Error(fmt::format("'{}' is pickled and is not read: {}", name, what));
}

void PickleCalls::fail(const std::string& what) const { pickle_refused(name_, what); }

PickleValue* PickleCalls::function(const std::string& module, const std::string& function) {
    const std::string full = module + "." + function;
    const auto found = std::ranges::find(known_functions, full);
    if (found == known_functions.end()) {
        constexpr std::size_t shown = 80;
        std::string told = full.substr(0, shown);
        for (char& letter : told) letter = letter < ' ' || letter > '~' ? '?' : letter;
        fail(fmt::format("it asks for '{}'; a model may hold arrays of floats and nothing else", told));
    }
    PickleValue* value = heap_.make(Kind::function);
    value->bytes = *found;
    return value;
}

PickleValue* PickleCalls::call(const PickleValue& function, const PickleValue& arguments) {
    if (function.kind != Kind::function || arguments.kind != Kind::list) fail("it calls what is no function");
    if (function.bytes == "_codecs.encode") return decoded(arguments);
    if (function.bytes == "numpy.dtype") {
        if (!is(arguments, 0, Kind::text)) fail("it asks for a type of numbers without a name");
        PickleValue* type = heap_.make(Kind::type);
        type->bytes = arguments.parts[0]->bytes;
        return type;
    }
    if (function.bytes.ends_with("_frombuffer")) return from_buffer(arguments);
    if (function.bytes == "numpy.ndarray") fail("it calls numpy.ndarray; a model's arrays are made by _reconstruct");
    if (!is(arguments, 0, Kind::function) || arguments.parts[0]->bytes != "numpy.ndarray")
        fail("it makes an array that is no numpy.ndarray");
    return heap_.make(Kind::array);
}

// Python 3 writes bytes for protocol 2 as text in which every character is a byte.
PickleValue* PickleCalls::decoded(const PickleValue& arguments) {
    if (!is(arguments, 0, Kind::text) || !is(arguments, 1, Kind::text) || arguments.parts[1]->bytes != "latin1")
        fail("it encodes a text otherwise than in latin1");
    const std::string_view text = arguments.parts[0]->bytes;
    if (text.size() > left_) fail("it encodes the same text again and again");
    left_ -= text.size();
    std::string& bytes = heap_.texts.emplace_back();
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto first = static_cast<unsigned char>(text[i]);
        if (first < 0x80) {
            bytes += text[i];
            continue;
        }
        const auto second = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
        if ((first != 0xc2 && first != 0xc3) || (second & 0xc0u) != 0x80) fail("it encodes a text that is not latin1");
        bytes += static_cast<char>((first & 3u) << 6 | (second & 0x3fu));
        ++i;
    }
    PickleValue* value = heap_.make(Kind::text);
    value->bytes = bytes;
    return value;
}

void PickleCalls::build(PickleValue& what, const PickleValue& state) const {
    if (what.kind == Kind::array) return build_array(what, state);
    if (what.kind != Kind::type || !is(state, 1, Kind::text))
        fail("it sets the state of what is neither array nor type");
    const std::string_view order = state.parts[1]->bytes;
    if (order == ">") fail("its numbers are big-endian; allowed are little-endian ones");
    what.little = true;
}

// An array of protocol 5: numbers, type, shape, and C or F for their order.
PickleValue* PickleCalls::from_buffer(const PickleValue& arguments) const {
    if (!is(arguments, 0, Kind::text) || !is(arguments, 1, Kind::type) || !is(arguments, 2, Kind::list) ||
        !is(arguments, 3, Kind::text) || arguments.parts.size() != 4) {
        fail("it makes an array of something else than numbers, type, shape and order");
    }
    const std::string_view order = arguments.parts[3]->bytes;
    if (order != "C" && order != "F") fail("it makes an array whose order is neither C nor F");
    PickleValue* array = heap_.make(Kind::array);
    array->shape = shape_of(*arguments.parts[2]);
    array->type = arguments.parts[1];
    array->fortran = order == "F";
    array->bytes = arguments.parts[0]->bytes;
    return array;
}

std::vector<std::size_t> PickleCalls::shape_of(const PickleValue& list) const {
    std::vector<std::size_t> shape;
    for (const PickleValue* length : list.parts) {
        if (length->kind != Kind::number || length->number < 0)
            fail("it holds an array whose shape is no list of lengths");
        shape.push_back(static_cast<std::size_t>(length->number));
    }
    return shape;
}

// The state of an array: version, shape, type, whether in Fortran order, numbers.
void PickleCalls::build_array(PickleValue& array, const PickleValue& state) const {
    if (!is(state, 1, Kind::list) || !is(state, 2, Kind::type) || !is(state, 3, Kind::number) ||
        state.parts.size() != 5) {
        fail("it holds an array whose state is not that of an array");
    }
    array.shape = shape_of(*state.parts[1]);
    array.type = state.parts[2];
    array.fortran = state.parts[3]->number != 0;
    const PickleValue& content = *state.parts[4];
    if (content.kind != Kind::text && content.kind != Kind::list) fail("it holds an array without numbers");
    array.bytes = content.bytes;
    array.parts = content.parts;
}

}  // namespace pelage
