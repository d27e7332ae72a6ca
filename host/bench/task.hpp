// One piece of work as one backend does it: what `pelage bench` compares, then times.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pelage::bench {

// A result as bare words, so that equality means equality of bits.
struct Array {
    std::string name;
    std::vector<std::uint32_t> words;
    bool numbers = true;  // the words are floats
};
using Outcome = std::vector<Array>;

template <class Values>
Array float_array(std::string name, const Values& values) {
    Array array{std::move(name), {}, true};
    array.words.reserve(values.size());
    for (const auto value : values) array.words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    return array;
}

class Task {
public:
    Task() = default;
    virtual ~Task() = default;
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

    // Carries out that many iterations and waits until they are done.
    virtual void work(std::uint64_t iterations) = 0;
    virtual void restart() = 0;  // back to the first state
    virtual Outcome outcome() const = 0;

    // Bytes the task holds for its state, where it can tell; else 0.
    virtual std::size_t bytes_held() const { return 0; }
};

// Empty when both agree in every bit and the result says something; else the first difference in words. `initial` is
// what the result must have moved away from (an Outcome without arrays: no such demand).
std::string disagreement(const Outcome& initial, const Outcome& expected, const Outcome& found);

// A backend that has an answer to a case: what it is called and how to make its task.
struct Contender {
    std::string backend;     // "reference", "openmp", "opencl", ...
    std::string device;      // its name
    bool exact = true;       // must agree in every bit; otherwise the largest difference is reported only
    bool threads = false;    // of OpenMP, which spin for some milliseconds after their work
    bool in_memory = false;  // its buffers lie in this process's memory
    std::function<std::unique_ptr<Task>()> make;
    bool twin = false;  // as much work on other contents: compared with nothing
};

}  // namespace pelage::bench
