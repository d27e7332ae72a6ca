// See together.hpp.
#include "cluster/together.hpp"

#include <algorithm>

namespace pelage::cluster {

void together(Ranks* ranks, const std::function<void()>& part) {
    if (ranks == nullptr) return part();
    std::string reason;
    try {
        part();
    } catch (const Error& error) {
        reason = error.what();
    }
    const std::vector<std::string> reasons = ranks->gather(reason);
    const auto first = std::ranges::find_if(reasons, [](const std::string& one) { return !one.empty(); });
    if (first == reasons.end()) return;
    if (ranks->rank() == 0) throw FirstReason(*first);
    throw AnotherSaysWhy{};
}

}  // namespace pelage::cluster
