// SPDX-License-Identifier: MIT
#include "description/xml/solids.h"

#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

using cln::cl_R;
using cln::cl_RA;
using cln::square;
using tree::Vector;

cl_R pi() { return model::evaluate(model::Expression::pi()); }

/// Moments of a box of unit mass from the squares of half its sides, of an ellipsoid from those of its half
/// axes.
Vector across(const Vector& squares, const cl_RA& share) {
  return {share * (squares[1] + squares[2]), share * (squares[0] + squares[2]),
          share * (squares[0] + squares[1])};
}
Vector squares(const Vector& v) { return {square(v[0]), square(v[1]), square(v[2])}; }

Solid sphere(const cl_R& r, bool shell) {
  const cl_R moment = shell ? 2 * square(r) / 3 : 2 * square(r) / 5;
  return {shell ? 4 * pi() * square(r) : 4 * pi() * r * r * r / 3, {moment, moment, moment}};
}

/// Shares of the cylinder and of both caps together; h is the whole length of the cylinder.
Solid capsule(const cl_R& r, const cl_R& h, bool shell) {
  const cl_R caps = shell ? 2 * r / (2 * r + h) : 4 * r / (4 * r + 3 * h);
  const cl_R rest = 1 - caps;
  const cl_R ball = (shell ? cl_RA(2) / 3 : cl_RA(2) / 5) * square(r);
  // From the centre of a whole ball to those of its halves, moved apart by h.
  const cl_R middle = shell ? r / 2 : 3 * r / 8;
  const cl_R apart = square(h / 2 + middle) - square(middle);
  const cl_R across = rest * ((shell ? 6 : 3) * square(r) + square(h)) / 12 + caps * (ball + apart);
  const cl_R along = rest * square(r) / (shell ? 1 : 2) + caps * ball;
  const cl_R volume = shell ? pi() * (4 * square(r) + 2 * r * h) : pi() * square(r) * (h + 4 * r / 3);
  return {volume, {across, across, along}};
}

Solid cylinder(const cl_R& r, const cl_R& h, bool shell) {
  if (!shell) {
    const cl_R across = (3 * square(r) + square(h)) / 12;
    return {pi() * square(r) * h, {across, across, square(r) / 2}};
  }
  const cl_R disk = r / (2 * r + 2 * h);  // share of each of both
  const cl_R rest = 1 - 2 * disk;
  const cl_R across = rest * (6 * square(r) + square(h)) / 12 + 2 * disk * (square(r) + square(h)) / 4;
  return {2 * pi() * r * (r + h), {across, across, rest * square(r) + disk * square(r)}};
}

/// Half sides a, b, c: each pair of faces has the share of its area.
Solid box(const Vector& size, bool shell) {
  const Vector s = squares(size);
  if (!shell) return {8 * size[0] * size[1] * size[2], across(s, cl_RA(1) / 3)};
  const Vector area{size[1] * size[2], size[0] * size[2], size[0] * size[1]};
  const cl_R sum = area[0] + area[1] + area[2];
  Vector second;  // mean of the squared coordinates
  for (std::size_t i = 0; i < 3; ++i)
    second.at(i) = s.at(i) * (area.at(i) / sum + (1 - area.at(i) / sum) / 3);
  return {8 * sum, across(second, 1)};
}

/// Thomsen's approximation of the surface; the shell between the ellipsoid and one that is larger by 1e-6.
Solid ellipsoid_shell(const Vector& size) {
  const auto format = cln::float_format(model::evaluation_digits);
  const cl_R power = cln::cl_float(cl_RA(16075) / 10000, format);
  const auto raised = [&](const cl_R& x) { return cln::exp(power * cln::ln(cln::cl_float(x, format))); };
  const cl_R mean = (raised(size[0] * size[1]) + raised(size[1] * size[2]) + raised(size[2] * size[0])) / 3;
  const cl_RA more = cl_RA(1) / 1'000'000;
  const Vector outer{size[0] + more, size[1] + more, size[2] + more};
  const cl_R inside = size[0] * size[1] * size[2], all = outer[0] * outer[1] * outer[2];
  const Vector a = across(squares(size), cl_RA(1) / 5), b = across(squares(outer), cl_RA(1) / 5);
  Vector moments;
  for (std::size_t i = 0; i < 3; ++i) moments.at(i) = (all * b.at(i) - inside * a.at(i)) / (all - inside);
  return {4 * pi() * cln::exp(cln::ln(mean) / power), moments};
}

Solid ellipsoid(const Vector& size, bool shell) {
  if (shell) return ellipsoid_shell(size);
  return {4 * pi() * size[0] * size[1] * size[2] / 3, across(squares(size), cl_RA(1) / 5)};
}

}  // namespace

std::size_t sizes_of(const std::string& type) {
  if (type == "sphere") return 1;
  if (type == "capsule" || type == "cylinder") return 2;
  return type == "box" || type == "ellipsoid" ? 3 : 0;
}

std::optional<Solid> solid(const std::string& type, const Vector& size, bool shell) {
  if (type == "sphere") return sphere(size[0], shell);
  if (type == "capsule") return capsule(size[0], 2 * size[1], shell);
  if (type == "cylinder") return cylinder(size[0], 2 * size[1], shell);
  if (type == "box") return box(size, shell);
  if (type == "ellipsoid") return ellipsoid(size, shell);
  return std::nullopt;
}

}  // namespace qvgen::description::xml
