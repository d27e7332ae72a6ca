// What is packed in a zip file, as NumPy's .npz is one.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace pelage {

inline constexpr std::string_view zip_magic{"PK\x03\x04", 4};  // how such a file begins

// Its files by name, unpacked. Throws Error with `name`, the archive's, where it is damaged, packed in another way than
// deflate, encrypted, or where what it holds has more than `most` bytes in all.
std::map<std::string, std::string> parse_zip(std::string_view bytes, const std::string& name, std::size_t most);

// A zip file of these, each as it is, not packed; the same bytes whenever it is made.
std::string zip_of(const std::map<std::string, std::string>& files);

}  // namespace pelage
