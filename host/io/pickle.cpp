// See pickle.hpp. The state of an array is that of numpy.ndarray.__setstate__().
#include "io/pickle.hpp"

#include "io/number_type.hpp"
#include "io/pickle_build.hpp"
#include "io/pickle_machine.hpp"

#include <fmt/format.h>

namespace pelage {

namespace {

using Kind = PickleValue::Kind;

NumberType type_of(const PickleValue& array) {
    if (array.kind != Kind::array || array.type == nullptr || !array.type->little) return {};
    const std::string_view type = array.type->bytes;
    if (type == "f2") return half_type();
    if (type == "f4") return number_type<float>();
    return type == "f8" ? number_type<double>() : NumberType{};
}

NpyArray floats_of(const PickleValue& array, const std::string& name) {
    const NumberType type = type_of(array);
    if (type.size == 0) pickle_refused(name, "it holds something else than arrays of floats (f2, f4 or f8)");
    if (array.fortran && array.shape.size() > 1) pickle_refused(name, "an array of it is in Fortran order");
    std::size_t count = array.bytes.size() / type.size;
    NpyArray made{array.shape, {}};
    made.values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) made.values.push_back(type.load(array.bytes.data() + i * type.size));
    bool fits = array.bytes.size() % type.size == 0;
    for (const std::size_t length : made.shape) {
        fits = fits && (length == 0 ? count == 0 : count % length == 0);
        count = length == 0 ? 1 : count / length;
    }
    if (!fits || count != 1) pickle_refused(name, "an array of it has not as many numbers as its shape");
    return made;
}

}  // namespace

std::vector<NpyArray> parse_pickled_arrays(std::string_view bytes, const std::string& name) {
    constexpr std::size_t most = 16;  // a model has three
    PickleHeap heap;
    const PickleValue& found = run_pickle(bytes, name, heap);
    if (found.kind != Kind::list && found.kind != Kind::array) pickle_refused(name, "it holds no list of arrays");
    if (found.parts.empty() || found.parts.size() > most)
        pickle_refused(name, fmt::format("it holds {} arrays; a model has three", found.parts.size()));
    std::vector<NpyArray> arrays;
    for (const PickleValue* part : found.parts) arrays.push_back(floats_of(*part, name));
    return arrays;
}

}  // namespace pelage
