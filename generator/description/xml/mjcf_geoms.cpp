// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_geoms.h"

#include <algorithm>

#include "description/tree/principal.h"
#include "description/xml/decimals.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

using cln::cl_R;
using cln::cl_RA;
using tree::Body;
using tree::Vector;

/// Masses and volumes below are nothing to MuJoCo.
cl_RA nothing() { return cln::expt(cl_RA(10), cln::cl_I(-14)); }

cl_R precise(const cl_R& value) { return cln::cl_float(value, cln::float_format(model::evaluation_digits)); }

std::string geom_type(const Element& geom) { return text_of(geom, "type", "sphere"); }
bool is_shell(const Element& geom) { return text_of(geom, "shellinertia", "false") == "true"; }

/// Half the sides of the box that has these moments for a mass of 1, each along its principal axis.
Vector box_of(const Vector& moments) {
  const cl_R sum = moments[0] + moments[1] + moments[2];
  Vector half;
  for (std::size_t i = 0; i < 3; ++i)
    half.at(i) = cln::sqrt(cln::max(cl_R(0), (sum - 2 * moments.at(i)) * 3 / 2));
  return half;
}

/// The size of a geom that MuJoCo fits to a mesh with such a box.
Vector fitted_size(const std::string& type, const Vector& box) {
  if (type == "sphere") return {(box[0] + box[1] + box[2]) / 3, 0, 0};
  const cl_R radius = (box[0] + box[1]) / 2;
  if (type == "cylinder") return {radius, box[2], 0};
  if (type == "capsule") return {radius, cln::max(cl_R(0), box[2] - radius / 2), 0};
  return box;
}

/// Largest moment first, as MuJoCo has them: a capsule lies along the axis of the least.
void sort(tree::Principal& principal) {
  for (const auto& [a, b] : {std::pair(0U, 1U), std::pair(1U, 2U), std::pair(0U, 1U)}) {
    if (principal.moments.at(a) >= principal.moments.at(b)) continue;
    std::swap(principal.moments.at(a), principal.moments.at(b));
    for (Vector& row : principal.axes) std::swap(row.at(a), row.at(b));
  }
}

/// Moments `side` across a direction and `along` about it; the direction's square is its length's.
tree::Matrix about(const Vector& direction, const cl_R& squared, const cl_R& side, const cl_R& along) {
  tree::Matrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result.at(i).at(j) =
          (i == j ? side : cl_R(0)) + (along - side) * direction.at(i) * direction.at(j) / squared;
  return result;
}

}  // namespace

MjcfGeoms::Shape MjcfGeoms::shape_of(const Solid& solid) {
  Shape shape{solid.volume, {}};
  shape.body.mass = 1;
  for (std::size_t i = 0; i < 3; ++i) shape.body.inertia.at(i).at(i) = solid.moments.at(i);
  return shape;
}

std::optional<Body> MjcfGeoms::body(const Placed& placed, bool& known) {
  const Element geom = placed.completed(*context_);
  const MjcfInertiaSettings& settings = placed.model->settings.inertia;
  const cl_RA group = read_decimal(*context_, geom, "group", 0).value;
  if (group < settings.first_group || group > settings.last_group) return std::nullopt;
  const bool weighed = geom.attribute("mass") != nullptr;
  const cl_RA factor = read_decimal(*context_, geom, weighed ? "mass" : "density", 1000).value;
  if (cln::zerop(factor)) return std::nullopt;
  const auto one = shape(placed, geom, known);
  if (!one || (weighed && one->volume <= nothing())) return std::nullopt;
  const cl_R mass = weighed ? cl_R(factor) : factor * one->volume;
  if (mass <= nothing()) return std::nullopt;
  return scaled(one->body, mass);
}

std::optional<MjcfGeoms::Shape> MjcfGeoms::shape(const Placed& placed, const Element& geom, bool& known) {
  const std::string type = geom_type(geom);
  const bool between = geom.attribute("fromto") != nullptr;
  std::optional<Shape> shape;
  if (geom.attribute("mesh") != nullptr) {
    shape = mesh(*placed.model, geom, known);
  } else if (type == "plane" || type == "hfield") {
    return std::nullopt;
  } else if (sizes_of(type) == 0 || geom.attribute("size") == nullptr) {
    known = false;
    context_->warning(
        geom.place, sizes_of(type) == 0 ? "a geom of type " + type + " is not read" : "a geom without 'size'",
        "give the body an <inertial>");
  } else if (between) {
    shape = between_points(geom);
  } else if (const auto numbers = size(geom, sizes_of(type))) {
    shape = shape_of(solid(type, *numbers, is_shell(geom)).value());
  }
  if (shape)
    shape->body = moved(between ? frames_.around(placed.around) : frames_.frame(placed), shape->body);
  return shape;
}

std::optional<Vector> MjcfGeoms::size(const Element& geom, std::size_t count) const {
  const Attribute& size = *geom.attribute("size");
  const auto numbers = read_decimals(*context_, size);
  if (!numbers) return std::nullopt;
  Vector result{0, 0, 0};
  std::size_t positive = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, numbers->size()); ++i) {
    result.at(i) = (*numbers)[i].value;
    if (i == positive && cln::plusp(result.at(i))) ++positive;
  }
  if (positive >= count) return result;
  context_->error(size.place,
                  "the size of a geom of type " + geom_type(geom) + " has fewer than " +
                      std::to_string(count) + (count == 1 ? " positive number" : " positive numbers"),
                  "write as many");
  return std::nullopt;
}

/// Each of them looks the same from all sides of the line.
std::optional<MjcfGeoms::Shape> MjcfGeoms::between_points(const Element& geom) const {
  const auto ends = read_decimals(*context_, geom, "fromto", 6);
  const auto across = size(geom, 1);
  if (!ends || !across) return std::nullopt;
  Vector direction, middle;
  cl_R squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    direction.at(i) = (*ends)[i].value - (*ends)[i + 3].value;
    middle.at(i) = ((*ends)[i].value + (*ends)[i + 3].value) / 2;
    squared = squared + cln::square(direction.at(i));
  }
  const std::string type = geom_type(geom);
  if (cln::zerop(squared) || sizes_of(type) < 2) {
    context_->error(geom.attribute("fromto")->place,
                    "'fromto' of a geom of type " + type + ", or of length zero",
                    "give two points, and the type capsule, cylinder, box or ellipsoid");
    return std::nullopt;
  }
  const cl_R half = cln::sqrt(precise(squared)) / 2, radius = (*across)[0];
  const Vector sizes = sizes_of(type) == 2 ? Vector{radius, half, 0} : Vector{radius, radius, half};
  const Solid found = solid(type, sizes, is_shell(geom)).value();
  Shape shape = shape_of(found);
  shape.body.centre = middle;
  shape.body.inertia = about(direction, squared, found.moments[0], found.moments[2]);
  return shape;
}

std::optional<MjcfGeoms::Shape> MjcfGeoms::mesh(const MjcfModel& model, const Element& geom, bool& known) {
  const Attribute& name = *geom.attribute("mesh");
  const MjcfMeshes::Result& result = meshes_.of(model, name.value);
  const std::string type = geom_type(geom);
  const bool is_mesh = type == "mesh";
  if (!result.problem.empty() || (!is_mesh && sizes_of(type) == 0)) {
    known = false;
    context_->warning(
        name.place,
        "the mesh '" + name.value + "' has no volume here: " +
            (result.problem.empty() ? "geoms of type " + type + " are not read" : result.problem),
        "give the body an <inertial>");
    return std::nullopt;
  }
  const MeshIntegrals& integrals = result.integrals;
  Shape shape{precise(integrals.volume), {}};
  for (std::size_t i = 0; i < 3; ++i) {
    shape.body.centre.at(i) = precise(integrals.centre.at(i));
    for (std::size_t j = 0; j < 3; ++j)
      shape.body.inertia.at(i).at(j) = precise(integrals.inertia.at(i).at(j)) / shape.volume;
  }
  shape.body.mass = 1;
  return is_mesh ? shape : fitted(shape, geom);
}

std::optional<MjcfGeoms::Shape> MjcfGeoms::fitted(const Shape& mesh, const Element& geom) const {
  tree::Principal principal = tree::principal(mesh.body.inertia);
  sort(principal);
  const cl_R scale = read_decimal(*context_, geom, "fitscale", 1).value;
  Vector size = fitted_size(geom_type(geom), box_of(principal.moments));
  for (cl_R& entry : size) entry = entry * scale;
  const auto found = solid(geom_type(geom), size, is_shell(geom));
  if (!found) return std::nullopt;
  Shape shape = mesh;
  shape.volume = found->volume;
  principal.moments = found->moments;
  shape.body.inertia = tree::tensor(principal);
  return shape;
}

}  // namespace qvgen::description::xml
