// SPDX-License-Identifier: MIT
// Compact code is the same code: with its names put back and without spaces it reads as what it was made of.
#include "emit/cpp/compact.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "emit/cpp/compact_text.h"
#include "patterns.h"

namespace {

using namespace qvgen;

std::vector<std::string> split(std::string text, char at) {
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// Numbers by the usual name of Scalar.
std::string with_usual_numbers(const std::string& text) {
  return patterns::replaced(text, "\\bN\\(", "Scalar(");
}

std::string without_spaces(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

/// Replaces each word that has a text.
std::string replaced(const std::string& text, const std::map<std::string, std::string>& texts) {
  std::string result, word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      word += c;
      continue;
    }
    const auto known = texts.find(word);
    result += (known == texts.end() ? word : known->second) + c;
    word.clear();
  }
  return result.substr(0, result.size() - 1);
}

/// A function of so many values, each of two before it, numbers and arguments.
emit::Code random_code(std::size_t count, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const auto operand = [&](std::size_t before) -> std::string {
    const std::size_t kind = below(4);
    if (kind == 0) return "Scalar(" + std::to_string(below(9)) + "e-0" + std::to_string(below(9)) + ")";
    if (kind == 1 || before == 0) return below(2) == 0 ? "s" + std::to_string(below(9)) : "qd[3]";
    return "t" + std::to_string(below(before));
  };
  emit::Code code;
  const std::vector<std::string> operators{" + ", " - ", " * ", " / ", " - -"};
  for (std::size_t i = 0; i < count; ++i)
    code.temporaries.push_back({"t" + std::to_string(i), operand(i) + operators[below(5)] + operand(i)});
  for (std::size_t i = 0; i < 9; ++i) code.outputs.push_back({"o", operand(count)});
  return code;
}

TEST(Compact, ReadsAsBeforeWithItsNamesPutBack) {
  std::mt19937 random(1);
  for (const std::size_t count : {1U, 2U, 40U, 700U, 3000U, 30000U}) {
    const emit::Code code = random_code(count, random);
    const emit::Code compact = emit::compact(code);
    std::map<std::string, std::string> texts;
    std::size_t next = 0;
    for (const auto& [name, expression] : compact.temporaries) {
      const bool is_number = expression.starts_with("N(") && expression.find(')') + 1 == expression.size();
      EXPECT_TRUE(std::set<std::string>({"at", "do", "if", "or", "r", "q", "k"}).count(name) == 0) << name;
      EXPECT_TRUE(texts.emplace(name, is_number ? expression : code.temporaries[next].name).second) << name;
      EXPECT_LE(name.size(), 4U);
      if (is_number) continue;
      ASSERT_EQ(without_spaces(with_usual_numbers(replaced(expression, texts))),
                without_spaces(code.temporaries[next].expression));
      ++next;
    }
    EXPECT_EQ(next, count);
    for (std::size_t i = 0; i < code.outputs.size(); ++i)
      EXPECT_EQ(without_spaces(with_usual_numbers(replaced(compact.outputs[i].expression, texts))),
                without_spaces(code.outputs[i].expression));
  }
}

/// All values are declared once, none before one that it reads.
TEST(Compact, ValuesComeBehindWhatTheyRead) {
  std::mt19937 random(3);
  for (const std::size_t count : {1U, 2U, 40U, 700U, 3000U}) {
    const emit::Code compact = emit::compact(random_code(count, random));
    std::map<std::string, std::string> expected;
    for (const auto& [name, expression] : compact.temporaries) expected.emplace(name, expression);
    std::map<std::string, std::string> declared;
    const std::string text = emit::compact_statements(compact.temporaries, {});
    for (const std::string& value : split(text.substr(std::string("N ").size()), ',')) {
      const std::size_t middle = value.find('=');
      const std::string name = value.substr(0, middle), expression = value.substr(middle + 1);
      EXPECT_EQ(expected.at(name), expression);
      emit::with_words(expression, [&](const std::string& word) {
        EXPECT_TRUE(expected.count(word) == declared.count(word)) << word << " in " << value;
        return word;
      });
      EXPECT_TRUE(declared.emplace(name, expression).second) << name;
    }
    EXPECT_EQ(declared.size(), expected.size());
  }
}

/// u is the last to read t, so that one of them is kept: it comes before v, which is one more.
TEST(Compact, LastReadersComeFirst) {
  EXPECT_EQ(
      emit::compact_statements({{"t", "q[0]*q[1]"}, {"v", "q[0]*q[2]"}, {"u", "t*t"}}, {{"result", "u*v"}}),
      "N t=q[0]*q[1],u=t*t,v=q[0]*q[2];result=u*v");
}

TEST(Compact, LinesAreAsLongAsOthers) {
  std::mt19937 random(2);
  const std::string text = emit::compact_statements(emit::compact(random_code(3000, random)).temporaries, {});
  for (std::size_t begin = 0, end = 0; end < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    EXPECT_LE(end - begin + (begin == 0 ? 2 : 0), 120U);
  }
}

TEST(Compact, NumbersThatComeBackHaveNames) {
  const emit::Code compact = emit::compact(
      {{{"t0", "Scalar(0.5) * q[0]"}, {"t1", "Scalar(0.5) * t0 - Scalar(2)"}}, {{"o", "Scalar(0.5) * t1"}}});
  EXPECT_EQ(emit::compact_statements(compact.temporaries, {}), "N t=N(.5),u=t*q[0],v=t*u-N(2)");
  EXPECT_EQ(compact.outputs[0].expression, "t*v");
}

TEST(Compact, WhatIsUsedMostHasTheShortestName) {
  emit::Code code{{{"t0", "q[0] * q[1]"}}, {}};
  for (int i = 1; i < 40; ++i) {
    const std::string before = "t" + std::to_string(i - 1);
    code.temporaries.push_back({"t" + std::to_string(i), before + " * " + (i > 20 ? before : "q[1]")});
  }
  const emit::Code compact = emit::compact(code);
  EXPECT_EQ(compact.temporaries[20].name, "t");
  EXPECT_EQ(compact.temporaries[0].name.size(), 2U);
}

/// Terms of a sum are added from the left; brackets behind an operator and around a factor stay.
TEST(Compact, NoBracketsStandAroundTheFirstTermsOfASum) {
  const auto compact = [](const std::string& text) {
    return emit::compact({{}, {{"o", text}}}).outputs[0].expression;
  };
  EXPECT_EQ(compact("((a + b) - c) + d"), "a+b-c+d");
  EXPECT_EQ(compact("((a * b - c) + d) * (e - (f + g))"), "(a*b-c+d)*(e-(f+g))");
  EXPECT_EQ(compact("(a + b) * c"), "(a+b)*c");
  EXPECT_EQ(compact("-(a + b) - c"), "-(a+b)-c");
  EXPECT_EQ(compact("a - ((b + c) - d)"), "a-(b+c-d)");
  EXPECT_EQ(compact("(a < b ? a : b) + c"), "(a<b?a:b)+c");
}

TEST(Compact, SpacesBetweenSignsAndWordsStay) {
  const std::string root = "[](const Scalar& operand) { using std::sqrt; return sqrt(operand); }(t0)";
  const emit::Code compact = emit::compact({{{"t0", "a - -b"}}, {{"o", root}}});
  EXPECT_EQ(compact.temporaries[0].expression, "a- -b");
  EXPECT_EQ(compact.outputs[0].expression,
            "[](const Scalar&operand){using std::sqrt;return sqrt(operand);}(t)");
}

TEST(Compact, ManyZerosAreSetAtOnce) {
  EXPECT_EQ(emit::compact_statements(
                {}, {{"result.m(0, 0) = result.m(1, 1) = result.m(2, 2) = result.m(3, 3)", "Scalar(0)"},
                     {"result.m(0, 1)", "t0"},
                     {"result.v[0]", "t1"}}),
            "auto& r=result.m;r.setZero();auto& r1=result.v;r(0,1)=t0;r1[0]=t1");
}

/// Setting them at once and the others again would take more instructions.
TEST(Compact, FewZerosAreSetOneByOne) {
  EXPECT_EQ(emit::compact_statements({}, {{"result(0, 0) = result(2, 2) = result(1, 1)", "Scalar(0)"},
                                          {"result(0, 1) = result(1, 0)", "t0"}}),
            "auto& r=result;r(0,0)=r(1,1)=r(2,2)=Scalar(0);r(0,1)=r(1,0)=t0");
}

/// Columns lie in memory one behind the other; a run ends with its column's object.
TEST(Compact, ZerosBelowOneAnotherAreFilled) {
  EXPECT_EQ(
      emit::compact_statements(
          {}, {{"result.m(11, 2) = result.m(9, 2) = result.m(10, 2) = result.m(8, 2) = result.m(12, 3) = "
                "result.v[0] = result.v[3] = result.v[2] = result.v[1] = result.v[5] = result.x",
                "Scalar(0)"},
               {"result.m(0, 0) = result.m(1, 0)", "t0"},
               {"result.v[4] = result.v[6] = result.v[7]", "t1"}}),
      "auto& r=result.m;auto& r1=result.v;r.template block<4,1>(8,2).setZero();std::fill_n(&r1[0],4,Scalar("
      "0));\nr(12,3)=r1[5]=Scalar(0);result.x=Scalar(0);r(0,0)=r(1,0)=t0;r1[4]=r1[6]=r1[7]=t1");
}

/// The columns of a tip's joint, then the rows of what its forces do to those that carry it.
TEST(Compact, OutputsComeFromTheTipsToTheBase) {
  const std::vector<std::string> places{"v[0]",    "v[1]",    "v[2]",    "m(0, 0)", "m(0, 1) = m(1, 0)",
                                        "m(2, 1)", "m(1, 2)", "m(2, 2)", "m(1, 1)"};
  std::vector<std::string> ordered;
  for (const std::size_t i : emit::from_tips_to_base(places)) ordered.push_back(places[i]);
  const std::vector<std::string> expected{"m(2, 2)",           "m(1, 2)", "m(2, 1)", "v[2]",   "m(1, 1)",
                                          "m(0, 1) = m(1, 0)", "v[1]",    "v[0]",    "m(0, 0)"};
  EXPECT_EQ(ordered, expected);
}

TEST(Compact, OutputsAreStoredAsSoonAsTheyAreKnown) {
  EXPECT_EQ(emit::compact_statements(
                {{"t", "q[0]*q[1]"}, {"u", "t*t"}, {"v", "u-t"}, {"w", "v*v"}},
                {{"result[0]", "v+u"}, {"result[1]", "t"}, {"result[2]", "-t*q[2]"}, {"result[3]", "w"}}),
            "auto& r=result;N t=q[0]*q[1];r[1]=t;r[2]=-t*q[2];N u=t*t,v=u-t;r[0]=v+u;N w=v*v;r[3]=w");
}

TEST(Compact, ReferencesToSinesAreShort) {
  const std::vector<std::string> lines =
      emit::compact_angles({"const Scalar &s5 = angles.sine[0], &c12 = angles.cosine[10];",
                            "const Scalar &s_0 = angles.sine[3];", "// s_0: of theta1/2 - pi/4"});
  const std::vector<std::string> expected{"const Scalar &s5=s[0],&c12=c[10],&s_0=s[3];",
                                          "// s_0: of theta1/2 - pi/4"};
  EXPECT_EQ(lines, expected);
  EXPECT_EQ(emit::compact_angles({"const Scalar &c1 = angles.cosine[0];"}).size(), 1U);
  EXPECT_TRUE(emit::compact_angles({}).empty());
}

TEST(Compact, AScalarHasNoOtherName) {
  EXPECT_EQ(emit::compact_statements({}, {{"result", "Scalar(0)"}}), "result=Scalar(0)");
}

}  // namespace
