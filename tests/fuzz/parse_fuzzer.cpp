// Fuzzer of the experiment parser: any bytes must give an Experiment, with or without warnings, or an Error, nothing
// else.
#include "core/error.hpp"
#include "language/lint.hpp"
#include "language/parse.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

// Names that lead out of the folder that is not there: the fuzzer reads no file.
bool names_a_real_file(const std::string& text) {
    return text.find("\"/") != std::string::npos || text.find("..") != std::string::npos;
}

// A mesh is made while the text is read: large ones take longer than the fuzzer waits.
bool makes_a_large_mesh(const std::string& text) {
    if (text.find("icosphere") == std::string::npos && text.find("torus") == std::string::npos) return false;
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (digit(text[i]) && digit(text[i + 1]) && digit(text[i + 2])) return true;
    }
    const std::size_t sphere = text.find("icosphere");
    return sphere != std::string::npos && text.find_first_of("6789", sphere) != std::string::npos;
}

void check(const pelage::Experiment& experiment) {
    const bool sound = !experiment.chemicals.empty() && !experiment.phases.empty() && !experiment.outputs.empty() &&
                       experiment.stop_at <= pelage::largest_iteration;
    if (!sound) std::abort();
}

void check(const std::vector<pelage::Warning>& warnings) {
    for (const pelage::Warning& one : warnings) {
        if (one.line == 0 || one.column == 0 || one.text.empty()) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (names_a_real_file(text) || makes_a_large_mesh(text)) return -1;
    try {
        pelage::Outline outline;
        const pelage::Experiment experiment =
            pelage::parse_experiment(text, "fuzz.pex", "/folder/that/is/not/there", &outline);
        check(experiment);
        check(lint(experiment, outline, experiment.last_iteration()));
    } catch (const pelage::Error& error) {
        if (std::string(error.what()).rfind("fuzz.pex", 0) != 0) std::abort();
    }
    return 0;
}
