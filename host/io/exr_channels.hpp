// Which channels of an EXR picture make the one value that a start picture needs.
#pragma once

#include <string>
#include <vector>

namespace pelage {

// One name, or those of red, green and blue, whose luminance is meant. `channel` names one; where it is empty:
//   of a picture of ours (`chemicals` are its channels that are, separated by spaces) the only chemical
//   else R, G and B, or Y, or the only channel beside alpha; of the channels without a layer or, where those hold none
//   of that, of the only layer that does ("layer.R", "layer.G", "layer.B").
// Throws Error naming the file (`name`) and listing its channels when that leaves none or a choice.
std::vector<std::string> wanted_channels(const std::vector<std::string>& names, const std::string& chemicals,
                                         const std::string& channel, const std::string& name);

}  // namespace pelage
