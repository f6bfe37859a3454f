// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <map>
#include <random>
#include <sstream>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "description/xml/mesh.h"
#include "folder.h"
#include "mjcf_body.h"
#include "model/evaluate.h"
#include "xml.h"

// Inertia of bodies from meshes: of boxes, whose integrals are known, and of convex hulls.
namespace qvgen::description {
namespace {

using xml::convex_hull;
using xml::Mesh;
using xml::Point;

std::string decimal(double value) {
  std::ostringstream text;
  text << std::setprecision(17) << value;
  return text.str();
}

/// A box from the origin, its sides in 64ths; corners by their bits, each face two triangles seen from
/// outside.
struct Box {
  std::array<int, 3> sides;
  static constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  [[nodiscard]] double entry(int corner, std::size_t i) const {
    return ((corner >> i) & 1) == 0 ? 0 : sides.at(i) / 64.0;
  }
  [[nodiscard]] std::string text(int corner) const {
    std::string all;
    for (std::size_t i = 0; i < 3; ++i) all += " " + decimal(entry(corner, i));
    return all;
  }
  [[nodiscard]] std::vector<std::array<int, 3>> triangles() const {
    std::vector<std::array<int, 3>> all;
    for (const auto& f : faces) {
      all.push_back({f[0], f[1], f[2]});
      all.push_back({f[0], f[2], f[3]});
    }
    return all;
  }
};

template <typename Number>
void append(std::string& text, Number number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  text.append(bytes, sizeof number);
}

std::string obj(const Box& box) {
  std::string text = "# a box\no box\n";
  for (int corner = 0; corner < 8; ++corner) text += "v" + box.text(corner) + "\n";
  for (const auto& f : Box::faces) {
    text += "f";
    for (const int corner : f)  // in every way of writing a corner
      text += " " + (corner % 2 == 0 ? std::to_string(corner - 8) : std::to_string(corner + 1) + "/1/1");
    text += "\n";
  }
  return text;
}

std::string ascii_stl(const Box& box) {
  std::string text = "solid box\n";
  for (const auto& t : box.triangles()) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : t) text += "vertex" + box.text(corner) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

std::string binary_stl(const Box& box) {
  std::string text = "solid, it says, but binary it is";
  text.resize(80, ' ');
  append(text, std::uint32_t{12});
  for (const auto& t : box.triangles()) {
    for (int i = 0; i < 3; ++i) append(text, 0.0F);
    for (const int corner : t)
      for (std::size_t i = 0; i < 3; ++i) append(text, static_cast<float>(box.entry(corner, i)));
    append(text, std::uint16_t{0});
  }
  return text;
}

std::string msh(const Box& box) {
  std::string text;
  for (const std::uint32_t count : {8U, 0U, 0U, 12U}) append(text, count);
  for (int corner = 0; corner < 8; ++corner)
    for (std::size_t i = 0; i < 3; ++i) append(text, static_cast<float>(box.entry(corner, i)));
  for (const auto& t : box.triangles())
    for (const int corner : t) append(text, static_cast<std::uint32_t>(corner));
  return text;
}

std::string mesh_model(const std::string& file, const std::string& asset = "", const std::string& geom = "") {
  return body("<geom type=\"mesh\" mesh=\"box\" " + geom + "/>",
              "<compiler meshdir=\"meshes\"/><asset><mesh file=\"" + file + "\" " + asset + "/></asset>");
}

std::vector<double> numbers(const model::Robot& arm) {
  const model::Inertia& inertia = arm.joints.at(0).inertia;
  std::vector<double> all{model::to_double(model::evaluate(inertia.mass))};
  for (const auto& entry : inertia.centre_of_mass) all.push_back(model::to_double(model::evaluate(entry)));
  for (const auto& entry : inertia.inertia) all.push_back(model::to_double(model::evaluate(entry)));
  return all;
}

void expect_same(const model::Robot& a, const model::Robot& b) {
  const auto x = numbers(a), y = numbers(b);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(x[i], y[i], 1e-12 * std::max({1.0, y[0], y[4], y[5]})) << i;
}

/// Returns MuJoCo's reading of a geom of the box's size and place.
model::Robot geom_of(const Box& box, const std::string& more = "") {
  const auto half = [&](std::size_t i) { return decimal(box.sides.at(i) / 128.0) + " "; };
  const std::string size = half(0) + half(1) + half(2);
  return read(body("<geom type=\"box\" size=\"" + size + "\" pos=\"" + size + "\"" + more + "/>"));
}

/// Boxes of random sides, a new one at each call.
class Boxes {
 public:
  Box operator()() { return {{side_(engine_), side_(engine_), side_(engine_)}}; }

 private:
  std::mt19937 engine_{1};
  std::uniform_int_distribution<int> side_{1, 150};
};

TEST(MjcfMeshes, MeshesOfBoxesAreBoxes) {
  Boxes boxes;
  for (int i = 0; i < 30 && !HasFailure(); ++i) {
    const Box box = boxes();
    Folder files;
    files.write("meshes/box.obj", obj(box)).write("meshes/box.stl", binary_stl(box));
    files.write("meshes/box.STL", ascii_stl(box)).write("meshes/box.msh", msh(box));
    const model::Robot expected = geom_of(box), hollow = geom_of(box, " shellinertia=\"true\"");
    for (const std::string file : {"box.obj", "box.stl", "box.STL", "box.msh"}) {
      SCOPED_TRACE(file);
      expect_same(files.write("a.xml", mesh_model(file)).robot("a.xml"), expected);
      expect_same(files.write("a.xml", mesh_model(file, "inertia=\"exact\"")).robot("a.xml"), expected);
      expect_same(files.write("a.xml", mesh_model(file, "inertia=\"shell\"")).robot("a.xml"), hollow);
    }
  }
}

/// Random points, on a small lattice every second time, where many lie in one plane.
Mesh random_points(std::mt19937& engine, int i) {
  std::normal_distribution<double> anywhere;
  std::uniform_int_distribution<int> lattice(0, 3), count(5, 40);
  Mesh mesh;
  for (int k = count(engine); k > 0; --k) {
    Point& point = mesh.points.emplace_back();
    for (double& x : point) x = i % 2 == 0 ? anywhere(engine) : lattice(engine);
  }
  return mesh;
}

/// Six times the volume of a triangle's pyramid with that top.
double pyramid(const Mesh& mesh, const std::array<std::size_t, 3>& triangle, const Point& top) {
  Eigen::Matrix3d sides;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t x = 0; x < 3; ++x)
      sides(static_cast<int>(k), static_cast<int>(x)) = mesh.points[triangle.at(k)].at(x) - top.at(x);
  return sides.determinant();
}

/// A closed surface whose triangles have every point behind them, seen from outside, is the hull.
TEST(MjcfMeshes, NoPointIsOutsideOfTheConvexHull) {
  std::mt19937 engine{7};
  int hulls = 0;
  for (int i = 0; i < 400 && !HasFailure(); ++i) {
    const Mesh hull = convex_hull(random_points(engine, i));
    if (!hull.problem.empty()) continue;
    ++hulls;
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (const auto& triangle : hull.triangles) {
      for (const Point& point : hull.points) EXPECT_GT(pyramid(hull, triangle, point), -1e-12) << i;
      for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle.at(k), triangle.at((k + 1) % 3)}];
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1) << i;
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << i;
    }
  }
  EXPECT_GT(hulls, 300);
}

/// An L from above, one unit high, by its corners; counted by its hull, which fills the notch by half.
TEST(MjcfMeshes, MeshesAreCountedByTheirConvexHull) {
  const std::string corners = "0 0 0 2 0 0 2 1 0 1 1 0 1 3 0 0 3 0 0 0 1 2 0 1 2 1 1 1 1 1 1 3 1 0 3 1";
  const std::string faces =
      "0 2 1 0 3 2 0 4 3 0 5 4 6 7 8 6 8 9 6 9 10 6 10 11 0 1 7 0 7 6 1 2 8 1 8 7 2 3 9 2 9 8 "
      "3 4 10 3 10 9 4 5 11 4 11 10 5 0 6 5 6 11";
  const auto model = [&](const std::string& asset) {
    return body("<geom type=\"mesh\" mesh=\"m\"/>", "<asset><mesh name=\"m\" " + asset + "/></asset>");
  };
  const std::string vertex = "vertex=\"" + corners + "\"", face = " face=\"" + faces + "\"";
  // As MuJoCo 4.0.1 counts them.
  const std::vector<double> hull{5000, 13 / 15.0, 4 / 3.0, 0.5}, exact{4000, 0.75, 1.25, 0.5};
  const auto expect = [](const model::Robot& arm, const std::vector<double>& wanted) {
    const std::vector<double> found = numbers(arm);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-12 * wanted[0]) << i;
  };
  expect(read(model(vertex + face + " inertia=\"exact\"")), exact);
  expect(read(model(vertex + face + " inertia=\"convex\"")), hull);
  expect(read(model(vertex)), hull);
  expect(read(model(vertex + " inertia=\"exact\"")), hull);
  const std::string few = report(model(vertex + " maxhullvert=\"6\"")),
                    flat = report(model("vertex=\"0 0 0 1 0 0 0 1 0 1 1 0\""));
  EXPECT_NE(few.find("by a hull of few vertices (maxhullvert)"), std::string::npos) << few;
  EXPECT_NE(flat.find("its points lie in a plane"), std::string::npos) << flat;
}

TEST(MjcfMeshes, MeshesAreMovedTurnedAndScaled) {
  Boxes boxes;
  for (int i = 0; i < 30 && !HasFailure(); ++i) {
    const Box box = boxes(), larger{{2 * box.sides[0], 3 * box.sides[1], box.sides[2]}};
    Folder files;
    files.write("meshes/box.obj", obj(box));
    const std::string mirrored =
        "scale=\"-2 3 1\" inertia=\"exact\" refpos=\"" + decimal(box.sides[0] / 64.0) + " 0 0\"";
    expect_same(files.write("a.xml", mesh_model("box.obj", mirrored)).robot("a.xml"), geom_of(larger));
    // A quarter turn of the reference, and back by the geom.
    expect_same(
        files.write("a.xml", mesh_model("box.obj", "refquat=\"1 0 0 1\"", "quat=\"1 0 0 1\"")).robot("a.xml"),
        geom_of(box));
  }
}

// By default the faces may be turned the wrong way; "exact" takes them as they are.
TEST(MjcfMeshes, FacesTheWrongWayRound) {
  std::string text = obj({{64, 64, 64}});
  const std::size_t last = text.rfind("f ");
  text = text.substr(0, last) + "f -1 -3 -5 -7\n";
  Folder files;
  files.write("meshes/box.obj", text);
  const auto mass = [&](const std::string& asset) {
    return numbers(files.write("a.xml", mesh_model("box.obj", asset)).robot("a.xml"))[0];
  };
  EXPECT_NEAR(mass(""), 1000, 1e-9);
  EXPECT_LT(mass("inertia=\"exact\""), 900);
}

TEST(MjcfMeshes, GeomsAreFittedToMeshes) {
  Folder files;
  files.write("meshes/box.obj", obj({{64, 128, 192}}));
  const auto fitted = [&](const std::string& type) {
    std::string text = mesh_model("box.obj", "", "mass=\"1\"");
    text.replace(text.find("type=\"mesh\""), 11, "type=\"" + type + "\"");
    return numbers(files.write("a.xml", text).robot("a.xml"));
  };
  const auto box = fitted("box");
  EXPECT_NEAR(box[4], 13 / 12.0, 1e-14);  // 4 + 9
  EXPECT_NEAR(box[6], 5 / 12.0, 1e-14);
  EXPECT_NEAR(fitted("sphere")[4], 0.4, 1e-14);                // the mean of half sides is 1
  EXPECT_NEAR(fitted("cylinder")[6], 0.75 * 0.75 / 2, 1e-14);  // along the longest side
  EXPECT_NEAR(fitted("capsule")[2], 1, 1e-14);
}

TEST(MjcfMeshes, FolderOfMeshes) {
  Folder files;
  files.write("a/box.obj", obj({{64, 64, 64}})).write("b/sub/box.obj", obj({{64, 64, 128}}));
  const auto mass = [&](const std::string& compiler, const std::string& file) {
    const std::string text = body("<geom type=\"mesh\" mesh=\"box\"/>",
                                  "<compiler " + compiler + "/><asset><mesh file=\"" + file + "\"/></asset>");
    return numbers(files.write("m.xml", text).robot("m.xml"))[0];
  };
  EXPECT_NEAR(mass("assetdir=\"a\"", "box.obj"), 1000, 1e-9);
  EXPECT_NEAR(mass("meshdir=\"b\" assetdir=\"a\"", "sub/box.obj"), 2000, 1e-9);
  EXPECT_NEAR(mass("meshdir=\"a\" strippath=\"true\"", "x/y/box.obj"), 1000, 1e-9);
  EXPECT_NEAR(mass("", "a/box.obj"), 1000, 1e-9);
}

TEST(MjcfMeshes, BadMeshesLeaveTheBodyWithoutInertia) {
  Folder files;
  const auto with = [&](const std::string& name, const std::string& content) {
    files.write("meshes/box" + name, content);
    const std::string all = files.write("a.xml", mesh_model("box" + name)).report("a.xml");
    const std::size_t at = all.find("has no volume here: "), end = all.find("; give the body", at);
    return at == std::string::npos ? all : all.substr(at + 20, end - at - 20);
  };
  EXPECT_EQ(
      with(".stl", "abc"),
      "@meshes/box.stl: it is no STL file: neither 'solid' nor a count of triangles that fits its size");
  EXPECT_EQ(with(".stl", "solid\nvertex 0 0 x"), "@meshes/box.stl: a vertex is no three numbers");
  EXPECT_EQ(with(".stl", "solid\nendsolid"), "@meshes/box.stl: it has no triangles");
  EXPECT_EQ(with(".stl", binary_stl({{1, 1, 1}}) + "x"),
            "@meshes/box.stl: it has no triangles");  // begins with 'solid', and has no facets
  EXPECT_EQ(with(".obj", "v 0 0 0\nf 1 2 3\n"), "@meshes/box.obj: line 2 is no vertex or face");
  EXPECT_EQ(with(".obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
            "@meshes/box.obj: a corner is at no finite place");
  EXPECT_EQ(with(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "it encloses nothing");
  EXPECT_EQ(with(".msh", "abc"), "@meshes/box.msh: it is no MSH file: it has no counts");
  EXPECT_EQ(with(".msh", std::string(16, '\xff')),
            "@meshes/box.msh: it is no MSH file: its counts do not fit its size");
  EXPECT_EQ(with(".dae", ""), "@meshes/box.dae: only STL, OBJ and MSH files are read");
  files.write("a.xml", mesh_model("none.obj", "name=\"box\""));
  EXPECT_EQ(
      files.report("a.xml"),
      "@a.xml:2:1: warning: the body 'b' is read without inertia: that of a geom is not known; give it an "
      "<inertial>\n"
      "@a.xml:2:48: warning: the mesh 'box' has no volume here: @meshes/none.obj: No such file or directory; "
      "give the body an <inertial>\n");
}

}  // namespace
}  // namespace qvgen::description
