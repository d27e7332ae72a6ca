// See exr_channels.hpp.
#include "io/exr_channels.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <map>
#include <sstream>

namespace pelage {
namespace {

using Names = std::vector<std::string>;

bool holds(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// "view.layer.R": the layer "view.layer." with the channel "R"; "R": the layer "".
std::map<std::string, Names> by_layer(const Names& names) {
    std::map<std::string, Names> layers;
    for (const auto& name : names) {
        const auto dot = name.rfind('.');
        const auto split = dot == std::string::npos ? 0 : dot + 1;
        layers[name.substr(0, split)].push_back(name.substr(split));
    }
    return layers;
}

// Channels of one layer that make a picture; none where they do not, or where there is a choice.
Names picture_of(const std::string& layer, const Names& channels) {
    if (holds(channels, "R") && holds(channels, "G") && holds(channels, "B"))
        return {layer + "R", layer + "G", layer + "B"};
    if (holds(channels, "Y")) return {layer + "Y"};
    Names opaque;
    std::copy_if(channels.begin(), channels.end(), std::back_inserter(opaque),
                 [](const auto& name) { return name != "A" && name != "RA" && name != "GA" && name != "BA"; });
    return opaque.size() == 1 ? Names{layer + opaque[0]} : Names{};
}

Names words(const std::string& text) {
    std::istringstream stream(text);
    Names all;
    for (std::string word; stream >> word;) all.push_back(word);
    return all;
}

Names usual_channels(const Names& names) {
    if (names.size() == 1) return names;
    const auto layers = by_layer(names);
    if (const auto root = layers.find(""); root != layers.end()) {
        if (auto found = picture_of("", root->second); !found.empty()) return found;
    }
    Names found;
    for (const auto& [layer, channels] : layers) {
        if (layer.empty()) continue;
        auto picture = picture_of(layer, channels);
        if (picture.empty()) continue;
        if (!found.empty()) return {};
        found = std::move(picture);
    }
    return found;
}

}  // namespace

Names wanted_channels(const Names& names, const std::string& chemicals, const std::string& channel,
                      const std::string& name) {
    if (names.empty()) throw Error(fmt::format("'{}' holds no channels", name));
    if (!channel.empty()) {
        if (holds(names, channel)) return {channel};
        throw Error(fmt::format("'{}' has no channel '{}'; it has {}", name, channel, fmt::join(names, ", ")));
    }
    auto own = words(chemicals);
    if (own.size() == 1 && holds(names, own[0])) return own;
    const auto found = own.empty() ? usual_channels(names) : Names{};
    if (!found.empty()) return found;
    throw Error(fmt::format("'{}' has the channels {}; say which one is meant, as in 'channel {}'", name,
                            fmt::join(names, ", "), own.empty() ? names[0] : own[0]));
}

}  // namespace pelage
