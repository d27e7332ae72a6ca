// See causes.hpp.
#include "verify/causes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace pelage::verify {

namespace {

using Names = std::set<std::string, std::less<>>;

bool bad(const Result& result) { return result.verdict == Verdict::failed || result.verdict == Verdict::mistrusted; }

Names failed_kernels(const std::vector<Result>& results) {
    Names failed;
    for (const Result& result : results) {
        if (bad(result)) failed.insert(result.kernel);
    }
    return failed;
}

const Dependence* dependence(std::string_view kernel) {
    const auto at = std::ranges::find(dependences(), kernel, &Dependence::kernel);
    return at == dependences().end() ? nullptr : &*at;
}

bool rests_on_failed(std::string_view kernel, const Names& failed) {
    const Dependence* known = dependence(kernel);
    if (known == nullptr) return false;
    return std::ranges::any_of(
        known->uses, [&](std::string_view used) { return failed.contains(used) || rests_on_failed(used, failed); });
}

std::size_t place(const std::string& kernel) {
    const auto at = std::ranges::find(dependences(), kernel, &Dependence::kernel);
    return static_cast<std::size_t>(at - dependences().begin());
}

}  // namespace

const std::vector<Dependence>& dependences() {
    static const std::vector<Dependence> all{{"long loops", {}},
                                             {"subnormal numbers", {}},
                                             {"not finite", {}},
                                             {"functions", {}},
                                             {"random numbers", {}},
                                             {"scan", {}},
                                             {"sort", {"scan"}},
                                             {"neighbour search", {"sort"}},
                                             {"gather", {}},
                                             {"diffusion", {}},
                                             {"uneven rates", {"diffusion"}},
                                             {"polarity", {"uneven rates", "random numbers"}},
                                             {"reactions", {"diffusion"}},
                                             {"networks", {"functions", "diffusion"}},
                                             {"saturation", {"diffusion"}},
                                             {"special values", {"subnormal numbers", "diffusion"}},
                                             {"rules", {"functions", "random numbers", "reactions"}},
                                             {"expansion", {"diffusion", "random numbers"}},
                                             {"single steps", {"rules", "polarity", "expansion", "saturation"}},
                                             {"volumes", {"single steps", "networks"}},
                                             {"learning", {"functions", "diffusion"}},
                                             {"shared steps", {"single steps"}},
                                             {"streamed steps", {"single steps"}},
                                             {"tiled steps", {"single steps"}},
                                             {"batches", {"tiled steps"}},
                                             {"laws", {"single steps"}},
                                             {"checkpoints", {"single steps"}},
                                             {"cell step", {"neighbour search", "functions", "random numbers"}},
                                             {"division", {"cell step"}},
                                             {"generated cells", {"division"}},
                                             {"aggregates", {}},
                                             {"mesh step", {"gather", "functions", "random numbers"}},
                                             {"random experiments", {"single steps", "generated cells"}}};
    return all;
}

std::vector<std::string> likely_roots(const std::vector<Result>& results) {
    const Names failed = failed_kernels(results);
    std::vector<std::string> roots;
    for (const std::string& kernel : failed) {
        if (!rests_on_failed(kernel, failed)) roots.push_back(kernel);
    }
    std::ranges::stable_sort(roots, {}, place);
    return roots;
}

std::vector<Result> failures(const std::vector<Result>& results) {
    std::vector<Result> found;
    std::ranges::copy_if(results, std::back_inserter(found), bad);
    const std::vector<std::string> roots = likely_roots(results);
    std::ranges::stable_sort(found, {}, [&](const Result& result) {
        return std::pair(std::ranges::find(roots, result.kernel) == roots.end(), place(result.kernel));
    });
    return found;
}

std::string causes_text(const std::vector<Result>& results) {
    const std::vector<std::string> roots = likely_roots(results);
    if (roots.empty()) return {};
    std::vector<std::string> others;
    for (const std::string& kernel : failed_kernels(results)) {
        if (std::ranges::find(roots, kernel) == roots.end()) others.push_back(kernel);
    }
    std::ranges::stable_sort(others, {}, place);
    std::string text = fmt::format("likely at fault: {}", fmt::join(roots, ", "));
    if (!others.empty()) {
        text +=
            fmt::format("; what uses {} fails, too: {}", roots.size() == 1 ? "it" : "them", fmt::join(others, ", "));
    }
    return text;
}

}  // namespace pelage::verify
