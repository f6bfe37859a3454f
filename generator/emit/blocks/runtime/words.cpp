// SPDX-License-Identifier: MIT
#include "emit/blocks/runtime/words.h"

#include <algorithm>
#include <iterator>

#include "emit/blocks/c_text.h"
#include "emit/blocks/runtime/methods.h"
#include "emit/blocks/runtime/translation.h"

namespace qvgen::emit::blocks::runtime {
namespace {

using Kind = Token::Kind;

/// Definitions that C has its own words for.
bool is_in_other_words(const std::string& name) {
  static const std::set<std::string> all{"ScalarTraits", "epsilon", "not_a_number",
                                         "select",       "any",     "leaves_singular_poses"};
  return all.count(name) > 0;
}

/// A definition in words of C.
struct Definition {
  std::string name;
  Tokens words;
};

class Words : private Translation {
 public:
  Words(const File& file, const std::function<bool(const std::string&)>& skipped, Known& known)
      : Translation(file, known, without_methods(file, tokens_of(file))), skipped_(skipped) {}

  Tokens run() {
    while (in_[at_].kind != Kind::end) {
      if (is("namespace")) {
        is_for_doubles_ = is("polynomial", 1);
        at_ = next("{") + 1;
      } else if (is("}")) {
        is_for_doubles_ = false;
        ++at_;
      } else {
        definition();
      }
    }
    return joined();
  }

 private:
  /// Returns all definitions and the end.
  Tokens joined() {
    Tokens all;
    for (Definition& each : definitions_)
      std::move(each.words.begin(), each.words.end(), std::back_inserter(all));
    all.push_back(in_[at_]);
    all.back().comment.clear();
    return all;
  }

  /// Keeps what has been put as a definition. Of two with one name the first stays, but one for doubles takes
  /// its place.
  void keep(const std::string& name) {
    const auto same = std::find_if(definitions_.begin(), definitions_.end(),
                                   [&](const Definition& each) { return each.name == name; });
    const bool is_second = same != definitions_.end();
    if (is_second && is_for_doubles_) definitions_.erase(same);
    if (!is_second || is_for_doubles_) definitions_.push_back({name, std::move(out_)});
    out_.clear();
  }

  /// Place of the first of `(`, `=`, `{` and `;`: the name that is defined stands in front of it, that of a
  /// struct too.
  [[nodiscard]] std::size_t behind_name() const {
    std::size_t at = at_;
    for (; text(at) != "(" && text(at) != "=" && text(at) != "{" && text(at) != ";"; ++at)
      if (in_[at].kind == Kind::end) fail("a definition has no end");
    return at;
  }

  /// Place behind a definition.
  [[nodiscard]] std::size_t behind_definition(std::size_t behind_name) const {
    if (text(behind_name) == ";" || text(behind_name) == "=") return next(";") + 1;
    if (text(behind_name) == "{") return closing(behind_name) + 2;
    std::size_t at = closing(behind_name) + 1;
    while (text(at) != "{" && text(at) != ";" && in_[at].kind != Kind::end) ++at;
    return text(at) == "{" ? closing(at) + 1 : at + 1;
  }

  void definition() {
    comment_ = in_[at_].comment;
    flag_.clear();
    sizes_.clear();
    if (is("template")) template_head();
    const std::size_t name = behind_name() - 1, end = behind_definition(name + 1);
    const std::string name_here = defined_name(name);
    if (is("using") && is("std", 3) && is("array", 6)) return alias(end);
    if (is("using") || is_in_other_words(name_here) || skipped_(name_here)) {
      at_ = end;
      comment_.clear();
      return;
    }
    if (is("struct")) {
      structure(end);
    } else if (text(name + 1) == "(") {
      function(name, name_here, end);
    } else {
      put("static", Kind::name);
      put("const", Kind::name);
      translate(end);
    }
    keep(name_here);
  }

  /// Name in C of what is defined: functions of one name have others by their parameters.
  [[nodiscard]] std::string defined_name(std::size_t name) const {
    if (text(name + 1) != "(") return text(name);
    const bool is_of_rotor = text(name + 2) == "const" && text(name + 3) == "Rotor";
    if (text(name) == "*" && text(name - 1) == "operator") return is_of_rotor ? "product" : "scaled";
    return overload_in_c(name_in_c(text(name)), parameter_count(name + 1), is_of_rotor);
  }

  /// Number of parameters in brackets.
  [[nodiscard]] std::size_t parameter_count(std::size_t bracket) const {
    const std::size_t end = closing(bracket);
    std::size_t count = end > bracket + 1 ? 1 : 0;
    for (std::size_t i = bracket; i < end; ++i) count += text(i) == "," ? 1 : 0;
    return count;
  }

  /// Reads `template <typename Scalar, bool flag = false, std::size_t rows>`.
  void template_head() {
    const std::size_t end = next(">");
    for (; at_ < end; ++at_) {
      if (is("bool")) flag_ = text(at_ + 1);
      if (is("size_t")) sizes_.push_back(text(at_ + 1));
    }
    ++at_;
  }

  /// A named array, a struct in C: `using Held = std::array<bool, joints>`.
  void alias(std::size_t end) {
    const std::string name = text(at_ + 1);
    known_.sized[name] = sizes_;
    known_.arrays.insert(name);
    if (!skipped_(name)) {
      put("typedef", Kind::name);
      put("struct", Kind::name);
      put(name, Kind::name);
      put("{");
      at_ += 6;
      Tokens sizes;
      array(sizes);
      put("of", Kind::name);
      put_sizes(sizes);
      for (const char* each : {";", "}"}) put(each);
      put(name, Kind::name);
      put(";");
      keep(name);
    }
    comment_.clear();
    at_ = end;
  }

  void structure(std::size_t end) {
    ++at_;
    const std::string name = text(at_);
    if (!sizes_.empty()) known_.sized[name] = sizes_;
    put("typedef", Kind::name);
    put("struct", Kind::name);
    put(name, Kind::name);
    put("{");
    at_ += 2;
    Tokens values;
    bool has_all = true;
    while (at_ + 2 < end) has_all = field(name, values) && has_all;
    put("}");
    put(name, Kind::name);
    put(";");
    if (has_all) put_new(name, values);
    at_ = end;
  }

  /// Puts the constant that objects of a struct begin as: `new_branch` of Branch.
  void put_new(const std::string& structure, const Tokens& values) {
    for (const std::string& each : {std::string("static"), std::string("const"), structure})
      put(each, Kind::name);
    put("new_" + snake(structure), Kind::name);
    put("=");
    put("{");
    out_.insert(out_.end(), values.begin(), values.end());
    put("}");
    put(";");
  }

  /// A field, whose value in structs that say none is kept. False if it has none.
  bool field(const std::string& structure, Tokens& values) {
    const std::size_t end = next(";");
    std::size_t stop = at_;
    while (stop < end && text(stop) != "=" && text(stop) != "{") ++stop;
    const bool has_value = text(stop) == "=" || (text(stop) == "{" && stop + 2 < end);
    if (text(stop) == "=") known_.defaults[structure].push_back({text(stop - 1), text(stop + 1)});
    translate(stop);
    if (has_value) add_value(stop, end, values);
    at_ = end;
    put(in_[at_++]);
    return has_value;
  }

  /// Adds a field's value in C to those of a struct.
  void add_value(std::size_t sign, std::size_t end, Tokens& values) {
    Tokens before = std::move(out_);
    out_.clear();
    at_ = sign + 1;
    translate(text(sign) == "{" ? end - 1 : end);
    out_.front().comment.clear();
    std::move(out_.begin(), out_.end(), std::back_inserter(values));
    values.push_back(Token{Kind::sign, ",", in_[at_].line});
    out_ = std::move(before);
  }

  void function(std::size_t name, const std::string& name_in_c, std::size_t end) {
    put("static", Kind::name);
    if (!flag_.empty()) known_.flagged.insert(text(name));
    translate(text(name - 1) == "operator" ? name - 1 : name);
    put(name_in_c, Kind::name);
    at_ = name + 1;
    parameters();
    in_body_ = true;
    translate(end);
    in_body_ = false;
  }

  /// True if a parameter in front of a place has a size as its field.
  [[nodiscard]] bool is_field(const std::string& size, std::size_t end) const {
    for (std::size_t i = at_; i < end; ++i) {
      if (known_.with_fields.count(text(i)) == 0) continue;
      const std::vector<std::string>& fields = known_.sized.at(text(i));
      if (std::find(fields.begin(), fields.end(), size) != fields.end()) return true;
    }
    return false;
  }

  /// Parameters without their usual values; pi is a constant.
  void parameters() {
    const std::size_t end = closing(at_);
    put(in_[at_++]);
    const std::size_t before = out_.size();
    if (!flag_.empty()) {
      put("bool", Kind::name);
      put(flag_, Kind::name);
    }
    for (const std::string& size : sizes_) {
      if (is_field(size, end)) continue;
      if (out_.size() > before) put(",");
      put("int", Kind::name);
      put(size, Kind::name);
    }
    while (at_ < end) {
      std::size_t stop = at_, comma = at_;
      for (int depth = 0; comma < end && !(depth == 0 && text(comma) == ","); ++comma)
        depth += text(comma) == "<" ? 1 : text(comma) == ">" ? -1 : 0;
      while (stop < comma && text(stop) != "=") ++stop;
      if (text(stop - 1) != "pi") {
        if (out_.size() > before) put(",");
        translate(stop);
      }
      at_ = comma + (comma < end ? 1 : 0);
    }
    if (out_.size() == before) put("void", Kind::name);
    at_ = end;
    put(in_[at_++]);
  }

  const std::function<bool(const std::string&)>& skipped_;
  std::vector<Definition> definitions_;
  bool is_for_doubles_ = false;  ///< in the namespace that numbers and lanes share
  std::string flag_;
};

}  // namespace

std::string overload_in_c(const std::string& name, std::size_t count, bool is_of_rotor) {
  if (name == "arctangent" && count == 3) return "arctangent_of_length";
  return name == "output_angle" && is_of_rotor ? "output_angle_of" : name;
}

Tokens words_of(const File& header, const std::function<bool(const std::string&)>& skipped, Known& known) {
  return Words(header, skipped, known).run();
}

}  // namespace qvgen::emit::blocks::runtime
