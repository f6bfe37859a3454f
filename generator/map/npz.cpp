// SPDX-License-Identifier: MIT
// NumPy's archive: arrays in its own format (NEP 1) in a zip file, stored as they are.
#include <cstring>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "map/checksum.h"
#include "map/quantities.h"

namespace qvgen::map {
namespace {

/// Two letters as zip files mark their records, PK and two numbers.
void append_mark(std::string& to, char a, char b) { to += {'P', 'K', a, b}; }

/// A zip file whose entries are all of one day, so that the same content is the same file.
class Zip {
 public:
  void add(const std::string& name, const std::string& content) {
    if (bytes_.size() + content.size() + directory_.size() > std::numeric_limits<std::uint32_t>::max() - 1000)
      throw std::runtime_error(
          "the map is larger than a .npz of 4 GB holds: take a coarser resolution, or write a .vtk");
    const auto offset = static_cast<std::uint32_t>(bytes_.size());
    const std::string about = description(name, content);
    append_mark(bytes_, 3, 4);
    bytes_ += about + name + content;
    append_mark(directory_, 1, 2);
    append_number(directory_, std::uint16_t{20});
    directory_ += about;
    directory_.append(10, '\0');  // comment, disk, attributes
    append_number(directory_, offset);
    directory_ += name;
    ++count_;
  }
  std::string whole() && {
    const auto start = static_cast<std::uint32_t>(bytes_.size());
    bytes_ += directory_;
    append_mark(bytes_, 5, 6);
    append_number(bytes_, std::uint32_t{0});
    append_number(bytes_, count_);
    append_number(bytes_, count_);
    append_number(bytes_, static_cast<std::uint32_t>(directory_.size()));
    append_number(bytes_, start);
    append_number(bytes_, std::uint16_t{0});
    return std::move(bytes_);
  }

 private:
  /// Writes the part that both records of an entry share: stored, on the first day that can be written.
  static std::string description(const std::string& name, const std::string& content) {
    std::string text;
    append_number(text, std::uint16_t{20});
    append_number(text, std::uint16_t{0});
    append_number(text, std::uint16_t{0});
    append_number(text, std::uint16_t{0});
    append_number(text, std::uint16_t{0x21});
    append_number(text, checksum(content));
    append_number(text, static_cast<std::uint32_t>(content.size()));
    append_number(text, static_cast<std::uint32_t>(content.size()));
    append_number(text, static_cast<std::uint16_t>(name.size()));
    append_number(text, std::uint16_t{0});
    return text;
  }

  std::string bytes_, directory_;
  std::uint16_t count_ = 0;
};

/// The head of an array, padded as the format asks.
std::string npy_head(const std::string& type, const std::string& shape) {
  std::string head = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  head.append(63 - (head.size() + 10) % 64, ' ');
  head += '\n';
  std::string text = "\x93NUMPY";
  text += {1, 0};
  append_number(text, static_cast<std::uint16_t>(head.size()));
  return text + head;
}

template <class Number>
void append_bits(std::string& to, Number number) {
  std::array<char, sizeof(Number)> bytes{};
  std::memcpy(bytes.data(), &number, sizeof number);
  to.append(bytes.data(), bytes.size());
}

std::string axis_array(const Cube& cube, std::size_t axis) {
  std::string text = npy_head("<f8", fmt::format("{},", cube.edge()));
  for (std::int64_t i = -cube.half(); i <= cube.half(); ++i) append_bits(text, cube.place(axis, i));
  return text;
}

std::string values_array(const Cube& cube, const Quantity& quantity) {
  std::string text = npy_head("<f4", fmt::format("{0}, {0}, {0}", cube.edge()));
  const std::int64_t half = cube.half();
  for (std::int64_t i = -half; i <= half; ++i)
    for (std::int64_t j = -half; j <= half; ++j)
      for (std::int64_t k = -half; k <= half; ++k) append_bits(text, cube.value(quantity, i, j, k));
  return text;
}

/// The orientations, directions or angles.
std::string target_array(const About& about, Task task, std::size_t numbers) {
  const std::size_t count = about.plan.targets;
  std::string text = npy_head("<f8", fmt::format("{}, {}", count, numbers));
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t n = 0; n < numbers; ++n) append_bits(text, target_of(task, i, count).at(n));
  return text;
}

void add_targets(const About& about, Zip& zip) {
  const std::string name = target_name(about) + ".npy";
  if (about.task == "pose") zip.add(name, target_array(about, Task::pose, 4));
  if (about.task == "position_and_direction" || about.task == "position_and_inclination")
    zip.add(name, target_array(about, Task::position_and_direction, 3));
  if (about.task == "position_and_yaw" || about.task == "position_and_pitch")
    zip.add(name, target_array(about, Task::position_and_yaw, 1));
}

}  // namespace

std::string npz_text(const Part& part) {
  const Cube cube(part);
  Zip zip;
  const std::string about = to_json(part.about).dump();
  zip.add("about.npy", npy_head(fmt::format("|S{}", about.size()), "") + about);
  for (std::size_t axis = 0; axis < 3; ++axis)
    zip.add(fmt::format("{}.npy", "xyz"[axis]), axis_array(cube, axis));
  add_targets(part.about, zip);
  for (const Quantity& quantity : quantities_of(part.about))
    zip.add(quantity.name + ".npy", values_array(cube, quantity));
  return std::move(zip).whole();
}

}  // namespace qvgen::map
