// SPDX-License-Identifier: MIT
// Random mechanisms on two to six rods, as people would write them: rods one behind the other along a chain,
// or side by side from cranks, cylinders and the base to one platform; in a plane or in space, all of it on a
// moving link sometimes. A rod with a universal joint at its foot is a strut: two turns and a ball. Rods
// have the lengths at which the mechanism closes for random values of its joints.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "reference/loops.h"

namespace qvgen::test::loops {

class RandomRods {
 public:
  /// Draws a mechanism and writes its description to a file. One seed has one mechanism.
  RandomRods(unsigned seed, const std::filesystem::path& file) : random_(seed) {
    planar_ = one_of(2);
    chain_ = one_of(2);
    if (one_of(4)) base_ = moving_joint("base"), actuated_ = {base_};
    const int rods = among(2, 6);
    chain_ ? chain(rods) : platform(rods);
    find_lengths(file);
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  /// True if each rod places one joint, so that there is a closed form.
  [[nodiscard]] bool is_chain() const { return chain_ && natural_; }

 private:
  struct Rod {
    std::string a, at_a, b, at_b;
    std::string cylinder = {};  ///< the joint whose value is its length
    std::string strut = {};     ///< the last turn at its foot
  };

  /// Each rod holds one more joint of a tree.
  void chain(int rods) {
    if (actuated_.empty() || one_of(2)) actuated_.push_back(moving_joint(any_link()));
    for (int k = 0; k < rods; ++k) {
      if (links_.size() > 1 && one_of(5)) {
        const std::string length = cylinder();
        add_rod(links_[links_.size() - 2], links_.back(), length);
        continue;
      }
      const std::string parent = any_link(), other = another_link(parent);
      add_rod(moving_joint(parent), other);
    }
    drive_others();
  }

  /// Legs hold a body, which some joints carry.
  void platform(int rods) {
    const std::vector<std::string> carrier = carried_body();
    const std::string body = carrier.back();
    int holding = 0;  // of legs that have no motor
    std::vector<std::string> motors;
    for (int k = 0; k < rods; ++k) {
      const bool may_hold = holding + 1 < static_cast<int>(carrier.size());
      if (may_hold && one_of(6)) {
        ++holding;
        one_of(2) && !planar_ ? add_strut(body) : add_rod(base_, body);
      } else if (one_of(3)) {
        motors.push_back(cylinder());
        add_rod(base_, body, motors.back());
      } else {
        motors.push_back(moving_joint(base_));
        add_rod(motors.back(), body);
      }
    }
    const std::size_t freedoms = carrier.size() - static_cast<std::size_t>(holding);
    outputs_ = {carrier.begin(), carrier.begin() + static_cast<std::ptrdiff_t>(freedoms)};
    for (const std::string& each : carrier) motors.push_back(each);
    motors.resize(freedoms);
    for (const std::string& each : actuated_) outputs_.insert(outputs_.begin(), each);
    actuated_.insert(actuated_.end(), motors.begin(), motors.end());
    drive_others();
  }

  std::vector<std::string> carried_body() {
    static const std::vector<std::string> in_planes{"xyZ", "xyZ", "ZZ", "xZ", "Zx"};
    static const std::vector<std::string> in_space{"XY", "xyz", "zXY", "xyzXYZ", "XYZ", "xyzZ", "YX", "ZxY"};
    std::vector<std::string> carrier;
    std::string parent = base_;
    for (const char each : of(planar_ ? in_planes : in_space)) {
      const bool turns = each < 'a';
      const std::string axis = std::string("\"+") + static_cast<char>(turns ? each + 'x' - 'X' : each) + '"';
      const bool stands_apart = carrier.empty() || one_of(4);
      parent = add_joint(parent, turns, axis, stands_apart ? "origin = " + point() + "\n" : "");
      carrier.push_back(parent);
    }
    return carrier;
  }

  /// Drives some joint instead of another in a few mechanisms: they may have no closed form then.
  void drive_others() {
    natural_ = !one_of(5);
    if (natural_) return;
    const std::string other = of(links_);
    if (std::find(actuated_.begin(), actuated_.end(), other) == actuated_.end()) actuated_.back() = other;
  }

  std::string add_joint(const std::string& parent, bool turns, const std::string& axis,
                        const std::string& more) {
    const std::string name = "j" + std::to_string(++joint_count_);
    joints_ += std::string("[[joint]]\ntype = \"") + (turns ? "revolute" : "prismatic") +
               "\"\naxis = " + axis + "\nvariable = \"" + name + "\"\nparent = \"" + parent + "\"\n" + more;
    links_.push_back(name);
    return name;
  }
  std::string moving_joint(const std::string& parent) {
    const bool turns = !one_of(5);
    const std::string more = "origin = " + point() + "\nlink = " + point() + "\n";
    if (planar_) return add_joint(parent, turns, turns ? "\"+z\"" : one_of(2) ? "\"+x\"" : "\"-y\"", more);
    static const std::vector<std::string> axes{"\"+x\"", "\"-y\"", "\"+z\"", "[0, \"3/5\", \"4/5\"]",
                                               "[\"2/3\", \"1/3\", \"-2/3\"]"};
    return add_joint(parent, turns, of(axes), more);
  }
  /// A slide that carries nothing: its value is the length of a rod.
  std::string cylinder() {
    const std::string name = add_joint("base", false, "\"+x\"", "");
    links_.pop_back();
    return name;
  }
  void add_rod(const std::string& a, const std::string& b, const std::string& length = "") {
    rods_.push_back({a, point(), b, point(), length});
  }
  void add_strut(const std::string& body) {
    const std::string foot = point();
    const std::string first = add_joint(base_, true, "\"+x\"", "origin = " + foot + "\n");
    const std::string last = add_joint(first, true, "\"+y\"", "");
    links_.resize(links_.size() - 2);
    rods_.push_back({base_, foot, body, point(), "", last});
  }

  /// Writes the description. Struts are rods until they have lengths.
  [[nodiscard]] std::string written(const std::vector<double>& lengths) const {
    std::string text = "name = \"m\"\ntitle = \"m\"\nactuated = [" + list(actuated_) + "]\n";
    if (!outputs_.empty()) text += "outputs = [" + list(outputs_) + "]\n";
    text += joints_ + "[[tip]]\nname = \"end\"\n";
    for (std::size_t i = 0; i < rods_.size(); ++i) {
      const Rod& rod = rods_[i];
      const std::string length = lengths.empty() ? "1" : rounded(lengths[i]);
      const bool is_strut = !rod.strut.empty() && !lengths.empty();
      text += std::string("[[loop]]\ntype = \"") + (is_strut ? "ball" : "rod") + "\"\nbetween = [\"" +
              (is_strut ? rod.strut : rod.a) + "\", \"" + rod.b + "\"]\nat = [" +
              (is_strut ? "[0, 0, " + length + "]" : rod.at_a) + ", " + rod.at_b + "]\n";
      if (!is_strut) text += "length = " + (rod.cylinder.empty() ? length : '"' + rod.cylinder + '"') + "\n";
    }
    return text;
  }

  void find_lengths(const std::filesystem::path& file) {
    std::ofstream(file) << written({});
    const reference::LoopMechanism mechanism = reference::load_loops(file);
    Eigen::VectorXd q(joint_count_);
    for (double& each : q) each = std::uniform_real_distribution<double>(-1.5, 1.5)(random_);
    const Eigen::VectorXd gaps = reference::gaps(mechanism, q);
    std::vector<double> lengths;
    for (const double gap : gaps) lengths.push_back(std::max(gap + 1, 0.05));
    text_ = written(lengths);
    std::ofstream(file) << text_;
  }

  int among(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
  }
  bool one_of(int count) { return among(1, count) == 1; }
  const std::string& of(const std::vector<std::string>& names) { return names[random_() % names.size()]; }
  std::string any_link() { return links_.empty() || one_of(3) ? base_ : of(links_); }
  std::string another_link(const std::string& than) {
    std::vector<std::string> others{links_};
    others.emplace_back("base");
    std::erase(others, than);
    return of(others);
  }
  std::string number() { return (one_of(2) ? "-0." : "0.") + std::to_string(among(10, 99)); }
  std::string point() {
    const std::string x = number(), y = number();
    return "[" + x + ", " + y + ", " + (planar_ ? "0" : number()) + "]";
  }
  static std::string rounded(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4f", value);
    return text.data();
  }
  static std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& each : names) text += (text.empty() ? "\"" : ", \"") + each + '"';
    return text;
  }

  std::mt19937 random_;
  bool planar_ = false, chain_ = false, natural_ = true;
  std::string base_ = "base", joints_, text_;
  std::vector<std::string> links_, actuated_, outputs_;
  std::vector<Rod> rods_;
  int joint_count_ = 0;
};

}  // namespace qvgen::test::loops
