// SPDX-License-Identifier: MIT
#include "emit/cpp/tidy.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
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

/// Prose of comments flows on: the words that a line has no room for begin the next line of the
/// paragraph.
TEST(Tidy, ProseFlowsOn) {
  const std::string full(line_width - 5, 'a');
  EXPECT_EQ(wrapped("/// " + full + " b\n/// c\nint d;\n"), "/// " + full + "\n/// b c\nint d;\n");
  EXPECT_EQ(wrapped("// " + full + "  b\n// -360 c\n"), "// " + full + "\n// b -360 c\n");
  for (const char* next : {"///\n", "/// - c\n", "///     c\n", "  /// c\n", "// c\n", "int c;\n", ""})
    EXPECT_EQ(wrapped("/// " + full + " b\n" + next), "/// " + full + "\n/// b\n" + next);
}

/// Words longer than a line, behind a mark that continuation lines repeat: once an endless loop.
/// Whatever the carried words begin with, the code behind the comment stays code.
TEST(Tidy, ProseEndsBeforeCode) {
  const std::string full = "/// " + std::string(line_width - 4, 'a');
  for (const char* word : {"word", "(in brackets)", "-1", "<", "`code`"})
    EXPECT_EQ(wrapped(full + " " + word + "\ntemplate <class T>\n"),
              full + "\n/// " + word + "\ntemplate <class T>\n");
}

/// A comment behind code goes to the next line whole: what is broken within would be code again.
TEST(Tidy, CommentsBehindCodeStayWhole) {
  const std::string code = "  const double& cosine_4 = angles.cosine[4];",
                    words = "// of angle(0." + std::string(line_width - 40, '6') + ") - theta1";
  EXPECT_EQ(wrapped(code + "  " + words + "\n"), code + "\n      " + words + "\n");
}

TEST(Tidy, LongWordsEnd) {
  const std::string number(150, '7');
  EXPECT_EQ(wrapped("//   - " + number + " more\n"), "//   - " + number + "\n//     more\n");
  EXPECT_EQ(wrapped("  /// " + number + "\n"), "  /// " + number + "\n");
  EXPECT_EQ(wrapped("// a " + number + " b\n"), "// a\n// " + number + "\n// b\n");
}

std::string without_spaces(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }),
             text.end());
  return text;
}

/// Returns a line of random words, marks and indentation.
std::string random_line(std::mt19937& random) {
  static const std::vector<std::string> starts{"",         "  ",        "//", "// ", "  /// ",
                                               "  /// - ", "//     - ", "#",  "{"};
  static const std::vector<std::string> marks{" ",  ", ",  " + ", " - ", "(", ")",
                                              "\"", " = ", "<",   ">",   "{", "- "};
  const auto pick = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  std::string line = starts[pick(starts.size())];
  for (std::size_t i = pick(30); i-- > 0;)
    line += std::string(pick(8) == 0 ? pick(300) : pick(12), 'x') + marks[pick(marks.size())];
  return line + "\n";
}

/// Whatever a line holds: the loop ends, no letter is lost, and what may be broken is.
TEST(Tidy, EveryLineEnds) {
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const std::string line = random_line(random);
    const std::string result = wrapped(line);
    ASSERT_LE(result.size(), 60 * line.size()) << line;
    const bool comment = line.find_first_not_of(' ') == line.find("//");
    if (!comment) {
      ASSERT_EQ(without_spaces(result), without_spaces(line));
    }
  }
}

/// Generated lines are short, and tidying them again changes nothing.
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
