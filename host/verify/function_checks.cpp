// See check.hpp: elementary functions, on the device and in the reference.
#include "core/functions.hpp"
#include "core/subnormal.hpp"
#include "opencl/device/cl_error.hpp"
#include "opencl/device/kernel_sources.hpp"
#include "opencl/device/program.hpp"
#include "opencl/rules/functions.hpp"
#include "reference/rules/functions.hpp"
#include "verify/arguments.hpp"
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <string>

namespace pelage::verify {

namespace {

// One kernel a function, all in one program: a device compiles it once for each precision and width.
std::string source_of_all() {
    std::set<std::size_t> all;
    for (std::size_t index = 0; index < function_table().size(); ++index) all.insert(index);
    Source source;
    source.file("common/prelude.cl");
    for (const std::string& file : function_files(all)) source.file(file);
    for (const FunctionFacts& function : function_table()) {
        std::string arguments = "LOAD(a + i)";
        for (std::size_t place = 1; place < function.parameters.size(); ++place)
            arguments += fmt::format(", LOAD({} + i)", "abc"[place]);
        source.text(
            fmt::format("kernel void pelage_check_{0}(global const scalar* a, global const scalar* b, global "
                        "const scalar* c, global scalar* out) {{\n"
                        "    const size_t i = get_global_id(0) * PELAGE_WIDTH;\n"
                        "    STORE(pelage_{0}({1}), out + i);\n}}\n",
                        function.name, arguments));
    }
    return source.str();
}

// Those that the text of a function names: where it goes another way something may be wrong with the number itself.
std::vector<double> numbers_named(std::size_t index) {
    static const std::regex number(R"(0x[0-9a-f]+(\.[0-9a-f]+)?p[+-]?\d+|\b\d+\.\d+|R\(-?\d+\))");
    std::vector<double> found;
    for (const std::string& file : function_files({index})) {
        const std::string& text = embedded_kernels().at(file);
        for (auto at = std::sregex_iterator(text.begin(), text.end(), number); at != std::sregex_iterator(); ++at) {
            const std::string word = at->str();
            found.push_back(std::strtod(word.c_str() + (word.starts_with("R(") ? 2 : 0), nullptr));
        }
    }
    return found;
}

template <class T>
std::vector<T> on_device(const Session& on, std::size_t index, std::size_t width, const Arguments<T>& arguments) {
    return with_device(on.info().name, [&] {
        cl::Kernel kernel(on.build(source_of_all(), fmt::format("-DPELAGE_WIDTH={}", width)),
                          ("pelage_check_" + function_table()[index].name).c_str());
        const std::size_t bytes = arguments[0].size() * sizeof(T);
        std::vector<cl::Buffer> buffers;  // a kernel does not keep them
        for (const std::vector<T>& column : arguments) {
            buffers.push_back(on.buffer(bytes, "arguments"));
            on.queue().enqueueWriteBuffer(buffers.back(), CL_TRUE, 0, bytes, column.data());
            kernel.setArg(static_cast<cl_uint>(buffers.size() - 1), buffers.back());
        }
        const cl::Buffer out = on.buffer(bytes, "values of a function");
        on.poison_buffer(out, bytes);
        kernel.setArg(static_cast<cl_uint>(buffers.size()), out);
        on.launch(kernel, cl::NDRange(arguments[0].size() / width), cl::NDRange(1));
        std::vector<T> found(arguments[0].size());
        on.queue().enqueueReadBuffer(out, CL_TRUE, 0, bytes, found.data());
        return found;
    });
}

template <class T>
std::vector<T> in_reference(std::size_t index, const Arguments<T>& arguments) {
    const SubnormalsAreZero scope(sizeof(T) == sizeof(float));
    const std::array<const T*, 3> columns{arguments[0].data(), arguments[1].data(), arguments[2].data()};
    std::vector<T> expected(arguments[0].size());
    compute_function(index, columns.data(), expected.size(), expected.data());
    return expected;
}

// The first value that differs is told with its arguments.
template <class T>
void compare(Tally& tally, const Arguments<T>& arguments, const std::vector<T>& expected, const std::vector<T>& found,
             const std::string& what) {
    const bool equal_so_far = tally.equal();
    add(tally, expected, found, what);
    if (!equal_so_far || tally.equal()) return;
    const auto same = [](T a, T b) {
        return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
    };
    const auto differing = std::ranges::mismatch(expected, found, same).in1;
    const auto at = static_cast<std::size_t>(differing - expected.begin());
    tally.first +=
        fmt::format("; the arguments are {:a}, {:a}, {:a}", arguments[0][at], arguments[1][at], arguments[2][at]);
}

template <class T>
void compare_widths(Place& place, Precision precision, std::size_t index, Tally& tally) {
    const Session& on = place.session(precision);
    const FunctionFacts& function = function_table()[index];
    const bool narrow = sizeof(T) == sizeof(float) && !place.subnormal_difference().empty();
    const Arguments<T> arguments = drawn_arguments<T>(function.parameters.size(),
                                                      place.small()  ? 64
                                                      : place.full() ? 2097152
                                                                     : 65536,
                                                      place.seed(), narrow, numbers_named(index));
    const std::vector<T> expected = in_reference(index, arguments);
    const std::size_t lanes = sizeof(T) == sizeof(float) ? on.info().vector_width_float : on.info().vector_width_double;
    std::set<std::size_t> widths{std::clamp<std::size_t>(lanes, 1, 16)};
    if (place.full()) widths.merge(std::set<std::size_t>{1, 2});
    for (const std::size_t width : widths) {
        const std::string what = fmt::format("{} in {} precision, width {}", function.name,
                                             precision == Precision::double_ ? "double" : "single", width);
        compare(tally, arguments, expected, on_device(on, index, width, arguments), what);
    }
}

// Division and square root of the device itself, in single precision.
bool divides(const std::string& name) { return name == "mod" || name == "smoothstep" || name == "sqrt"; }

Outcome check_function(Place& place, std::size_t index) {
    Outcome outcome;
    if (place.device().correctly_rounded_divide_sqrt || !divides(function_table()[index].name))
        compare_widths<float>(place, Precision::single_, index, outcome.tally);
    if (place.device().fp64) compare_widths<double>(place, Precision::double_, index, outcome.tally);
    conclude(outcome);
    return outcome;
}

}  // namespace

std::vector<Check> function_checks() {
    std::vector<Check> checks;
    for (std::size_t index = 0; index < function_table().size(); ++index) {
        checks.push_back({"functions/" + function_table()[index].name, "functions", true,
                          [=](Place& place) { return check_function(place, index); }});
    }
    return checks;
}

}  // namespace pelage::verify
