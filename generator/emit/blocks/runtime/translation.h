// SPDX-License-Identifier: MIT
// Words inside a definition of C++ as words of C: a cursor over what is read, and what is put. `words.cpp`,
// which knows what a header defines, derives from it.
#pragma once

#include <string>
#include <vector>

#include "emit/blocks/runtime/words.h"

namespace qvgen::emit::blocks::runtime {

class Translation {
 protected:
  Translation(const File& file, Known& known, Tokens words)
      : file_(file), known_(known), in_(std::move(words)) {}

  /// Text of a word, nothing behind the last.
  [[nodiscard]] const std::string& text(std::size_t at) const;
  [[nodiscard]] bool is(const char* wanted, std::size_t ahead = 0) const;
  [[noreturn]] void fail(const std::string& what) const;
  /// Place of the next such word.
  [[nodiscard]] std::size_t next(const std::string& wanted) const;
  /// Place of the bracket that closes the one at a place.
  [[nodiscard]] std::size_t closing(std::size_t from) const;

  void put(const Token& token);
  void put(const std::string& word, Token::Kind kind = Token::Kind::sign);
  /// Goes on behind words; their comment stays.
  void leave_out(std::size_t behind);
  /// Puts all words up to a place in C.
  void translate(std::size_t end);
  /// Reads `array<T, size>`: puts T and gives the sizes, outer ones first.
  void array(Tokens& sizes);
  void put_sizes(const Tokens& sizes);

  const File& file_;
  Known& known_;
  Tokens in_, out_;
  std::size_t at_ = 0;
  std::vector<std::string> comment_;
  bool in_body_ = false;
  std::vector<std::string> sizes_;  ///< of the template that is read

 private:
  void word();
  void put_smallest();
  void qualifier();
  void known_condition();
  void type();
  [[nodiscard]] bool is_sized() const;
  [[nodiscard]] bool is_handed_on(const std::string& type) const;
  [[nodiscard]] std::size_t behind_arguments() const;
  [[nodiscard]] Token room(const Token& size) const;
  void put_arguments(std::size_t behind);
  void whole_number();
  void named();
  void put_flag(const std::string& value);
  void with_arguments(const std::string& name);
};

/// Returns the name in C of a function that C++ calls by another.
std::string name_in_c(const std::string& name);

}  // namespace qvgen::emit::blocks::runtime
