// SPDX-License-Identifier: MIT
#include "emit/blocks/runtime/methods.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "emit/blocks/c_text.h"
#include "emit/blocks/runtime/brackets.h"

namespace qvgen::emit::blocks::runtime {
namespace {

using Kind = Token::Kind;

/// Words of a struct: its name, whether `Scalar` is its parameter, its fields and functions.
struct Members {
  std::string name;
  bool is_template = false;
  Tokens fields;
  std::set<std::string> field_names;
  std::vector<Tokens> functions;
  std::set<std::string> makers;  ///< static functions that return the struct
};

/// Places in a function's words, and what it is.
struct Signature {
  std::size_t bracket = 0, end = 0;  ///< of its parameters
  std::size_t body = 0;
  bool is_constructor = false;
  bool has_object = false;
};

Token word(const std::string& text, int line, Kind kind = Kind::name) { return {kind, text, line}; }

class Methods {
 public:
  Methods(const File& file, Tokens words) : file_(file), in_(std::move(words)) {}

  Tokens run() {
    for (std::size_t at = 0; at < in_.size();)
      if (in_[at].text == "struct" && text(at + 2) == "{")
        at = structure(at);
      else
        out_.push_back(in_[at++]);
    return with_makers(std::move(out_));
  }

 private:
  [[nodiscard]] const std::string& text(std::size_t at) const {
    return in_[std::min(at, in_.size() - 1)].text;
  }
  void put(const std::string& text, Kind kind = Kind::sign) { out_.push_back(word(text, line_, kind)); }
  void put_name(const std::string& name) { put(name, Kind::name); }
  void put_all(const Tokens& words) { out_.insert(out_.end(), words.begin(), words.end()); }

  /// Writes a struct, and its functions behind it. Returns the place behind.
  std::size_t structure(std::size_t at) {
    const std::size_t end = closing(file_, in_, at + 2);
    Members all;
    all.name = text(at + 1);
    all.is_template = !out_.empty() && out_.back().text == ">";
    for (std::size_t from = at + 3; from < end;) from = member(from, all);
    out_.insert(out_.end(), in_.begin() + static_cast<int>(at), in_.begin() + static_cast<int>(at + 3));
    put_all(all.fields);
    out_.insert(out_.end(), in_.begin() + static_cast<int>(end), in_.begin() + static_cast<int>(end + 2));
    std::set<std::string> done;
    for (const Tokens& each : all.functions) behind_its_calls(each, all, done);
    return end + 2;
  }

  /// Writes a function behind those of its struct that it calls: C declares before it uses.
  void behind_its_calls(const Tokens& one, const Members& of, std::set<std::string>& done) {
    if (!done.insert(own_name(one)).second) return;
    for (const Tokens& other : of.functions)
      if (calls(one, own_name(other))) behind_its_calls(other, of, done);
    function(one, of);
  }

  /// Place of the next of some signs.
  [[nodiscard]] std::size_t next(std::size_t at, const std::string& signs) const {
    for (const std::size_t from = at; in_[at].kind != Kind::sign || signs.find(text(at)) == std::string::npos;
         ++at)
      if (in_[at].kind == Kind::end) throw error_at(file_, in_[from].line, "a member has no end");
    return at;
  }

  /// Place behind the last argument of a type that may begin at a place: brackets there are no function's.
  [[nodiscard]] std::size_t behind_arguments(std::size_t at) const {
    while (in_[at].kind == Kind::name || text(at) == ":") ++at;
    if (text(at) != "<") return at;
    for (int depth = 0; in_[at].kind != Kind::end; ++at) {
      depth += text(at) == "<" ? 1 : text(at) == ">" ? -1 : 0;
      if (depth == 0) break;
    }
    return at;
  }

  /// Sorts a member. Returns the place behind it.
  std::size_t member(std::size_t from, Members& into) const {
    std::size_t at = next(behind_arguments(from), ";={(");
    if (text(at) == "(") {
      const std::string& name = text(at - 1);
      at = next(closing(file_, in_, at), "{;");
      if (text(at) == ";") throw error_at(file_, in_[at].line, "a member function without a body");
      at = closing(file_, in_, at) + 1;
      into.functions.emplace_back(in_.begin() + static_cast<int>(from), in_.begin() + static_cast<int>(at));
      const Tokens& all = into.functions.back();
      const bool is_static =
          std::any_of(all.begin(), all.end(), [](const Token& each) { return each.text == "static"; });
      if (is_static && returns(all, into.name)) into.makers.insert(name);
      return at;
    }
    into.field_names.insert(text(at - 1));
    for (std::size_t i = from; i < at; ++i)
      if (text(i) == ",") into.field_names.insert(text(i - 1));
    at = next(at, ";");
    into.fields.insert(into.fields.end(), in_.begin() + static_cast<int>(from),
                       in_.begin() + static_cast<int>(at + 1));
    return at + 1;
  }

  static std::string own_name(const Tokens& function) {
    std::size_t at = 0;
    while (function[at].text != "(") ++at;
    return function[at - 1].text;
  }
  static bool calls(const Tokens& function, const std::string& name) {
    for (std::size_t i = 1; i + 1 < function.size(); ++i)
      if (function[i].text == name && function[i + 1].text == "(" && function[i - 1].text != ".") return true;
    return false;
  }

  /// True if a function's result is of a type, which stands in front of its name.
  static bool returns(const Tokens& function, const std::string& type) {
    const auto bracket =
        std::find_if(function.begin(), function.end(), [](const Token& each) { return each.text == "("; });
    return bracket - function.begin() >= 2 && (bracket - 2)->text == type;
  }

  /// Writes a function of a struct as one of its own.
  void function(const Tokens& all, const Members& of) {
    line_ = all.front().line;
    const std::size_t first = out_.size();
    const Signature signature = signature_of(all, of);
    if (of.is_template) put_template();
    put_head(all, signature, of);
    if (signature.is_constructor)
      put_construction(all, signature.body, of);
    else
      put_inside(all, signature.body, all.size(), of, signature.has_object);
    out_[first].comment = all.front().comment;
  }

  void put_template() {
    put_name("template");
    put("<");
    put_name("typename");
    put_name("Scalar");
    put(">");
  }

  Signature signature_of(const Tokens& all, const Members& of) const {
    Signature found;
    bool is_static = false;
    for (; all[found.bracket].text != "("; ++found.bracket)
      is_static = is_static || all[found.bracket].text == "static";
    found.end = closing(file_, all, found.bracket);
    found.is_constructor = all[found.bracket - 1].text == of.name;
    found.has_object = !is_static && !found.is_constructor;
    found.body = found.end;
    while (all[found.body].text != "{") ++found.body;
    return found;
  }

  /// Writes result, name and parameters.
  void put_head(const Tokens& all, const Signature& signature, const Members& of) {
    const std::string& name = all[signature.bracket - 1].text;
    if (signature.is_constructor) {
      put_type(of);
      put_name(snake(name));
    } else {
      put_result(all, signature.bracket - 1, of);
      put_name(of.makers.count(name) > 0 ? name + "_" + snake(of.name) : name);
    }
    put("(");
    const bool others_follow = signature.end > signature.bracket + 1;
    if (signature.has_object) put_object(all[signature.end + 1].text == "const", others_follow, of);
    put_inside(all, signature.bracket + 1, signature.end + 1, of, false);
  }

  /// Writes the body of a constructor: it makes an object and returns it.
  void put_construction(const Tokens& all, std::size_t body, const Members& of) {
    put("{");
    put_type(of);
    put_name("self");
    put(";");
    put_inside(all, body + 1, all.size() - 1, of, true);
    put_name("return");
    put_name("self");
    put(";");
    put("}");
    constructed_.insert(of.name);
  }

  void put_type(const Members& of) {
    put_name(of.name);
    if (!of.is_template) return;
    put("<");
    put_name("Scalar");
    put(">");
  }

  /// Writes the type of a result without what C has no word for.
  void put_result(const Tokens& all, std::size_t end, const Members& of) {
    std::size_t from = 0;
    if (all[0].text == "[") from = closing(file_, all, 0) + 1;
    for (; from < end; ++from) {
      const std::string& each = all[from].text;
      if (each == of.name)
        put_type(of);
      else if (each != "static" && each != "constexpr")
        put(each, all[from].kind);
    }
  }

  void put_object(bool is_constant, bool others_follow, const Members& of) {
    if (is_constant) put_name("const");
    put_type(of);
    put("&");
    put_name("self");
    if (others_follow) put(",");
  }

  /// Writes words of a function, in which fields are the object's.
  void put_inside(const Tokens& all, std::size_t from, std::size_t end, const Members& of, bool has_object) {
    for (; from < end; ++from) {
      const Token& each = all[from];
      const bool is_own = each.kind == Kind::name && all[from - 1].text != ".";
      const std::string next = from + 1 < all.size() ? all[from + 1].text : "";
      if (each.text == "*" && next == "this") {
        put_name("self");
        ++from;
      } else if (is_own && each.text == of.name && next != "<") {
        put_type(of);
      } else if (is_own && next == "(" && of.makers.count(each.text) > 0) {
        put_name(each.text + "_" + snake(of.name));
      } else {
        if (is_own && has_object && of.field_names.count(each.text) > 0) {
          put_name("self");
          put(".");
        }
        out_.push_back(each);
      }
    }
  }

  /// Calls functions where C++ constructs: `Name<Scalar>(x)` and `Name<Scalar> variable(x)`.
  Tokens with_makers(Tokens words) const {
    Tokens result;
    const auto is = [&](std::size_t at, const char* wanted) {
      return at < words.size() && words[at].text == wanted;
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
      result.push_back(words[i]);
      if (constructed_.count(words[i].text) == 0 || !is(i + 1, "<")) continue;
      const std::string name = words[i].text;
      if (is(i + 4, "(")) {
        result.back().text = snake(name);
        i += 3;
      } else if (is(i + 5, "(") && words[i + 4].text != snake(name)) {
        for (std::size_t k = 1; k < 5; ++k) result.push_back(words[i + k]);
        result.push_back(word("=", words[i].line, Kind::sign));
        result.push_back(word(snake(name), words[i].line));
        i += 4;
      }
    }
    return result;
  }

  const File& file_;
  Tokens in_, out_;
  std::set<std::string> constructed_;
  int line_ = 0;
};

}  // namespace

Tokens without_methods(const File& header, Tokens words) { return Methods(header, std::move(words)).run(); }

}  // namespace qvgen::emit::blocks::runtime
