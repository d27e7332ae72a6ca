// Text that any reader of UTF-8 takes.
#pragma once

#include <string>
#include <string_view>

namespace pelage {

// Each byte that is not part of a character of UTF-8 (RFC 3629) becomes U+FFFD; all else stays as it is.
std::string valid_utf8(std::string_view);

}  // namespace pelage
