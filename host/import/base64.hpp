// Binary data written as text (RFC 4648).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pelage::imports {

// Up to `most` bytes. White space is passed over; groups that end in '=' may be followed by others, as VTK writes a
// header and its data. Empty for any other byte, and for a group that is not whole within those bytes.
std::optional<std::string> from_base64(std::string_view text, std::size_t most);

}  // namespace pelage::imports
