// create mesh | icosphere | torus
#pragma once

#include "language/script.hpp"

namespace pelage::language {

// `at`: the word of the kind, which has been read.
void create_mesh(Script&, Cursor&, const Token& at);

}  // namespace pelage::language
