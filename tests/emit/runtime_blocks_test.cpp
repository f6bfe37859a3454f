// SPDX-License-Identifier: MIT
// Headers of the C++ runtime read as C: golden texts of what the two languages write differently.
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "emit/blocks/runtime/runtime.h"
#include "emit/builtin_templates.h"
#include "emit/c/inverse/blocks.h"
#include "patterns.h"

namespace qvgen::test {
namespace {

using emit::blocks::NotInSubset;
using emit::blocks::runtime::Reader;
using testing::HasSubstr;

const std::string known = R"(
typedef struct Branch {
  bool exists, unsure;
} Branch;
static const Branch new_branch = {true, false};
typedef struct Rotor {
  double cosine, sine;
} Rotor;
static Rotor rotor(double cosine, double sine) {
  const Rotor r = {cosine, sine};
  return r;
}
static Rotor product(Rotor a, Rotor b) { return rotor(a.cosine * b.cosine, a.sine * b.sine); }
static void doubt(Branch* branch, bool condition) { branch->unsure = branch->unsure || condition; }
static const double pi = 3;
enum { most_rows = 1, most_columns = 1 };
typedef struct Task {
  int rows;
  double of[most_rows];
} Task;
)";

std::string in_c(const std::string& header) {
  Reader reader;
  reader.read_c({"known.c", "inverse", false, known});
  return reader.in_c(
      {"header.h", "inverse", false, "namespace a::b {\n" + header + "}  // namespace a::b\n"});
}

std::string error_in(const std::string& header) {
  try {
    return "no error: " + in_c(header);
  } catch (const NotInSubset& error) {
    return error.what();
  }
}

TEST(RuntimeBlocks, NumbersAndTruthValuesAreThoseOfC) {
  EXPECT_EQ(in_c(R"(
/// √2 of it.
template <typename Scalar>
Scalar part(const Scalar& a, const Mask<Scalar>& is_free, const Scalar& pi) {
  using std::sqrt;
  const Mask<Scalar> none = (a < Scalar(0)) & !is_free;
  return -sqrt(Scalar(a / Scalar(2))) * (a - (Scalar(1) - pi)) + select(none | is_free, Scalar(-1), abs(a));
}
)"),
            R"(/// root of 2 of it.
static inline double part(double a, bool is_free) {
  const bool none = a < 0.0 && !is_free;
  return -sqrt(a / 2.0) * (a - (1.0 - pi)) + (none || is_free ? -1.0 : fabs(a));
}

)");
}

TEST(RuntimeBlocks, ReferencesBecomePointersOrCopies) {
  EXPECT_EQ(in_c(R"(
template <typename Scalar>
struct Roots {
  int count = 0;
  std::array<Scalar, 3> root;  ///< ascending
};
template <typename Scalar>
void add(const Scalar& x, Roots<Scalar>& roots, Branch<Scalar>& branch) {
  branch.doubt(x == Scalar(0));
  roots.root[static_cast<std::size_t>(roots.count++)] = x;
}
template <typename Scalar>
Roots<Scalar> both(const Roots<Scalar>& from, const Scalar& x) {
  Roots<Scalar> found;
  Branch<Scalar> branch;
  for (int i = 0; i < from.count; ++i) add(x, found, branch);
  if (!branch.exists)
    found.count = 1;
  else
    return from;
  return found;
}
)"),
            R"(typedef struct Roots {
  int count;
  // ascending
  double root[3];
} Roots;

static inline void add(double x, Roots* roots, Branch* branch) {
  doubt(branch, x == 0.0);
  roots->root[roots->count++] = x;
}

static Roots both(Roots from, double x) {
  Roots found;
  found.count = 0;
  Branch branch = new_branch;
  for (int i = 0; i < from.count; ++i) add(x, &found, &branch);
  if (!branch.exists) {
    found.count = 1;
  } else {
    return from;
  }
  return found;
}

)");
}

TEST(RuntimeBlocks, FlagsOfTemplatesAreArguments) {
  const std::string text = in_c(R"(
template <typename Scalar, bool opposites = false>
Rotor<Scalar> turned(const Rotor<Scalar>& u) {
  if constexpr (leaves_singular_poses<Scalar>) return u;
  if constexpr (opposites) return u * u;
  return {u.sine, Scalar(-u.cosine)};
}
template <typename Scalar>
Rotor<Scalar> twice(const Rotor<Scalar>& u) {
  return turned<Scalar, true>(u) * turned(Rotor<Scalar>{u.sine, u.cosine});
}
)");
  EXPECT_THAT(text, HasSubstr("turned(bool opposites, Rotor u) {\n  if (opposites) return product(u, u);\n"
                              "  return rotor(u.sine, -u.cosine);"));
  EXPECT_THAT(text, HasSubstr("return product(turned(true, u), turned(false, rotor(u.sine, u.cosine)));"));
}

TEST(RuntimeBlocks, MethodsAreFunctionsOfTheirObject) {
  EXPECT_EQ(in_c(R"(
struct Boundary {
  double accept = 0;  ///< so far outside
                      ///< is inside
  bool take{true};

  static constexpr Boundary wide(double allowed) {
    Boundary boundary = plain(allowed);
    boundary.take = false;
    return boundary;
  }
  /// Returns that of a regular pose.
  static constexpr Boundary plain(double accept) {
    Boundary boundary;
    boundary.accept = accept;
    return boundary;
  }
  [[nodiscard]] constexpr Boundary copied() const {
    Boundary boundary = *this;
    return boundary;
  }
  void close(const Boundary& other) { accept = other.accept; }
};
)"),
            R"(typedef struct Boundary {
  // so far outside is inside
  double accept;
  bool take;
} Boundary;

static const Boundary new_boundary = {0, true};

/// Returns that of a regular pose.
static inline Boundary plain_boundary(double accept) {
  Boundary boundary = new_boundary;
  boundary.accept = accept;
  return boundary;
}

static inline Boundary wide_boundary(double allowed) {
  Boundary boundary = plain_boundary(allowed);
  boundary.take = false;
  return boundary;
}

static inline Boundary copied(const Boundary* self) {
  Boundary boundary = *self;
  return boundary;
}

static inline void close(Boundary* self, const Boundary* other) {
  self->accept = other->accept;
}

)");
}

TEST(RuntimeBlocks, AConstructorIsAFunctionNamedAfterItsStruct) {
  const std::string text = in_c(R"(
template <typename Scalar>
struct HalfAngle {
  Scalar half;

  explicit HalfAngle(const Scalar& angle) { half = angle / Scalar(2); }
  Scalar from(const Scalar& axis) const { return axis + half; }
};
template <typename Scalar>
Scalar sum(const Scalar& a) {
  const HalfAngle<Scalar> named(a);
  return named.from(a) + HalfAngle<Scalar>(a).from(a);
}
)");
  EXPECT_THAT(text, HasSubstr("HalfAngle half_angle(double angle) {\n  HalfAngle self;\n"
                              "  self.half = angle / 2.0;\n  return self;\n}"));
  EXPECT_THAT(text, HasSubstr("double from(HalfAngle self, double axis) {\n  return axis + self.half;"));
  EXPECT_THAT(text, HasSubstr("const HalfAngle named = half_angle(a);\n"
                              "  return from(named, a) + from(half_angle(a), a);"));
}

TEST(RuntimeBlocks, FunctionsForDoublesTakeThePlaceOfGeneralOnes) {
  const std::string text = in_c(R"(
template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x) { return atan2(y, x); }
namespace polynomial {
template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x) { return y / x; }
template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x, const Scalar& length) { return arctangent(y, x) / length; }
}
inline double arctangent(double y, double x) { return polynomial::arctangent(y, x); }
)");
  EXPECT_EQ(text,
            "static inline double arctangent(double y, double x) {\n  return y / x;\n}\n\n"
            "static inline double arctangent_of_length(double y, double x, double length) {\n"
            "  return arctangent(y, x) / length;\n}\n\n");
}

const std::string sums = R"(
template <typename Scalar, std::size_t rows>
using Vector = std::array<Scalar, rows>;
template <typename Scalar, std::size_t columns, std::size_t rows>
using Columns = std::array<Vector<Scalar, rows>, columns>;
template <typename Scalar, std::size_t rows>
Scalar sum(const Vector<Scalar, rows>& v) {
  Scalar all(0);
  for (std::size_t i = 0; i < rows; ++i) all += v[i];
  return all;
}
)";

/// C++ knows sizes when it compiles, C when it runs: the types of a call's arguments say them.
TEST(RuntimeBlocks, SizesOfTemplatesAreArguments) {
  EXPECT_EQ(in_c(sums + R"(
template <typename Scalar, std::size_t columns>
struct Both {
  Vector<Scalar, columns> sums;
  Columns<Scalar, columns, 2> pairs;
};
template <typename Scalar, std::size_t columns, std::size_t rows>
Scalar all_of(const Columns<Scalar, columns, rows>& a) {
  Both<Scalar, columns> both{};
  Vector<Scalar, columns + 1> more{};
  for (std::size_t i = 0; i < columns; ++i) both.sums[i] = sum(a[i]);
  return sum(both.sums) + sum(both.pairs[0]) + sum(more);
}
)"),
            R"(typedef struct Vector {
  double of[most_rows];
} Vector;

typedef struct Columns {
  Vector of[most_columns];
} Columns;

typedef struct Both {
  Vector sums;
  Columns pairs;
} Both;

static double sum(int rows, const Vector* v) {
  double all = 0;
  for (int i = 0; i < rows; ++i) all += v->of[i];
  return all;
}

static double all_of(int columns, int rows, const Columns* a) {
  Both both = {{{0}}};
  Vector more = {{0}};
  for (int i = 0; i < columns; ++i) both.sums.of[i] = sum(rows, &a->of[i]);
  return sum(columns, &both.sums) + sum(2, &both.pairs.of[0]) + sum(columns + 1, &more);
}

)");
}

/// A struct of C may have its sizes as fields: who gets it needs no argument more.
TEST(RuntimeBlocks, ASizeThatIsAFieldIsNoArgument) {
  const std::string text = in_c(sums + R"(
constexpr std::size_t twice(std::size_t rows) { return 2 * rows; }
template <typename Scalar, std::size_t rows>
Scalar all_of(const Task<Scalar, rows>& task, const Vector<Scalar, rows>& v, const Vector<Scalar, twice(rows)>& w) {
  return Scalar(rows) * task.of[rows - 1] + sum(v) + sum(w);
}
)");
  EXPECT_THAT(text, HasSubstr("double all_of(const Task* task, const Vector* v, const Vector* w) {\n"
                              "  return (double)task->rows * task->of[task->rows - 1] + sum(task->rows, v) + "
                              "sum(twice(task->rows), w);\n}"));
}

TEST(RuntimeBlocks, ASizeThatNothingSaysIsRefusedWithItsPlace) {
  const auto error_of = [](const std::string& parameter, const std::string& statement) {
    return error_in(sums + "template <typename Scalar, std::size_t rows>\nScalar f(const " + parameter +
                    "& x) {\n  " + statement + "\n}\n");
  };
  EXPECT_THAT(error_of("Vector<Scalar, rows>", "return sum(x);"), HasSubstr("no error"));
  EXPECT_THAT(error_of("Scalar", "return sum(x);"),
              HasSubstr("header.h:15: no argument says the rows of sum"));
  EXPECT_THAT(error_of("Columns<Scalar, rows>", "return sum(x[0]);"),
              HasSubstr("header.h:14: another number of sizes than Columns has"));
  EXPECT_THAT(error_of("Vector<Scalar, 2 * rows>", "return sum(x);"), HasSubstr("no error"));
  EXPECT_THAT(error_of("Vector<Scalar, 2 * lines>", "return sum(x);"),
              HasSubstr("header.h:15: the size lines is not declared"));
  EXPECT_THAT(error_of("Vector<Scalar, rows", "return sum(x);"), HasSubstr("header.h:"));
}

TEST(RuntimeBlocks, WhatLeavesTheSubsetIsRefusedWithItsPlace) {
  const auto error_of = [](const std::string& statement) {
    return error_in("template <typename Scalar>\nScalar f(Scalar x) {\n  " + statement + "\n}\n");
  };
  EXPECT_THAT(error_of("return erf(x);"), HasSubstr("header.h:4: the function erf is not declared"));
  EXPECT_THAT(error_of("const Scalar rotor = x; return rotor(x, x);"),
              HasSubstr("header.h:4: a variable hides the function rotor"));
  EXPECT_THAT(error_of("Branch<Scalar> b; b.doubt(true, x);"),
              HasSubstr("header.h:4: another number of arguments than doubt has"));
  EXPECT_THAT(error_of("const auto g = [&](Scalar y) { return y; };"), HasSubstr("header.h:4:"));
  EXPECT_THAT(error_of("return (x;"), HasSubstr("header.h:"));
  EXPECT_THAT(error_in("struct A {\n  int b() const;\n};\n"),
              HasSubstr("header.h:3: a member function without a body: int b() const;"));
  for (const char* header :
       {"template <typename Scalar", "template <typename Scalar>\nstruct A {\n  int b;\n", "Scalar f(",
        "inline constexpr double a = 1", "Scalar f()", "Scalar", "struct A {\n  int b\n};\n"})
    EXPECT_THAT(error_in(header), HasSubstr("header.h:")) << header;
}

/// Names of the blocks that kinds of equations call.
std::set<std::string> blocks_of_kinds() {
  const std::string called = R"re("([a-z_]+)",\s+(solve|\[\]\(auto))re";
  std::set<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(QVGEN_SOURCE_DIR "/generator/derive/inverse/kinds")) {
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    for (const patterns::Match& each : patterns::all(text.str(), called)) names.insert(each.groups[1]);
  }
  return names;
}

/// An equation stands in a header of the runtime alone.
TEST(RuntimeBlocks, NoTemplateOfCHasAnEquation) {
  const std::set<std::string> names = blocks_of_kinds();
  EXPECT_GT(names.size(), 20U);
  for (const std::string& name : names) {
    const std::string definition = "static [A-Za-z ]+ " + name + "\\(";
    EXPECT_TRUE(patterns::occurs(emit::c::inverse_blocks(), definition)) << name;
    for (const auto& [file, text] : emit::builtin_templates())
      EXPECT_FALSE(file.rfind("c/", 0) == 0 && patterns::occurs(text, definition))
          << name << " is in " << file;
  }
}

TEST(RuntimeBlocks, CommentsAreAscii) {
  for (const char c : emit::c::inverse_blocks()) ASSERT_GT(c, 0);
}

}  // namespace
}  // namespace qvgen::test
