// Pictures and arrays that statements take numbers from.
#pragma once

#include "language/script.hpp"

#include <memory>
#include <string>

namespace pelage::language {

struct PictureOptions {
    const Token* file = nullptr;
    std::string channel;
    double low = 0.0;  // what black stands for
    double high = 1.0;
};

// What follows `channel` and `from`.
void parse_channel(Cursor&, PictureOptions&);
void parse_scale(Cursor&, PictureOptions&);

// Its numbers, from low to high, and a note of the file among the inputs: `throughout` where a run asks them after its
// start, too. Throws Error where it cannot be read.
std::shared_ptr<const Field> load_picture(Script&, const Cursor&, const PictureOptions&, bool throughout);

// The same of a picture that a run starts from. Null where pictures are left out.
std::shared_ptr<const Field> load_start_picture(Script&, const Cursor&, const PictureOptions&);

}  // namespace pelage::language
