// SPDX-License-Identifier: MIT
#include "emit/cpp/tidy.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

namespace qvgen::emit {
namespace {

TEST(Tidy, AttributeStaysWhereNothingNamesTheThing) {
  const std::string used = "void f(const T& q) { g(q); }\n";
  EXPECT_EQ(without_needless_attributes("void f([[maybe_unused]] const T& q) { g(q); }\n"), used);
  for (const char* unused : {"void f([[maybe_unused]] const T& q) { g(t.q, a.b->q, x::q, qd); }\n",
                             "void f([[maybe_unused]] const T& q) { g(); }  // q\nint q;\n",
                             "void f([[maybe_unused]] const T& q);\nint g() { return q; }\n",
                             "{ [[maybe_unused]] const double q = h; }\nf(q);\n"})
    EXPECT_EQ(without_needless_attributes(unused), unused);
}

TEST(Tidy, AttributeOfAliasesAndVariables) {
  EXPECT_EQ(without_needless_attributes("{ using S [[maybe_unused]] = double; S a; }"),
            "{ using S = double; S a; }");
  EXPECT_EQ(without_needless_attributes("{ [[maybe_unused]] const A<B, C> a = b; { f(a); } }"),
            "{ const A<B, C> a = b; { f(a); } }");
}

TEST(Tidy, SpareLines) {
  EXPECT_EQ(without_spare_lines("a\n\n\nvoid f() {\n\n  b;\n\n}\n"), "a\n\nvoid f() {\n  b;\n}\n");
}

TEST(Tidy, BreaksOutermostFirst) {
  const std::string inner(50, 'b');
  EXPECT_EQ(wrapped("  f(a" + inner + ", g(" + inner + ", c), " + inner + ");\n"),
            "  f(a" + inner + ", g(" + inner + ", c),\n      " + inner + ");\n");
  const std::string text = "\"" + std::string(130, ' ') + "\"";
  const std::string name(40, 'a');
  EXPECT_EQ(wrapped(name + " = " + text + ";\n"), name + " =\n    " + text + ";\n");
}

TEST(Tidy, CommentsKeepTheirMarks) {
  std::string words;
  for (int i = 0; i < 30; ++i) words += " word";
  std::istringstream lines(wrapped("  /// -" + words + "\n"));
  std::string first, second;
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_LE(first.size(), line_width);
  EXPECT_EQ(second.substr(0, 12), "  ///   word");
}

std::string without_spaces(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }),
             text.end());
  return text;
}

/// Of everything that is generated: lines are short, and to tidy it again changes nothing.
TEST(Tidy, GeneratedCodeIs) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(QVGEN_SOURCE_DIR "/generated")) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    ++files;
    std::ifstream stream(entry.path());
    const std::string code{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_EQ(tidy(code), code) << entry.path();
    EXPECT_EQ(without_spaces(wrapped(code)), without_spaces(code));
    std::istringstream lines(code);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), line_width) << entry.path();
  }
  EXPECT_GT(files, 100);
}

}  // namespace
}  // namespace qvgen::emit
