// SPDX-License-Identifier: MIT
#include "description/physics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "model/evaluate.h"

namespace qvgen::description {
namespace {

using cln::cl_R;
using Matrix = std::array<std::array<cl_R, 3>, 3>;

struct Body {
  cl_R mass = 0;
  std::array<cl_R, 6> inertia;  // xx, yy, zz, xy, yz, xz
};

std::optional<Body> evaluated(const model::Inertia& inertia, const model::Bindings& bindings) {
  try {
    Body body;
    body.mass = model::evaluate(inertia.mass, bindings);
    for (std::size_t i = 0; i < 6; ++i) body.inertia.at(i) = model::evaluate(inertia.inertia.at(i), bindings);
    return body;
  } catch (const model::EvaluationError&) {
    return std::nullopt;
  }
}

Matrix tensor(const std::array<cl_R, 6>& i) {
  return {{{i[0], i[3], i[5]}, {i[3], i[1], i[4]}, {i[5], i[4], i[2]}}};
}

/// Integral of r r^T over the body: tr(I)/2 - I. That it is positive semidefinite is the triangle inequality
/// of the principal moments, whatever the axes.
Matrix second_moments(const std::array<cl_R, 6>& i) {
  const cl_R half_trace = (i[0] + i[1] + i[2]) / 2;
  return tensor({half_trace - i[0], half_trace - i[1], half_trace - i[2], -i[3], -i[4], -i[5]});
}

cl_R minor(const Matrix& m, std::size_t i, std::size_t j) {
  return m.at(i).at(i) * m.at(j).at(j) - cln::square(m.at(i).at(j));
}

cl_R determinant(const Matrix& m) {
  return m[0][0] * minor(m, 1, 2) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

bool is_positive(const cl_R& value) { return !model::vanishes(value) && cln::plusp(value); }
bool is_negative(const cl_R& value) { return !model::vanishes(value) && cln::minusp(value); }

bool is_positive_definite(const Matrix& m) {
  return is_positive(m[0][0]) && is_positive(minor(m, 0, 1)) && is_positive(determinant(m));
}

bool is_positive_semidefinite(const Matrix& m) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_negative(m.at(i).at(i)) || is_negative(minor(m, i, (i + 1) % 3))) return false;
  }
  return !is_negative(determinant(m));
}

std::string text(const cl_R& value) {
  std::ostringstream stream;
  stream << model::to_double(value);
  return stream.str();
}

bool is_diagonal(const Body& body) {
  return model::vanishes(body.inertia[3]) && model::vanishes(body.inertia[4]) &&
         model::vanishes(body.inertia[5]);
}

/// The broken inequality with its numbers where the tensor is diagonal.
std::string triangle_reason(const Body& body) {
  static constexpr std::array names{"xx", "yy", "zz"};
  for (std::size_t i = 0; is_diagonal(body) && i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const cl_R& left = body.inertia.at(i);
    const cl_R sum = body.inertia.at(j) + body.inertia.at(k);
    if (left > sum) {
      return std::string(names.at(i)) + " = " + text(left) + " exceeds " + names.at(j) + " + " + names.at(k) +
             " = " + text(sum);
    }
  }
  return "a principal moment exceeds the sum of the other two";
}

void check_body(Context& context, Place place, const std::string& link, const Body& body) {
  if (is_negative(body.mass)) {
    context.warning(place, link + " has the negative mass " + text(body.mass), "masses are positive");
  }
  const Matrix inertia = tensor(body.inertia);
  bool is_zero = true;
  for (const cl_R& entry : body.inertia) is_zero = is_zero && model::vanishes(entry);
  if (is_zero) return;
  if (model::vanishes(body.mass)) {
    context.warning(place, link + " has inertia but no mass", "give its mass");
  }
  if (!is_positive_definite(inertia)) {
    context.warning(place, "the inertia of " + link + " is not positive definite",
                    "principal moments are positive, the order is [xx, yy, zz, xy, yz, xz]");
  }
  if (!is_positive_semidefinite(second_moments(body.inertia))) {
    context.warning(place,
                    "the inertia of " + link + " breaks the triangle inequality: " + triangle_reason(body),
                    "give it about the centre of mass, each principal moment at most the sum of the others");
  }
}

/// The longest entry of what a joint carries along or stands behind, m; those without a value do not count.
double longest_offset(const model::Joint& joint, const model::Bindings& bindings) {
  double longest = 0;
  for (const model::Vector3* offset : {&joint.before.translation, &joint.after.translation}) {
    for (const model::Expression& entry : *offset) {
      try {
        longest = std::max(longest, std::abs(model::to_double(model::evaluate(entry, bindings))));
      } catch (const model::EvaluationError&) {
        continue;
      }
    }
  }
  return longest;
}

}  // namespace

void check_size(Context& context, const model::Robot& robot) {
  constexpr double suspicious = 100;
  const model::Bindings bindings = model::default_bindings(robot);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const double longest = longest_offset(robot.joints[i], bindings);
    if (longest < suspicious) continue;
    const std::string metres = text(longest);
    return context.warning(context.joint_places.at(i), "an offset of " + metres + " metres",
                           "lengths are in metres; if " + metres + " mm are meant, write " +
                               (context.takes_units ? "unit = \"mm\" for the whole file"
                                                    : text(longest / 1000) + ", and all other lengths so"));
  }
}

void check_inertia(Context& context, const model::Robot& robot) {
  const model::Bindings bindings = model::default_bindings(robot);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (const auto body = evaluated(robot.joints[i].inertia, bindings)) {
      check_body(context, context.joint_places.at(i), "link " + std::to_string(i + 1), *body);
    }
  }
  if (!robot.floating_base) return;
  if (const auto body = evaluated(*robot.floating_base, bindings))
    check_body(context, context.base_place, "the floating base", *body);
}

}  // namespace qvgen::description
