// SPDX-License-Identifier: MIT
// C read as a tree and printed in other languages: golden texts, and what leaves the subset is refused with
// its place.
#include "emit/c/inverse/blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "emit/blocks/reached.h"
#include "emit/c/single_precision.h"
#include "emit/javascript/writer.h"
#include "emit/rust/crate.h"
#include "emit/rust/writer.h"

namespace qvgen::test {
namespace {

using emit::blocks::File;
using emit::blocks::NotInSubset;
using emit::blocks::parse;
using emit::blocks::Shapes;
using emit::blocks::Unit;
using testing::HasSubstr;

Unit unit_of_blocks(const std::string& text) { return parse("arm", {{"blocks.c", "inverse", false, text}}); }

std::string error_of_blocks(const std::string& text) {
  try {
    const Unit unit = unit_of_blocks(text);
    (void)emit::rust::crate(unit, std::nullopt, {});
  } catch (const NotInSubset& error) {
    return error.what();
  }
  return "";
}

template <class Writer, class Context>
std::string printed_blocks(const std::string& text, const std::string& function) {
  const Unit unit = unit_of_blocks(text);
  const Shapes shapes(unit);
  const Context context{unit, shapes};
  std::string result;
  for (const std::string& line : Writer(context, *unit.function(function)).lines()) result += line + "\n";
  return result;
}

std::string in_rust(const std::string& text, const std::string& function) {
  return printed_blocks<emit::rust::FunctionWriter, emit::rust::Context>(text, function);
}
std::string in_javascript(const std::string& text, const std::string& function) {
  return printed_blocks<emit::javascript::FunctionWriter, emit::javascript::Context>(text, function);
}

const std::string shared_blocks = R"(
typedef struct Pair {
  double a, b;
  int count;
} Pair;

static void add(const double* x, double* y, int count) {
  for (int i = 0; i < count; ++i) y[i] += 2 * x[i];
}
)";

TEST(Blocks, ALoopBecomesARange) {
  EXPECT_EQ(in_rust(shared_blocks, "add"), R"(fn add(x: &[f64], y: &mut [f64], count: i32) {
    for i in 0..count {
        y[i as usize] += 2.0 * x[i as usize];
    }
}
)");
  EXPECT_EQ(in_javascript(shared_blocks, "add"), R"(function add(x, y, count) {
  for (let i = 0; i < count; ++i) {
    y[i] += 2 * x[i];
  }
}
)");
}

TEST(Blocks, AnArgumentThatTheCallChangesIsCopied) {
  const std::string text = shared_blocks + "static void twice(double x[3]) {\n  add(x, x, 3);\n}\n";
  EXPECT_THAT(in_rust(text, "twice"), HasSubstr("let copy0 = *x; add(&copy0, x, 3)"));
  const std::string unknown = shared_blocks + "static void twice(double* x) {\n  add(x, x, 3);\n}\n";
  EXPECT_THAT(error_of_blocks(unknown),
              HasSubstr("twice: an argument of x overlaps what the call changes, and has no size"));
}

TEST(Blocks, AnObjectAndAPartOfItAreNotChangedAtOnce) {
  const std::string text = shared_blocks +
                           "static void both(Pair* p, double* a) {\n  *a += p->a;\n  p->a = 0;\n}\n"
                           "static void call(Pair* p) {\n  both(p, &p->a);\n}\n";
  EXPECT_THAT(error_of_blocks(text), HasSubstr("call: both gets an object to change and a part of it"));
}

TEST(Blocks, NumbersKeepTheirKind) {
  const std::string text = shared_blocks +
                           "static double mean(const Pair* p) {\n"
                           "  const int half = p->count / 2;\n"
                           "  return half * p->a + (p->count > 0) + 0x1.8p1;\n}\n";
  EXPECT_EQ(in_rust(text, "mean"), R"(fn mean(p: &Pair) -> f64 {
    let half = p.count / 2;
    f64::from(half) * p.a + f64::from(u8::from(p.count > 0)) + 3.0
}
)");
  EXPECT_EQ(in_javascript(text, "mean"), R"(function mean(p) {
  const half = Math.trunc(p.count / 2);
  return half * p.a + Number(p.count > 0) + 3;
}
)");
}

TEST(Blocks, AStructIsCopiedWhereCCopies) {
  const std::string text =
      shared_blocks +
      "static Pair raised(Pair p) {\n  p.a += 1;\n  return p;\n}\n"
      "static double both(const Pair* p) {\n  Pair q = *p;\n  q = raised(q);\n  return q.a;\n}\n";
  EXPECT_EQ(in_javascript(text, "raised"),
            "function raised(p) {\n  p = copyPair(p);\n  p.a += 1;\n  return p;\n}\n");
  EXPECT_THAT(in_javascript(text, "both"), HasSubstr("const q = copyPair(p);\n  setPair(q, raised(q));"));
  EXPECT_THAT(in_rust(text, "both"), HasSubstr("let mut q = *p;\n    q = raised(q);"));
}

TEST(Blocks, AStepBeforeTheNextRoundIsDone) {
  const std::string text =
      "static int odd(int n) {\n  int sum = 0;\n  for (int i = 0; i < n; i += 1) {\n    if (i % 2 == 0) "
      "continue;\n"
      "    sum += i;\n  }\n  return sum;\n}\n";
  EXPECT_THAT(in_rust(text, "odd"), HasSubstr("i += 1;\n                continue;"));
}

TEST(Blocks, WhatLeavesTheSubsetIsRefusedWithItsPlace) {
  const auto error_in = [](const std::string& statement) {
    return error_of_blocks("static void f(double* x) {\n  " + statement + "\n}\n");
  };
  EXPECT_THAT(error_in("goto end;"), HasSubstr("blocks.c:2: goto is not in the subset"));
  EXPECT_THAT(error_in("y = 1;"), HasSubstr("blocks.c:2: \"y\" is not declared: y = 1;"));
  EXPECT_THAT(error_in("*x = pow(*x, 2);"), HasSubstr("blocks.c:2: the function pow is not declared"));
  EXPECT_THAT(error_in("double (*rows)[3] = 0;"), HasSubstr("pointers to arrays or to functions"));
  EXPECT_THAT(error_in("do { } while (1);"), HasSubstr("blocks.c:2: do is not in the subset"));
  EXPECT_THAT(error_in("float y = 0;"), HasSubstr("blocks.c:2: \"float\" is not declared"));
  EXPECT_THAT(error_in("x[0] = 1;"), "");
  EXPECT_THAT(error_of_blocks("static void f(void) {\n"), HasSubstr("a block without an end"));
  EXPECT_THAT(error_of_blocks("double x;\n"), HasSubstr("a variable outside of functions"));
}

/// All blocks of inverse kinematics: templates, and what is read from headers of the runtime.
TEST(Blocks, AllAreInTheSubset) {
  const std::string sizes = R"(
enum { dof = 6, whole_dof = 8, first_inner = 1, first_behind = 7, bounded = 7, turn_count = 6, row_size = 6, capacity = 8, most_joints = 6, most_rows = 12, most_branches = 8, gap_count = 4, passive_count = 3, driven_count = 3, system_size = 3 };
enum { status_solved, status_singular, status_unreachable, status_invalid, status_incomplete };
static const bool is_revolute[row_size] = {true, true, true, true, true, true};
static const bool whole_is_revolute[whole_dof] = {true, true, true, true, true, true, true, true};
static const int inner_places[dof] = {1, 2, 3, 4, 5, 6};
typedef struct Effort {
  int passes, steps, used_up;
} Effort;
typedef struct Solution {
  double q[whole_dof];
  int branch, continuum;
} Solution;
typedef struct Solutions {
  int status, count;
  Effort effort;
  Solution rows[capacity];
} Solutions;
typedef struct Turns {
  double values[bounded], step, least, most, middle, farthest, nearest, away[2];
  int pivot, end, block_end, is_open, is_over[2], has_one;
} Turns;
typedef struct Representatives {
  Solution row;
  const Solutions* solutions;
  double lower[whole_dof], upper[whole_dof], own[whole_dof];
  int below[whole_dof], above[whole_dof], number[whole_dof];
  Turns turns[bounded];
  int levels[bounded], level_count, place, has_one[capacity];
  int next_row;
} Representatives;
typedef Solution Row;
typedef Solutions MotorRows;
typedef Solutions Rows;
typedef struct Values {
  double of[bounded];
} Values;
static const int motor_of[bounded] = {0, 1, 2, 3, 4, 5, -1};
static const double own_lower[bounded] = {-1, -1, -1, -1, -1, -1, -1};
static const double own_upper[bounded] = {1, 1, 1, 1, 1, 1, 1};
static const int turn_pivot[7] = {0, 1, 2, 3, 4, 5, 7};
static const bool turn_ends_block[7] = {true, true, true, true, true, true, true};
static const double turn_motion[43] = {0};
static Values values_of(const double* of) {
  Values values;
  for (int i = 0; i < bounded; ++i) values.of[i] = i < dof ? of[i] : 0;
  return values;
}
static void motors_by(const double* of, double* motors) {
  for (int i = 0; i < dof; ++i) motors[i] = of[i];
}
)";
  std::vector<File> files{{"sizes", "inverse", false, sizes}};
  files.push_back({"blocks", "inverse", false, emit::c::in_double_precision(emit::c::inverse_blocks())});
  const Unit unit = parse("arm", files);
  EXPECT_GT(unit.functions.size(), 200U);
  EXPECT_NO_THROW((void)emit::rust::crate(unit, std::nullopt, {}));
}

/// Calls keep functions, names keep constants, types and enumerators; members and comments keep nothing.
TEST(Blocks, OnlyWhatPublicFunctionsReachIsLeft) {
  const std::string head = "/// Needed.\ntypedef struct Pair {\n  double a, spare;  // b\n} Pair;\n";
  const std::string called = "static double sum(const Pair* p) {\n  return p->a + size * of[one];\n}\n";
  const std::string kept = "int answer(const Pair* p) {\n  return (int)sum(p);  // not spare(p)\n}\n";
  const std::string names = "enum { size = 3, other };\n";
  const std::string constant = "static const double of[2] = {\n    1, 2};\n";
  const std::string number = "typedef enum Which { one, two } Which;\n";
  const std::string open = "const double open = 1;\n";
  EXPECT_EQ(
      emit::blocks::reached(names + "\n" + head + "\n// Goes.\nstatic int spare(void) { return 1; }\n" +
                            "static const double b = 2;\n" + constant + number + "typedef int Unused;\n" +
                            "// Nothing follows.\n\n" + called + kept + open),
      names + "\n" + head + "\n" + constant + "\n" + number + "\n" + called + "\n" + kept + "\n" + open);
  EXPECT_EQ(emit::blocks::reached("static int a(void) { return 1; }\n"), "");
  for (const char* wrong : {"int a = 'b';\n", "static int a(void) {\n", "{ int a; }\n", "int a\n"})
    EXPECT_THROW(emit::blocks::reached(wrong), NotInSubset) << wrong;
}

TEST(Blocks, AFunctionTakesWhatItNeedsOfASource) {
  const std::string one = "static int one(void) { return 1; }\n",
                    two = "static int two(void) { return 2; }\n";
  const std::string source = one + "int all(void) { return two(); }\n" + two;
  const std::string function = "int some(void) { return one(); }\n";
  EXPECT_EQ(emit::blocks::reached_by(function, source), one + "\n" + function);
}

}  // namespace
}  // namespace qvgen::test
