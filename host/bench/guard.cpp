// See guard.hpp.
#include "bench/guard.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

namespace pelage::bench {

namespace {

bool meets(const Demand& demand, const Ratio& ratio) {
    return ratio.suite == demand.suite && ratio.name == demand.name && ratio.size == demand.size &&
           ratio.against == demand.against;
}

void check_slack(const std::filesystem::path& file, double slack) {
    if (slack > 0 && slack <= 1) return;
    throw Error(fmt::format("{}: slack {} is out of range; above 0 and up to 1 is allowed", file.string(), slack));
}

}  // namespace

Guard read_guard(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw Error(fmt::format("{} cannot be read", file.string()));
    try {
        const auto json = nlohmann::json::parse(stream);
        Guard guard;
        guard.slack = json.at("slack");
        for (const auto& one : json.at("ratios")) {
            guard.demands.push_back(
                {one.at("suite"), one.at("case"), one.at("size"), one.at("against"), one.at("ratio")});
            if (one.contains("slack")) guard.demands.back().slack = one.at("slack");
        }
        if (guard.demands.empty()) throw Error(file.string() + " demands nothing");
        check_slack(file, guard.slack);
        for (const Demand& demand : guard.demands) check_slack(file, demand.slack.value_or(guard.slack));
        return guard;
    } catch (const nlohmann::json::exception& error) {
        throw Error(fmt::format("{} is no table of ratios: {}", file.string(), error.what()));
    }
}

std::vector<Options> options_for(const Guard& guard, const Options& given) {
    using Key = std::pair<std::string, std::string>;
    std::map<Key, std::set<std::string>> against;
    std::map<Key, std::set<std::size_t>> sizes;
    for (const Demand& demand : guard.demands) {
        against[{demand.suite, demand.name}].insert(demand.against == "copy" ? "opencl" : demand.against);
        sizes[{demand.suite, demand.name}].insert(demand.size);
    }
    std::vector<Options> list;
    for (const auto& [key, backends] : against) {
        Options options = given;
        options.suite = key.first;
        options.cases = {key.second};
        options.against.assign(backends.begin(), backends.end());
        options.sizes.assign(sizes[key].begin(), sizes[key].end());
        list.push_back(options);
    }
    return list;
}

Verdict judge(const Guard& guard, const std::vector<Ratio>& ratios) {
    Verdict verdict;
    for (const Demand& demand : guard.demands) {
        const double least = demand.slack.value_or(guard.slack) * demand.ratio;
        const std::string what =
            fmt::format("{} {} {}, opencl against {}", demand.suite, demand.name, demand.size, demand.against);
        const auto found = std::ranges::find_if(ratios, [&](const Ratio& ratio) { return meets(demand, ratio); });
        if (found == ratios.end()) {
            verdict.text += fmt::format("MISSING {}: not measured\n", what);
            verdict.kept = false;
            continue;
        }
        const bool kept = found->ratio >= least;
        verdict.text += fmt::format("{} {}: {:.2f}, once {:.2f}, at least {:.2f} is demanded\n",
                                    kept ? "kept   " : "LOST   ", what, found->ratio, demand.ratio, least);
        if (!kept) verdict.kept = false;
    }
    return verdict;
}

}  // namespace pelage::bench
