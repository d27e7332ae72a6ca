// Runs the kernel `faulty` of one file as every kernel of verification is run, so that a checker can look at it:
//   faulty_kernel FILE.cl
// Arguments: 64 ints that are written, 64 of the result, 64 that nobody ever writes; groups of 16 work-items.
#include "core/error.hpp"
#include "opencl/device/launch.hpp"
#include "opencl/device/session.hpp"

#include <fstream>
#include <iostream>
#include <iterator>
#include <numeric>
#include <vector>

namespace {

constexpr std::size_t count = 64;

void run(const std::string& source) {
    pelage::OpenclOptions options;
    options.guarded = true;
    options.use_cache = false;
    const pelage::Session on(pelage::select_device(), options);
    cl::Kernel kernel(on.build(source), "faulty");
    const std::size_t bytes = count * sizeof(cl_int);
    const cl::Buffer given = on.buffer(bytes, "given values");
    const cl::Buffer result = on.buffer(bytes, "results");
    const cl::Buffer unknown = on.buffer(bytes, "values that nobody writes");
    std::vector<cl_int> values(count);
    std::iota(values.begin(), values.end(), 0);
    on.queue().enqueueWriteBuffer(given, CL_TRUE, 0, bytes, values.data());
    pelage::Arguments(on, kernel).add(given, result, unknown);
    pelage::launch(on, kernel, count, 16);
    on.queue().enqueueReadBuffer(result, CL_TRUE, 0, bytes, values.data());
}

}  // namespace

int main(int count_of_words, char** words) {
    if (count_of_words != 2) return 2;
    try {
        std::ifstream file(words[1]);
        run({std::istreambuf_iterator<char>(file), {}});
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
