// See xml.hpp.
#include "import/xml.hpp"

#include "core/error.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace pelage::imports {

namespace {

constexpr std::size_t deepest_element = 60;
constexpr std::size_t most_elements = 100'000;

// What expat's calls share. They are C's: errors are kept here and thrown behind them.
struct XmlBuilder {
    XML_Parser parser = nullptr;
    XmlElement document;
    std::vector<XmlElement*> open{&document};
    std::size_t elements = 0;
    std::string trouble;

    void stop(std::string why) {
        trouble = std::move(why);
        XML_StopParser(parser, XML_FALSE);
    }
    std::size_t line() const { return XML_GetCurrentLineNumber(parser); }
};

void start_element(void* user, const XML_Char* name, const XML_Char** attributes) {
    auto& builder = *static_cast<XmlBuilder*>(user);
    if (builder.open.size() > deepest_element)
        return builder.stop(
            fmt::format("elements are nested too deeply; at most {} levels are allowed", deepest_element));
    if (++builder.elements > most_elements)
        return builder.stop(fmt::format("there are too many elements; at most {} are allowed", most_elements));
    XmlElement element;
    element.name = name;
    element.line = builder.line();
    for (; *attributes != nullptr; attributes += 2) element.attributes[attributes[0]] = attributes[1];
    builder.open.back()->children.push_back(std::move(element));
    builder.open.push_back(&builder.open.back()->children.back());
}

void end_element(void* user, const XML_Char*) { static_cast<XmlBuilder*>(user)->open.pop_back(); }

void add_text(void* user, const XML_Char* text, int length) {
    auto& builder = *static_cast<XmlBuilder*>(user);
    XmlElement& element = *builder.open.back();
    if (element.text.empty()) element.text_line = builder.line();
    element.text.append(text, static_cast<std::size_t>(length));
}

void refuse_document_type(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    static_cast<XmlBuilder*>(user)->stop("a document type (<!DOCTYPE ...>) is not allowed in such a file");
}

// Appended data begin with '_' and end with their element: cut out, since raw bytes are no XML.
void cut_appended(std::string& bytes, XmlDocument& document) {
    const std::size_t tag = bytes.find("<AppendedData");
    const std::size_t tag_end = tag == std::string::npos ? tag : bytes.find('>', tag);
    if (tag_end == std::string::npos) return;
    const std::size_t first = bytes.find_first_not_of(" \t\r\n", tag_end + 1);
    const std::size_t last = bytes.rfind("</AppendedData>");
    if (first == std::string::npos || bytes[first] != '_' || last == std::string::npos || last < first) return;
    document.appended_raw = bytes.substr(tag, tag_end - tag).find("base64") == std::string::npos;
    document.appended = bytes.substr(first + 1, last - first - 1);
    bytes.erase(first, last - first);
}

}  // namespace

const XmlElement* XmlElement::child(std::string_view name_of_child) const {
    const auto found = std::ranges::find(children, name_of_child, &XmlElement::name);
    return found == children.end() ? nullptr : &*found;
}

const std::string* XmlElement::attribute(std::string_view name_of_attribute) const {
    const auto found = attributes.find(name_of_attribute);
    return found == attributes.end() ? nullptr : &found->second;
}

std::string XmlDocument::at(const XmlElement& element) const { return fmt::format("{}:{}", name, element.line); }

XmlDocument parse_xml(std::string bytes, const std::string& name) {
    XmlDocument document;
    document.name = name;
    cut_appended(bytes, document);
    XmlBuilder builder;
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
        XML_ParserCreate(nullptr), XML_ParserFree);
    if (!parser) throw Error(fmt::format("{}: no memory is left to read it", name));
    builder.parser = parser.get();
    XML_SetUserData(builder.parser, &builder);
    XML_SetElementHandler(builder.parser, start_element, end_element);
    XML_SetCharacterDataHandler(builder.parser, add_text);
    XML_SetStartDoctypeDeclHandler(builder.parser, refuse_document_type);
    constexpr std::size_t part = std::size_t{1} << 24;
    for (std::size_t at = 0;; at += part) {
        const std::size_t count = std::min(part, bytes.size() - at);
        const bool last = at + count == bytes.size();
        if (XML_Parse(builder.parser, bytes.data() + at, static_cast<int>(count), last ? 1 : 0) != XML_STATUS_OK) {
            const std::string why =
                builder.trouble.empty() ? XML_ErrorString(XML_GetErrorCode(builder.parser)) : builder.trouble;
            throw Error(fmt::format("{}:{}: is no XML that can be read: {}", name, builder.line(), why));
        }
        if (last) break;
    }
    document.root = std::move(builder.document.children.front());
    return document;
}

}  // namespace pelage::imports
