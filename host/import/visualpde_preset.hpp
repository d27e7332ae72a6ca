// The fields of a preset of VisualPDE as text, under their names of today, whatever names and types the file has.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace pelage::imports {

class PdePreset {
public:
    // From JSON, an address or its compressed part. Throws Error for anything else.
    PdePreset(std::string text, std::string name);

    // The field, or what VisualPDE takes where a preset does not say. Unknown fields are empty.
    std::string field(std::string_view key) const;
    std::string field(std::string_view key, std::size_t i) const;                 // reactionStr_1
    std::string field(std::string_view key, std::size_t i, std::size_t j) const;  // diffusionStr_1_2
    bool says(std::string_view key) const { return fields_.contains(key); }
    bool truth(std::string_view key) const;
    std::string at(std::string_view key) const;  // "FILE: field 'KEY'"
    const std::string& name() const { return name_; }

private:
    void put(const std::string& key, std::string value);

    std::string name_;
    std::map<std::string, std::string, std::less<>> fields_;
};

}  // namespace pelage::imports
