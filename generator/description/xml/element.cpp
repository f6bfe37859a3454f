// SPDX-License-Identifier: MIT
#include "description/xml/element.h"

#include <algorithm>
#include <memory>

#include <expat.h>

#include "description/xml/text.h"

namespace qvgen::description::xml {
namespace {

/// Turns rising byte offsets into places, all of a file in one pass.
class Cursor {
 public:
  /// `skipped`: bytes at the beginning that are no columns.
  Cursor(std::string_view text, int file, std::size_t skipped) : text_(text), offset_(skipped) {
    place_.file = file;
  }
  Place at(std::size_t offset) {
    for (; offset_ < std::min(offset, text_.size()); ++offset_) {
      if (text_[offset_] == '\n')
        place_ = {place_.line + 1, 1, place_.file};
      else if ((static_cast<unsigned char>(text_[offset_]) & 0xC0U) != 0x80U)
        ++place_.column;
    }
    return place_;
  }

 private:
  std::string_view text_;
  std::size_t offset_;
  Place place_;
};

/// Returns where the values of a start tag's attributes begin; the tag is well formed, and begins at `from`.
std::vector<std::size_t> value_offsets(std::string_view text, std::size_t from, std::size_t count) {
  std::vector<std::size_t> offsets;
  while (offsets.size() < count) {
    const std::size_t open = text.find_first_of("\"'", from);
    if (open == std::string_view::npos) break;  // not UTF-8: quotes do not stand alone
    offsets.push_back(open + 1);
    from = text.find(text[open], open + 1);
    if (from == std::string_view::npos) break;
    ++from;
  }
  return offsets;
}

struct Parsing {
  Parsing(Context& c, std::string_view t, int file, std::size_t skipped)
      : context(c), text(t), cursor(t, file, skipped) {}

  Context& context;
  std::string_view text;
  Cursor cursor;
  XML_Parser parser = nullptr;
  Element root;
  std::vector<Element*> open;
  std::size_t elements = 0;
  bool refused = false;

  std::size_t offset() {
    return static_cast<std::size_t>(std::max<XML_Index>(0, XML_GetCurrentByteIndex(parser)));
  }

  /// Bytes of the tag at hand.
  std::size_t length() { return static_cast<std::size_t>(std::max(0, XML_GetCurrentByteCount(parser))); }

  void refuse(const std::string& message, const std::string& hint) {
    if (refused) return;
    context.error(cursor.at(offset()), message, hint);
    refused = true;
    XML_StopParser(parser, XML_FALSE);
  }

  void start(const char* name, const char** attributes) {
    if (++elements > max_elements)
      return refuse("more than " + std::to_string(max_elements) + " elements", "give one robot a file");
    if (open.size() >= max_depth)
      return refuse("elements nested more than " + std::to_string(max_depth) + " deep", "close them earlier");
    Element element{name, cursor.at(offset()), {}, {}};
    element.begin = offset();
    element.head_end = element.begin + length();
    std::size_t count = 0;
    while (attributes[2 * count] != nullptr) ++count;
    const auto offsets = value_offsets(text, offset(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const Place place = i < offsets.size() ? cursor.at(offsets[i]) : element.place;
      element.attributes.push_back({attributes[2 * i], attributes[2 * i + 1], place});
    }
    Element& stored = open.empty() ? root : open.back()->children.emplace_back();
    stored = std::move(element);
    open.push_back(&stored);
  }

  /// A refused empty element is still closed.
  void close() {
    if (refused) return;
    open.back()->end = offset() + length();
    open.pop_back();
  }
};

Parsing& parsing(void* data) { return *static_cast<Parsing*>(data); }

}  // namespace

const Attribute* Element::attribute(std::string_view key) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.name == key; });
  return found == attributes.end() ? nullptr : &*found;
}

const Element* Element::child(std::string_view key) const {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const auto& c) { return c.name == key; });
  return found == children.end() ? nullptr : &*found;
}

std::string text_of(const Element& element, std::string_view key, const std::string& otherwise) {
  const Attribute* attribute = element.attribute(key);
  return attribute == nullptr ? otherwise : attribute->value;
}

std::optional<Element> parse(Context& context, std::string_view bytes, int file) {
  const Text readable_text = readable(context, bytes, file);
  const std::string& text = readable_text.utf8;
  const std::string& encoding = readable_text.encoding;
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(
      XML_ParserCreate(encoding.empty() ? nullptr : encoding.c_str()), XML_ParserFree);
  Parsing state(context, text, file, bytes.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);  // a byte-order mark
  state.parser = parser.get();
  XML_SetUserData(parser.get(), &state);
  XML_SetElementHandler(
      parser.get(),
      [](void* data, const char* name, const char** attributes) { parsing(data).start(name, attributes); },
      [](void* data, const char*) { parsing(data).close(); });
  XML_SetStartDoctypeDeclHandler(parser.get(), [](void* data, const char*, const char*, const char*, int) {
    parsing(data).refuse("a document type declaration (<!DOCTYPE ...>)",
                         "remove it: entities and other files are not read");
  });
  if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_ERROR &&
      !state.refused) {
    const char* reason = XML_ErrorString(XML_GetErrorCode(parser.get()));
    context.error(state.cursor.at(state.offset()), "XML syntax: " + std::string(reason),
                  "every element is closed, attributes stand in quotes, & and < are written &amp; and &lt;");
    return std::nullopt;
  }
  if (state.refused) return std::nullopt;
  return std::move(state.root);
}

}  // namespace qvgen::description::xml
