// The few calls that a pickle of arrays makes.
#pragma once

#include "io/pickle_value.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pelage {

class PickleCalls {
public:
    // `name`: the file's, for messages. `most`: bytes that may be decoded from text.
    PickleCalls(PickleHeap& heap, const std::string& name, std::size_t most) : heap_(heap), name_(name), left_(most) {}

    PickleValue* function(const std::string& module, const std::string& function);
    PickleValue* call(const PickleValue& function, const PickleValue& arguments);
    void build(PickleValue& what, const PickleValue& state) const;

private:
    PickleValue* decoded(const PickleValue& arguments);
    PickleValue* from_buffer(const PickleValue& arguments) const;
    std::vector<std::size_t> shape_of(const PickleValue& list) const;
    void build_array(PickleValue& array, const PickleValue& state) const;
    [[noreturn]] void fail(const std::string& what) const;

    PickleHeap& heap_;
    const std::string& name_;
    std::size_t left_;
};

[[noreturn]] void pickle_refused(const std::string& name, const std::string& what);

}  // namespace pelage
