// SPDX-License-Identifier: MIT
#include "passes/search/fingerprint.h"

#include <vector>

#include <gtest/gtest.h>

#include "passes/search/random.h"

namespace qvgen::passes::search_detail {
namespace {

dag::Angle angle(long numerator, long denominator, long pi_numerator = 0, long pi_denominator = 1) {
  dag::Angle result;
  if (numerator != 0) result.terms["theta"] = cln::cl_RA(numerator) / denominator;
  result.pi = cln::cl_RA(pi_numerator) / pi_denominator;
  return result;
}

exact::Number root(long radicand) { return exact::Number::root(radicand); }

TEST(Field, InverseAndNegativeAreWhatTheyAreCalled) {
  const Field a = Field::from(123456789);
  EXPECT_EQ(a * a.inverse(), Field::from(1));
  EXPECT_EQ(a + -a, Field());
  EXPECT_EQ(Field::from(7) * Field::from(6), Field::from(42));
  EXPECT_EQ(Field::from(7) - Field::from(9), -Field::from(2));
}

TEST(Field, RootOfUnityHasTheFullOrder) {
  const Field w = Field::root_of_unity();
  EXPECT_EQ(w.power(Field::order), Field::from(1));
  for (const std::uint64_t prime : {2U, 3U, 5U, 7U, 11U, 13U, 17U, 19U, 23U, 29U, 31U, 37U})
    EXPECT_NE(w.power(Field::order / prime), Field::from(1)) << prime;
}

/// Every integer has a root, and so has every second of the other elements.
TEST(Field, SquareRootsSquareToTheirElements) {
  Random random(7);
  const auto integer = [&] { return Field::from(random.next()); };
  int without = 0;
  for (int i = 0; i < 200; ++i) {
    const Field a = integer(), root = *a.square_root();
    EXPECT_EQ(root * root, a);
    const Field beside = integer() + integer() * *Field::from(82).square_root(), square = beside * beside;
    EXPECT_TRUE(square.square_root() == beside || square.square_root() == -beside) << i;
    if (const auto of_any = beside.square_root())
      EXPECT_EQ(*of_any * *of_any, beside) << i;
    else
      ++without;
  }
  EXPECT_GT(without, 60);
  EXPECT_LT(without, 140);
  EXPECT_EQ(Field().square_root(), Field());
}

TEST(Fingerprint, KeepsTheLawsOfSineAndCosine) {
  const Fingerprint point(5);
  const CosineSine half = point.circular(angle(1, 2));
  const CosineSine full = point.circular(angle(1, 1));
  EXPECT_EQ(half.cosine * half.cosine + half.sine * half.sine, Field::from(1));
  EXPECT_EQ(half.cosine * half.cosine - half.sine * half.sine, full.cosine);
  EXPECT_EQ(half.cosine * half.sine + half.cosine * half.sine, full.sine);
  const CosineSine turned = point.circular(angle(1, 1, 1, 2));
  EXPECT_EQ(turned.cosine, -full.sine);
  EXPECT_EQ(turned.sine, full.cosine);
}

TEST(Fingerprint, KeepsAngleSumsOfSeveralSymbols) {
  const Fingerprint point(5);
  dag::Angle other;
  other.terms["phi"] = cln::cl_RA(1) / 2;
  const CosineSine a = point.circular(angle(1, 2));
  const CosineSine b = point.circular(other);
  const CosineSine sum = point.circular(angle(1, 2) + other);
  EXPECT_EQ(sum.cosine, a.cosine * b.cosine - a.sine * b.sine);
  EXPECT_EQ(sum.sine, a.sine * b.cosine + a.cosine * b.sine);
}

/// The square roots have to be those that the roots of unity imply, sign included.
TEST(Fingerprint, AgreesWithTheSquareRootsOfKnownAngles) {
  Fingerprint point(5);
  const exact::Number half = exact::Number(1) / exact::Number(2);
  EXPECT_EQ(point.circular(angle(0, 1, 1, 4)).cosine, point.number(root(2) * half));
  EXPECT_EQ(point.circular(angle(0, 1, 1, 6)).cosine, point.number(root(3) * half));
  EXPECT_EQ(point.circular(angle(0, 1, 1, 6)).sine, point.number(half));
  EXPECT_EQ(point.circular(angle(0, 1, 1, 5)).cosine,
            point.number((exact::Number(1) + root(5)) * half * half));
  EXPECT_EQ(point.circular(angle(0, 1, 1, 12)).cosine, point.number((root(6) + root(2)) * half * half));
}

/// Roots of any integers multiply as exact numbers do: primes that the field's roots of unity know, any
/// others, squares in the prime field (43, 53) or not (41, 65537), and products of long primes.
TEST(Fingerprint, SquareRootsMultiplyAsTheyShould) {
  Fingerprint point(5);
  const std::vector<long> radicands{2,
                                    3,
                                    5,
                                    7,
                                    11,
                                    13,
                                    17,
                                    19,
                                    23,
                                    29,
                                    31,
                                    37,
                                    41,
                                    43,
                                    53,
                                    901,
                                    2 * 3 * 41,
                                    65537,
                                    65537L * 65539L,
                                    65539L * 1048583L};
  for (const long a : radicands)
    for (const long b : radicands)
      EXPECT_EQ(point.number(root(a)) * point.number(root(b)), point.number(root(a) * root(b)))
          << a << " " << b;
}

TEST(Fingerprint, RandomNumbersOfManyRootsKeepTheirLaws) {
  Random random(3);
  Fingerprint point(5);
  const auto any = [&] {
    exact::Number sum(static_cast<long>(random.below(100)));
    for (int i = 0; i < 2; ++i) sum = sum + root(2 + random.below(100'000)) * exact::Number(3);
    return sum;
  };
  for (int i = 0; i < 100; ++i) {
    const exact::Number a = any(), b = any();
    EXPECT_EQ(point.number(a) * point.number(b), point.number(a * b));
    EXPECT_EQ(point.number(a).inverse(), point.number(a.inverse()));
    EXPECT_EQ(point.number(a) - point.number(b), point.number(a - b));
  }
}

TEST(Fingerprint, SeparatesSymbolsSeedsAndOpaqueOperations) {
  const Fingerprint point(5);
  EXPECT_NE(point.symbol("a"), point.symbol("b"));
  EXPECT_NE(point.symbol("a"), Fingerprint(6).symbol("a"));
  const Field a = point.symbol("a");
  EXPECT_EQ(point.opaque("root", a, a), point.opaque("root", a, a));
  EXPECT_NE(point.opaque("root", a, a), point.opaque("arctangent", a, a));
  EXPECT_NE(point.opaque("root", a, a), point.opaque("root", -a, -a));
}

}  // namespace
}  // namespace qvgen::passes::search_detail
