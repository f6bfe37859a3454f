// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_inertia.h"

#include <algorithm>

#include "description/tree/principal.h"
#include "description/xml/decimals.h"
#include "description/xml/mjcf_numbers.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

using cln::cl_R;
using tree::Body;
using tree::Vector;

bool breaks_triangle(const Vector& m) {
  const cl_R sum = m[0] + m[1] + m[2];
  return std::any_of(m.begin(), m.end(), [&](const cl_R& moment) {
    const cl_R rest = sum - 2 * moment;
    return cln::minusp(rest) && !model::vanishes(rest / sum);
  });
}

Body bounded(Body body, const MjcfInertiaSettings& settings) {
  body.mass = cln::max(body.mass, settings.least_mass);
  if (!settings.balanced && !cln::plusp(settings.least_moment)) return body;
  tree::Principal principal = tree::principal(body.inertia);
  Vector& moments = principal.moments;
  const Vector before = moments;
  for (cl_R& moment : moments) moment = cln::max(moment, settings.least_moment);
  if (settings.balanced && breaks_triangle(moments)) {
    const cl_R mean = (moments[0] + moments[1] + moments[2]) / 3;
    moments = {mean, mean, mean};
  }
  const bool same = std::equal(moments.begin(), moments.end(), before.begin(),
                               [](const cl_R& a, const cl_R& b) { return a == b; });
  if (!same) body.inertia = tree::tensor(principal);
  return body;
}

}  // namespace

Body MjcfInertia::given(const Placed& inertial) const {
  const Element& element = *inertial.element;
  Body result;
  result.mass = read_decimal(*context_, element, "mass", 0).value;
  if (const auto d = read_decimals(*context_, element, "diaginertia", 3))
    result.inertia = {Vector{(*d)[0].value, 0, 0}, Vector{0, (*d)[1].value, 0}, Vector{0, 0, (*d)[2].value}};
  if (const auto f = read_decimals(*context_, element, "fullinertia", 6))
    result.inertia = {Vector{(*f)[0].value, (*f)[3].value, (*f)[4].value},
                      Vector{(*f)[3].value, (*f)[1].value, (*f)[5].value},
                      Vector{(*f)[4].value, (*f)[5].value, (*f)[2].value}};
  return moved(MjcfNumbers(*context_, inertial.model->settings).frame(element),
               bounded(result, inertial.model->settings.inertia));
}

/// Bounds give it a mass nevertheless, and MuJoCo puts that where the body is in its parent.
Body MjcfInertia::none(const Placed& body) const {
  Body none;
  if (cln::plusp(body.model->settings.inertia.least_mass))
    for (std::size_t i = 0; i < 3; ++i)
      none.centre.at(i) = model::evaluate(
          MjcfNumbers(*context_, body.model->settings).frame(*body.element).translation.at(i));
  return bounded(none, body.model->settings.inertia);
}

Body MjcfInertia::of(const Placed& body, const std::vector<Placed>& contents) {
  const auto inertial = std::find_if(contents.begin(), contents.end(),
                                     [](const Placed& placed) { return placed.element->name == "inertial"; });
  const MjcfInertiaSettings& settings = body.model->settings.inertia;
  const bool is_given = inertial != contents.end();
  const bool counts = settings.from_geoms == MjcfInertiaSettings::always ||
                      (settings.from_geoms == MjcfInertiaSettings::where_none_is_given && !is_given);
  const auto sum = counts ? from_geoms(body, contents) : std::nullopt;
  if (sum) return bounded(*sum, settings);
  return is_given ? given(*inertial) : none(body);
}

std::optional<Body> MjcfInertia::from_geoms(const Placed& body, const std::vector<Placed>& contents) {
  std::optional<Body> sum;
  bool known = true;
  for (const Placed& placed : contents) {
    if (placed.element->name != "geom") continue;
    if (const auto one = geoms_.body(placed, known)) sum = sum ? joined(*sum, *one) : *one;
  }
  if (known) return sum;
  const std::string name = body.name().empty() ? "a body" : "the body '" + body.name() + "'";
  context_->warning(body.element->place, name + " is read without inertia: that of a geom is not known",
                    "give it an <inertial>");
  return Body{};
}

}  // namespace qvgen::description::xml
