// XML documents as trees, with bounds on their size.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::imports {

struct XmlElement {
    std::string name;
    std::map<std::string, std::string, std::less<>> attributes;
    std::string text;  // all between its tags but that of its children
    std::size_t text_line = 0;
    std::size_t line = 0;
    std::vector<XmlElement> children;

    const XmlElement* child(std::string_view name_of_child) const;  // the first one; null: none
    const std::string* attribute(std::string_view name_of_attribute) const;
};

struct XmlDocument {
    std::string name;  // of the file
    XmlElement root;
    std::string appended;  // what stands behind the '_' of VTK's AppendedData, which may be no XML at all
    bool appended_raw = false;

    std::string at(const XmlElement&) const;  // "FILE:LINE"
};

// Throws Error with the line of what is no XML, and for a document type, more than 60 levels or 100 000 elements.
XmlDocument parse_xml(std::string bytes, const std::string& name);

}  // namespace pelage::imports
