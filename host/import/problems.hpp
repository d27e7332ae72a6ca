// What an import could not carry over.
#pragma once

#include <string>
#include <vector>

namespace pelage::imports {

class Problems {
public:
    // Something without which the experiment would be another one: nothing is written.
    void refuse(std::string sentence);
    // Something that is left out or done differently: it is said, and stands in the file.
    void note(std::string sentence);

    // Throws Error with every refusal, a line each.
    void check() const;
    const std::vector<std::string>& notes() const { return notes_; }

private:
    std::vector<std::string> refusals_;
    std::vector<std::string> notes_;
};

}  // namespace pelage::imports
