// SPDX-License-Identifier: MIT
#include "map/part.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "map/checksum.h"
#include "pipeline/files.h"

namespace qvgen::map {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* format_name = "qvgen map 1";

std::string head_of(const About& about) { return to_json(about).dump() + "\n"; }

std::string record(int block, const std::vector<Cell>& cells) {
  std::string bytes;
  append_number(bytes, static_cast<std::uint32_t>(block));
  bytes.append(reinterpret_cast<const char*>(cells.data()), cells.size() * sizeof(Cell));  // NOLINT
  append_number(bytes, checksum(bytes));
  return bytes;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return number;
}

/// One record, and `at` behind it; false if there is none that is whole.
bool read_record(const std::string& bytes, const Grid& grid, std::size_t& at, Blocks& blocks) {
  if (bytes.size() - at < 8) return false;
  const std::uint32_t block = number_at(bytes, at);
  if (block >= Grid::blocks) return false;
  const int number = static_cast<int>(block);
  const auto count = static_cast<std::size_t>(grid.first_of(number + 1) - grid.first_of(number));
  const std::size_t size = 4 + count * sizeof(Cell);
  if (bytes.size() - at < size + 4) return false;
  if (checksum(std::string_view(bytes).substr(at, size)) != number_at(bytes, at + size)) return false;
  std::vector<Cell> cells(count);
  if (count > 0) std::memcpy(cells.data(), bytes.data() + at + 4, count * sizeof(Cell));
  blocks[number] = std::move(cells);
  at += size + 4;
  return true;
}

/// Reads the whole blocks of a file; `end` is where they end.
Part read_whole(const std::string& bytes, const fs::path& file, std::size_t& end) {
  const std::size_t line = bytes.find('\n');
  const ordered_json head =
      line == std::string::npos ? ordered_json() : ordered_json::parse(bytes.substr(0, line), nullptr, false);
  if (!head.is_object() || head.value("format", "") != format_name)
    throw std::runtime_error(file.string() + " is no part of a map");
  Part part{about_from_json(head), {}};
  const Grid grid(part.about.plan.sphere);
  end = line + 1;
  while (read_record(bytes, grid, end, part.blocks)) continue;
  return part;
}

/// The first thing in which they differ: "resolution 0.1, not 0.2"; empty if they are of one map.
std::string difference(const About& a, const About& b) {
  const ordered_json of_a = to_json(a), of_b = to_json(b);
  for (const auto& [key, value] : of_a.items()) {
    if (value == of_b.at(key)) continue;
    if (key == "program") return "it was computed from another description, or by another version of qvgen";
    return fmt::format("{} {}, not {}", key, of_b.at(key).dump(), value.dump());
  }
  return "";
}

}  // namespace

ordered_json to_json(const About& about) {
  const Plan& plan = about.plan;
  return {{"format", format_name},
          {"robot", about.robot},
          {"title", about.title},
          {"resolution", plan.sphere.resolution},
          {"centre", plan.sphere.centre},
          {"reach", plan.sphere.radius},
          {"own_reach", about.own_reach},
          {"task", about.task},
          {"orientations", plan.targets},
          {"given", about.given},
          {"values", plan.values},
          {"lower", plan.lower},
          {"upper", plan.upper},
          {"limits", plan.limits},
          {"limits_known", about.limits_known},
          {"program", about.program}};
}

About about_from_json(const ordered_json& json) {
  About about;
  about.robot = json.at("robot");
  about.title = json.at("title");
  about.program = json.at("program");
  about.task = json.at("task");
  about.given = json.at("given");
  about.own_reach = json.at("own_reach");
  about.limits_known = json.at("limits_known");
  about.plan.sphere = {json.at("centre"), json.at("reach"), json.at("resolution")};
  about.plan.targets = json.at("orientations");
  about.plan.values = json.at("values");
  about.plan.lower = json.at("lower");
  about.plan.upper = json.at("upper");
  about.plan.limits = json.at("limits");
  return about;
}

std::string target_name(const About& about) {
  if (about.task == "position_and_direction" || about.task == "position_and_inclination") return "directions";
  if (about.task == "position_and_yaw" || about.task == "position_and_pitch") return "angles";
  return "orientations";
}

std::string targets_text(const About& about) {
  if (about.task == "position") return "the position alone";
  return fmt::format("{} {}", about.plan.targets, target_name(about));
}

std::string missing_blocks(const Blocks& blocks) {
  std::string text;
  for (int block = 0; block < Grid::blocks; ++block) {
    if (blocks.count(block) > 0) continue;
    const int first = block;
    while (block + 1 < Grid::blocks && blocks.count(block + 1) == 0) ++block;
    text += (text.empty() ? "" : ", ") + std::to_string(first);
    if (block > first) text += ":" + std::to_string(block);
  }
  return text;
}

Part read_part(const fs::path& file) {
  const auto bytes = pipeline::content_of(file);
  if (!bytes) throw std::runtime_error("there is no file " + file.string());
  std::size_t end = 0;
  Part part = read_whole(*bytes, file, end);
  if (end != bytes->size()) throw std::runtime_error(file.string() + " is cut short or damaged");
  return part;
}

std::string part_text(const Part& part) {
  std::string text = head_of(part.about);
  for (const auto& [block, cells] : part.blocks) text += record(block, cells);
  return text;
}

Part merged(const std::vector<fs::path>& files) {
  Part all = read_part(files.front());
  for (std::size_t i = 1; i < files.size(); ++i) {
    Part part = read_part(files[i]);
    if (const std::string other = difference(all.about, part.about); !other.empty())
      throw std::runtime_error(fmt::format("{} and {} are not of one map: the second has {}",
                                           files.front().string(), files[i].string(), other));
    for (auto& [block, cells] : part.blocks) {
      const auto there = all.blocks.find(block);
      if (there != all.blocks.end() && record(block, there->second) != record(block, cells))
        throw std::runtime_error(fmt::format("block {} of {} differs from the one that was read before",
                                             block, files[i].string()));
      all.blocks[block] = std::move(cells);
    }
  }
  return all;
}

Journal::Journal(fs::path file, const About& about) : path_(std::move(file)), part_{about, {}} {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0)
    throw std::runtime_error("cannot write " + path_.string() + ": " +
                             std::generic_category().message(errno));
  try {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw std::runtime_error("another process is writing " + path_.string());
    const std::string bytes = pipeline::content_of(path_).value_or("");
    std::size_t end = 0;
    if (bytes.find('\n') == std::string::npos) {  // killed before the first line was whole, or new
      if (::ftruncate(file_, 0) != 0) throw std::runtime_error("cannot write " + path_.string());
      append(head_of(about));
      return;
    }
    part_ = read_whole(bytes, path_, end);
    if (const std::string other = difference(about, part_.about); !other.empty())
      throw std::runtime_error(fmt::format(
          "{} has been left by an unfinished map that is not this one, it has {}: finish that one, or remove "
          "the file",
          path_.string(), other));
    if (::ftruncate(file_, static_cast<off_t>(end)) != 0 || ::lseek(file_, 0, SEEK_END) < 0)
      throw std::runtime_error("cannot write " + path_.string());
  } catch (...) {
    ::close(file_);
    throw;
  }
}

Journal::~Journal() {
  std::error_code ignored;
  if (part_.blocks.empty()) fs::remove(path_, ignored);  // nothing to go on with
  ::close(file_);
}

void Journal::append(const std::string& bytes) const {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw std::runtime_error("cannot write " + path_.string() + ": " +
                               std::generic_category().message(errno));
    done += static_cast<std::size_t>(count);
  }
}

void Journal::add(int block, std::vector<Cell> cells) {
  append(record(block, cells));
  part_.blocks[block] = std::move(cells);
}

void Journal::remove() { fs::remove(path_); }

}  // namespace qvgen::map
