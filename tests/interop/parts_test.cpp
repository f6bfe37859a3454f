// SPDX-License-Identifier: MIT
#include <fstream>
#include <iomanip>

#include <gtest/gtest.h>
#include <unistd.h>

#include "compare.h"
#include "random.h"

// Models in several files, with frames, copies and attached models, against one that says the same in plain
// bodies, which MuJoCo of any version reads: a frame around a body is a body without joints around it.
namespace arms {
namespace {

namespace fs = std::filesystem;

/// Two texts with equal content.
struct Text {
  std::string parts, plain;
  Text& operator+=(const Text& other) {
    parts += other.parts;
    plain += other.plain;
    return *this;
  }
};
Text both(const std::string& text) { return {text, text}; }

class Writer {
 public:
  Writer(unsigned seed, fs::path folder) : random(seed), folder_(std::move(folder)) {}

  /// The model's file; `tip` and `plain` are set.
  fs::path write() {
    tip = "tool0";
    const Text content = bodies(2 + random.below(3), 0);
    plain = "<mujoco><compiler angle=\"radian\"/>\n<worldbody>" + content.plain + "</worldbody></mujoco>";
    return write("main.xml", model(content.parts));
  }

  Random random;
  std::string tip, plain;

 private:
  fs::path write(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  std::string model(const std::string& world) {
    std::string text = "<mujoco>\n<compiler angle=\"radian\"/>\n<asset>" + assets_ + "</asset>\n";
    assets_.clear();
    return text + "<worldbody>" + world + "</worldbody></mujoco>";
  }

  std::string pose() { return attribute("pos", random.reals(3)) + orientation(random, 3); }

  /// A body with a joint and a mass, and with what the rest of the chain is.
  Text bodies(int count, int depth) {
    const std::string number = std::to_string(names_++);
    Text text = both("<body" + attribute("name", count == 0 ? "tool0" : "b" + number) + pose() + ">");
    text += both("<inertial pos=\"0.1 0.2 0.3\" mass=\"2\" diaginertia=\"0.3 0.25 0.2\"/>\n");
    if (count > 0) text += joint("j" + number);
    if (random.below(2) == 0) text += copies(depth);
    if (count > 0) text += wrapped(count - 1, depth);
    return text += both("</body>\n");
  }

  /// A joint in a frame, and one whose point and axis have been displaced.
  Text joint(const std::string& name) {
    const auto vector = [&] { return Eigen::Vector3d(random.real(), random.real(), random.real()); };
    const Eigen::Vector3d at = vector(), point = vector(), axis = vector();
    const Eigen::Quaterniond turn(random.real(), random.real(), random.real(), random.real());
    const auto with = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& a) {
      std::ostringstream text;
      text << std::setprecision(17) << "<joint name=\"" << name << "\" pos=\"" << p.transpose()
           << "\" axis=\"" << a.transpose() << "\"/>";
      return text.str();
    };
    std::ostringstream frame;
    frame << std::setprecision(17) << "<frame pos=\"" << at.transpose() << "\" quat=\"" << turn.w() << " "
          << turn.x() << " " << turn.y() << " " << turn.z() << "\">" << with(point, axis) << "</frame>\n";
    const Eigen::Quaterniond unit = turn.normalized();
    return {frame.str(), with(at + unit * point, unit * axis) + "\n"};
  }

  Text wrapped(int count, int depth) {
    switch (depth > 3 ? 0 : random.below(4)) {
      case 1:
        return framed(count, depth + 1);
      case 2:
        return included(count, depth + 1);
      case 3:
        return attached(count, depth + 1);
      default:
        return bodies(count, depth);
    }
  }

  Text framed(int count, int depth) {
    const std::string frame = pose();
    const Text inner = wrapped(count, depth);
    return {"<frame" + frame + ">" + inner.parts + "</frame>\n",
            "<body" + frame + ">" + inner.plain + "</body>\n"};
  }

  Text included(int count, int depth) {
    const Text inner = wrapped(count, depth);
    const std::string file =
        (random.below(2) == 0 ? "" : "deeper/") + std::string("part") + std::to_string(files_++) + ".xml";
    write(file, "<mujocoinclude>\n" + inner.parts + "</mujocoinclude>");
    return {"<include file=\"" + file + "\"/>\n", inner.plain};
  }

  /// The names of what is attached are another's: in the plain text they do not matter, but that of the tip.
  Text attached(int count, int depth) {
    const std::string outside = std::exchange(assets_, "");
    const std::string number = std::to_string(files_++);
    Text inner = bodies(count, depth);
    const std::size_t name = inner.parts.find("name=\"") + 6;
    const std::string body = inner.parts.substr(name, inner.parts.find('"', name) - name);
    write("model" + number + ".xml", model(inner.parts));
    assets_ = outside + "<model name=\"m" + number + "\" file=\"model" + number + ".xml\"/>";
    tip = "p" + number + "_" + tip;
    inner.parts = "<attach model=\"m" + number + "\" body=\"" + body + "\" prefix=\"p" + number + "_\"/>\n";
    return inner;
  }

  /// Fixed bodies in a row.
  Text copies(int depth) {
    const int count = 1 + random.below(12);
    const Eigen::Vector3d offset(random.real(), random.real(), random.real()),
        euler(0, random.real(), random.real());
    Text inner = both("<body" + attribute("pos", random.reals(3)) +
                      "><inertial pos=\"0 0 0\" mass=\"0.5\" diaginertia=\"0.1 0.2 0.15\"/></body>\n");
    if (depth < 2 && random.below(3) == 0) inner = copies(depth + 2);
    std::ostringstream copied, written;
    copied << std::setprecision(17) << "<replicate count=\"" << count << "\" sep=\"-\" offset=\""
           << offset.transpose() << "\" euler=\"" << euler.transpose() << "\">" << inner.parts
           << "</replicate>\n";
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d angles = i * euler;
      written << std::setprecision(17) << "<body pos=\"" << at.transpose() << "\" euler=\""
              << angles.transpose() << "\">" << inner.plain << "</body>\n";
      using Eigen::AngleAxisd;
      at += AngleAxisd(angles[0], Eigen::Vector3d::UnitX()) *
            (AngleAxisd(angles[1], Eigen::Vector3d::UnitY()) *
             (AngleAxisd(angles[2], Eigen::Vector3d::UnitZ()) * offset));
    }
    return {copied.str(), written.str()};
  }

  fs::path folder_;
  std::string assets_;  ///< of the model that is being written
  int names_ = 0, files_ = 0;
};

TEST(Parts, RandomModelsAgreeWithPlainOnes) {
  const fs::path folder = fs::temp_directory_path() / ("qvgen_parts_" + std::to_string(::getpid()));
  for (unsigned seed = 0; seed < 40; ++seed) {
    Writer writer(seed, folder / std::to_string(seed));
    const fs::path file = writer.write();
    SCOPED_TRACE("seed " + std::to_string(seed) + " " + file.string() + "\n" + writer.plain);
    compare(chain_of(read_file(file, writer.tip)), *mujoco(writer.plain), writer.random.engine);
    if (HasFailure()) return;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace arms
