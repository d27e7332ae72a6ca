// Files of networks, for neural reactions.
#pragma once

#include "core/neural.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pelage {

inline constexpr std::size_t largest_network_file = 16u << 20;  // bytes

struct NetworkFile {
    std::string name;   // relative to the folder that was asked for; empty: that file itself
    std::string bytes;  // as read
};

struct FoundNetwork {
    Network network;
    std::vector<NetworkFile> files;
};

// The arrays W0 (chemicals x hidden), b0 and W1 (hidden x chemicals); lengths of 1 in front of a shape do not count.
//   .npz          W0.npy, b0.npy and W1.npy, or arr_0, arr_1 and arr_2 for these
//   .safetensors  W0, b0 and W1
//   .npy          a pickled list of the three, see pickle.hpp
//   a folder      that holds W0.npy, b0.npy and W1.npy
// Throws Error naming the file and the reason.
FoundNetwork read_network(const std::filesystem::path&);
Network parse_network(std::string_view bytes, const std::string& name);  // of a file, from memory

// An .npz archive of W0, b0 and W1 in single precision. Throws Error naming the file and the reason.
void write_network(const std::filesystem::path&, const Network&);

}  // namespace pelage
