// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_meshes.h"

#include <cmath>

#include "description/xml/decimals.h"
#include "description/xml/orientation.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

std::filesystem::path path_of(const MjcfModel& model, const std::string& file) {
  const std::filesystem::path name = file;
  return model.folder / model.settings.mesh_folder / (model.settings.strip_paths ? name.filename() : name);
}

/// Vertices and faces that stand in the model itself; without faces those of the convex hull are meant.
Mesh written_mesh(Context& context, const Element& mesh) {
  Mesh result;
  const Attribute* vertices = mesh.attribute("vertex");
  const Attribute* faces = mesh.attribute("face");
  if (vertices == nullptr) {
    result.problem = "it names no file";
    return result;
  }
  const auto points = read_decimals(context, *vertices);
  const auto corners = faces == nullptr ? std::nullopt : read_decimals(context, *faces);
  for (std::size_t i = 0; points && i + 2 < points->size(); i += 3) {
    Point& point = result.points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      point.at(k) = static_cast<float>(model::to_double((*points)[i + k].value));
  }
  for (std::size_t i = 0; corners && i + 2 < corners->size(); i += 3) {
    auto& triangle = result.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const double index = model::to_double((*corners)[i + k].value);
      if (!(index >= 0 && index < static_cast<double>(result.points.size()))) {
        result.problem = "there is no vertex " + (*corners)[i + k].text;
        return result;
      }
      triangle.at(k) = static_cast<std::size_t>(index);
    }
  }
  if (faces != nullptr && result.triangles.empty()) result.problem = "it has no triangles";
  return result;
}

/// Moves, turns and scales the points as the asset says.
void place(Context& context, const Element& mesh, std::vector<Point>& points) {
  std::array<Point, 3> rows{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  Point origin{}, scale{1, 1, 1};
  if (const auto pos = read_decimals(context, mesh, "refpos", 3))
    for (std::size_t i = 0; i < 3; ++i) origin.at(i) = model::to_double((*pos)[i].value);
  if (const auto factors = read_decimals(context, mesh, "scale", 3))
    for (std::size_t i = 0; i < 3; ++i) scale.at(i) = model::to_double((*factors)[i].value);
  const auto quat = read_decimals(context, mesh, "refquat", 4);
  bool turned = false;
  for (std::size_t i = 0; quat && i < 4; ++i) turned = turned || !cln::zerop((*quat)[i].value);
  if (turned) {
    const tree::Matrix rotation = matrix_of(*quat);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) rows.at(i).at(j) = model::to_double(rotation.at(j).at(i));
  }
  for (Point& point : points) {
    const Point from{point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& row = rows.at(i);
      point.at(i) = scale.at(i) * (row[0] * from[0] + row[1] * from[1] + row[2] * from[2]);
    }
  }
}

bool mirrors(Context& context, const Element& mesh) {
  const auto scale = read_decimals(context, mesh, "scale", 3);
  return scale && cln::minusp((*scale)[0].value * (*scale)[1].value * (*scale)[2].value);
}

}  // namespace

const MjcfMeshes::Result& MjcfMeshes::of(const MjcfModel& model, const std::string& name) {
  const auto key = std::make_pair(&model, name);
  const auto known = known_.find(key);
  return known != known_.end() ? known->second : known_[key] = read(model, name);
}

Mesh MjcfMeshes::points(const MjcfModel& model, const Element& mesh) const {
  const std::string file = text_of(mesh, "file");
  Mesh result = file.empty() ? written_mesh(*context_, mesh) : read_mesh(path_of(model, file));
  if (!file.empty()) context_->files.push_back(path_of(model, file).string());
  if (!result.problem.empty() && !file.empty())
    result.problem = path_of(model, file).string() + ": " + result.problem;
  place(*context_, mesh, result.points);
  if (mirrors(*context_, mesh))
    for (auto& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  return result;
}

MjcfMeshes::Result MjcfMeshes::read(const MjcfModel& model, const std::string& name) const {
  const auto asset = model.meshes.find(name);
  if (asset == model.meshes.end()) return {{}, "there is no <mesh> of that name in <asset>"};
  const std::string kind = text_of(asset->second, "inertia");
  Mesh mesh = points(model, asset->second);
  const bool is_hull = mesh.problem.empty() && (kind == "convex" || mesh.triangles.empty());
  if (is_hull && asset->second.attribute("maxhullvert") != nullptr)
    return {{}, "it is counted by a hull of few vertices (maxhullvert), which MuJoCo alone chooses"};
  if (is_hull) mesh = convex_hull(mesh);
  if (!mesh.problem.empty()) return {{}, mesh.problem};
  const bool exact = is_hull || kind == "exact" || (kind.empty() && model.settings.inertia.exact_meshes);
  const auto inertia = kind == "shell" ? MeshInertia::shell
                       : exact         ? MeshInertia::exact
                                       : MeshInertia::legacy;
  Result result{integrals(mesh, inertia), ""};
  if (!(result.integrals.volume >= 1e-15)) result.problem = "it encloses nothing";
  return result;
}

}  // namespace qvgen::description::xml
