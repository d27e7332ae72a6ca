// include "FILE": another file's lines in the place of the statement.
#pragma once

#include "core/experiment.hpp"

#include <filesystem>
#include <string>

namespace pelage::language {

// The experiment's text with all that it includes, and where its lines come from. A text that includes nothing comes
// back as it is. Names are looked for in `folder`, those in an included file beside that file. Throws Error, naming
// all files on the way, for a file that cannot be read, that includes itself, or that makes the text longer than
// largest_text.
struct JoinedText {
    std::string text;
    std::vector<IncludedLines> included;
};
JoinedText joined_text(const std::string& text, const std::string& source, const std::filesystem::path& folder);

// The whole text of an experiment's file; at most largest_text bytes and one. Throws Error for one that cannot be read.
std::string read_text(const std::filesystem::path&);

// The lines of a text, without what ends them and without the byte order mark before the first.
std::vector<std::string_view> lines_of(std::string_view text);

}  // namespace pelage::language
