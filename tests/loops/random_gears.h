// SPDX-License-Identifier: MIT
// Gears among random rods: one or two driven joints follow motors, by one factor or as in a differential, and
// wheels follow other joints. A wheel behind a joint that loops hold has a whole factor, since loops do not
// give whole turns.
#pragma once

#include <algorithm>
#include <map>
#include <random>
#include <regex>
#include <string>
#include <vector>

namespace qvgen::test::loops {

class RandomGears {
 public:
  /// Adds gears to a description of random rods. One seed has the same gears.
  RandomGears(std::string rods, unsigned seed) : random_(seed), text_(std::move(rods)) {
    read();
    const std::size_t motors = driven_.size() > 1 && below(2) == 0 ? 2 : 1;
    for (std::size_t i = 0; i < motors; ++i) follow_motors(driven_[i], i, motors);
    write_driven(motors);
    for (int wheel = 0, wheels = 1 + below(2); wheel < wheels; ++wheel)
      add_wheel("w" + std::to_string(wheel));
    text_.insert(text_.find("[[tip]]"), added_);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  /// Finds the joints with their types, and those that are driven, in any order.
  void read() {
    static const std::regex joint("type = \"(revolute|prismatic)\"\naxis = .*\nvariable = \"(\\w+)\"");
    for (std::sregex_iterator at(text_.begin(), text_.end(), joint), end; at != end; ++at) {
      names_.push_back((*at)[2]);
      type_[names_.back()] = (*at)[1];
    }
    const std::string list = driven_list();
    static const std::regex name("\"(\\w+)\"");
    for (std::sregex_iterator at(list.begin(), list.end(), name), end; at != end; ++at)
      driven_.push_back((*at)[1]);
    std::shuffle(driven_.begin(), driven_.end(), random_);
  }
  [[nodiscard]] std::string driven_list() const {
    const std::size_t begin = text_.find("actuated = [");
    return text_.substr(begin, text_.find('\n', begin) - begin);
  }

  /// Makes a driven joint follow all motors, with other factors than those of the joint before.
  void follow_motors(const std::string& joint, std::size_t row, std::size_t motors) {
    std::string sum;
    for (std::size_t k = 0; k < motors; ++k) {
      const bool is_negative = row == 1 && k == 1;  // so that no two rows are multiples of each other
      sum += std::string(is_negative ? " - " : k == 0 ? "" : " + ") + fraction() + " m" + std::to_string(k);
    }
    const std::string variable = "variable = \"" + joint + "\"\n";
    text_.insert(text_.find(variable) + variable.size(), "follows = \"" + sum + " + 0." + digits() + "\"\n");
    follows_.push_back(joint);
    added_ += "[[motor]]\nvariable = \"m" + std::to_string(row) + "\"\nrotor_inertia = 0." + digits() +
              "\nviscous_friction = 0." + digits() + "\n";
  }
  void write_driven(std::size_t motors) {
    std::string list;
    for (std::size_t i = 0; i < driven_.size(); ++i)
      list += (i == 0 ? "\"" : ", \"") + (i < motors ? "m" + std::to_string(i) : driven_[i]) + '"';
    const std::string before = driven_list();
    text_.replace(text_.find(before), before.size(), "actuated = [" + list + "]");
  }

  void add_wheel(const std::string& name) {
    const std::string leader = names_[static_cast<std::size_t>(below(static_cast<int>(names_.size())))];
    if (std::find(follows_.begin(), follows_.end(), leader) != follows_.end()) return;
    const bool is_driven = std::find(driven_.begin(), driven_.end(), leader) != driven_.end();
    const std::string factor = is_driven ? fraction() : std::to_string(1 + below(3));
    added_ += "[[joint]]\ntype = \"" + type_.at(leader) + "\"\naxis = \"-z\"\nvariable = \"" + name +
              "\"\nparent = \"base\"\norigin = [0." + digits() + ", 0.1, 0]\nfollows = \"" +
              (below(2) == 0 ? "-" : "") + factor + " " + leader + " - 0." + digits() +
              "\"\nrotor_inertia = 0." + digits() + "\n";
  }

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string digits() { return std::to_string(10 + below(90)); }
  std::string fraction() { return std::to_string(1 + below(3)) + "/" + std::to_string(1 + below(4)); }

  std::mt19937 random_;
  std::string text_, added_;
  std::vector<std::string> names_, driven_, follows_;
  std::map<std::string, std::string> type_;
};

}  // namespace qvgen::test::loops
