// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "description/xml/file_text.h"
#include "description/xml/mesh.h"

namespace qvgen::description::xml {
namespace {

// A binary STL: 80 bytes of header, the count, and 50 bytes a triangle: normal, three corners, two bytes
// more.
constexpr std::size_t header = 84;
constexpr std::size_t record = 50;

Mesh refused(const std::string& problem) {
  Mesh mesh;
  mesh.problem = problem;
  return mesh;
}

Mesh checked(Mesh mesh) {
  if (mesh.problem.empty() && mesh.triangles.empty()) mesh.problem = "it has no triangles";
  for (const Point& point : mesh.points)
    for (const double entry : point)
      if (!(std::abs(entry) < 1e9)) return refused("a corner is at no finite place");
  return mesh;
}

template <typename Number>
Number at(const std::string& text, std::size_t offset) {
  Number value = 0;
  std::memcpy(&value, &text[offset], sizeof value);
  return value;
}

Point point_at(const std::string& text, std::size_t offset) {
  return {at<float>(text, offset), at<float>(text, offset + 4), at<float>(text, offset + 8)};
}

void add_triangle(Mesh& mesh, const std::array<Point, 3>& corners) {
  const std::size_t first = mesh.points.size();
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Mesh read_binary_stl(const std::string& text, std::size_t count) {
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<Point, 3> corners;
    for (std::size_t corner = 0; corner < 3; ++corner)
      corners.at(corner) = point_at(text, header + record * i + 12 * (corner + 1));
    add_triangle(mesh, corners);
  }
  return checked(std::move(mesh));
}

/// Reads the next number of the text, rounded to 32 bits.
bool read_number(std::istringstream& words, double& value) {
  std::string word;
  if (!(words >> word)) return false;
  char* end = nullptr;
  value = std::strtof(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}

bool read_point(std::istringstream& words, Point& point) {
  return std::all_of(point.begin(), point.end(), [&](double& entry) { return read_number(words, entry); });
}

Mesh read_ascii_stl(const std::string& text) {
  Mesh mesh;
  std::istringstream words(text);
  std::vector<Point> corners;
  for (std::string word; words >> word;) {
    if (word == "facet") corners.clear();
    if (word != "vertex") continue;
    if (!read_point(words, corners.emplace_back())) return refused("a vertex is no three numbers");
    if (corners.size() == 3) add_triangle(mesh, {corners[0], corners[1], corners[2]});
    if (corners.size() > 3) return refused("a facet has more than three vertices");
  }
  return checked(std::move(mesh));
}

/// The corner's index from 0 of "7", "7/1/2" or "-1" (the last one); none if there is no such corner.
bool read_corner(const std::string& word, std::size_t points, std::size_t& corner) {
  const long number = std::strtol(word.c_str(), nullptr, 10);
  const long index = number > 0 ? number - 1 : static_cast<long>(points) + number;
  corner = static_cast<std::size_t>(index);
  return number != 0 && index >= 0 && corner < points;
}

/// Splits a polygon into triangles from its first corner.
bool read_face(std::istringstream& words, Mesh& mesh) {
  std::vector<std::size_t> corners;
  for (std::string word; words >> word;)
    if (!read_corner(word, mesh.points.size(), corners.emplace_back())) return false;
  if (corners.size() < 3) return false;
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  return true;
}

}  // namespace

Mesh read_stl(const std::string& text) {
  if (text.size() >= header) {
    const auto count = at<std::uint32_t>(text, 80);
    if (text.size() == header + record * static_cast<std::size_t>(count)) return read_binary_stl(text, count);
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text.compare(first, 5, "solid") == 0) return read_ascii_stl(text);
  return refused("it is no STL file: neither 'solid' nor a count of triangles that fits its size");
}

Mesh read_obj(const std::string& text) {
  Mesh mesh;
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line);
    std::string key;
    words >> key;
    const bool good = key == "v"   ? read_point(words, mesh.points.emplace_back())
                      : key == "f" ? read_face(words, mesh)
                                   : true;
    if (!good) return refused("line " + std::to_string(number) + " is no vertex or face");
  }
  return checked(std::move(mesh));
}

/// Four counts (vertices, normals, texture coordinates, faces), then their numbers, of 32 bits each.
Mesh read_msh(const std::string& text) {
  if (text.size() < 16) return refused("it is no MSH file: it has no counts");
  std::array<std::size_t, 4> count{};
  for (std::size_t i = 0; i < 4; ++i) count.at(i) = at<std::uint32_t>(text, 4 * i);
  const std::size_t faces = 16 + 12 * count[0] + 12 * count[1] + 8 * count[2];
  if (text.size() != faces + 12 * count[3])
    return refused("it is no MSH file: its counts do not fit its size");
  Mesh mesh;
  for (std::size_t i = 0; i < count[0]; ++i) mesh.points.push_back(point_at(text, 16 + 12 * i));
  for (std::size_t i = 0; i < count[3]; ++i) {
    auto& triangle = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.at(k) = at<std::uint32_t>(text, faces + 12 * i + 4 * k);
      if (triangle.at(k) >= count[0]) return refused("a face has a vertex that is not there");
    }
  }
  return checked(std::move(mesh));
}

Mesh read_mesh(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto read = extension == ".stl" ? read_stl : extension == ".obj" ? read_obj : read_msh;
  if (extension != ".stl" && extension != ".obj" && extension != ".msh")
    return refused("only STL, OBJ and MSH files are read");
  const FileText file = read_text_of(path, max_mesh_size);
  if (!file.problem.empty()) return refused(file.problem);
  return read(file.text);
}

}  // namespace qvgen::description::xml
