// SPDX-License-Identifier: MIT
#include "reference/load.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <toml++/toml.h>

namespace reference {
namespace {

Isometry3d shift(double x, double y, double z) { return Isometry3d(Eigen::Translation3d(x, y, z)); }
Isometry3d shift(const Vector3d& v) { return shift(v.x(), v.y(), v.z()); }
Isometry3d turn(double angle, const Vector3d& axis) { return Isometry3d(Eigen::AngleAxisd(angle, axis)); }

double number(const toml::node& node, const Values& values) {
  if (const auto text = node.value_exact<std::string>()) return evaluate(*text, values);
  if (const auto value = node.value<double>()) return *value;
  throw std::runtime_error("a number or an expression expected");
}

/// A table of the file together with the values of the symbols.
class Reader {
 public:
  Reader(const toml::table& table, const Values& values) : table_(table), values_(values) {}

  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
  [[nodiscard]] std::string text(std::string_view key) const { return table_[key].value_or(std::string()); }

  [[nodiscard]] double entry(std::string_view key) const {
    return has(key) ? number(*table_.get(key), values_) : 0.0;
  }
  [[nodiscard]] VectorXd list(std::string_view key) const {
    const toml::array* array = table_[key].as_array();
    if (array == nullptr) return VectorXd();
    VectorXd result(static_cast<Eigen::Index>(array->size()));
    Eigen::Index i = 0;
    for (const toml::node& node : *array) result[i++] = number(node, values_);
    return result;
  }
  [[nodiscard]] Vector3d vector(std::string_view key) const {
    const VectorXd entries = list(key);
    return entries.size() == 3 ? Vector3d(entries) : Vector3d::Zero();
  }

  [[nodiscard]] Vector3d axis() const {
    const std::string name = text("axis");
    if (name.empty()) return vector("axis");
    const auto index = static_cast<Eigen::Index>(std::string_view("xyz").find(name.back()));
    return (name.front() == '-' ? -1.0 : 1.0) * Vector3d::Unit(index);
  }

  /// `rpy` (fixed axes) or `turns` (each in the frame that the one before has made).
  [[nodiscard]] Isometry3d rotation() const {
    Isometry3d result = Isometry3d::Identity();
    if (has("rpy")) {
      const Vector3d angles = vector("rpy");
      return turn(angles.z(), Vector3d::UnitZ()) * turn(angles.y(), Vector3d::UnitY()) *
             turn(angles.x(), Vector3d::UnitX());
    }
    for (const Reader& step : tables("turns")) result = result * turn(step.entry("angle"), step.axis());
    return result;
  }
  [[nodiscard]] Isometry3d frame(std::string_view key) const {
    const toml::table* table = table_[key].as_table();
    if (table == nullptr) return Isometry3d::Identity();
    const Reader reader(*table, values_);
    return shift(reader.vector("translation")) * reader.rotation();
  }

  [[nodiscard]] std::vector<Reader> tables(std::string_view key) const {
    std::vector<Reader> result;
    if (const toml::array* array = table_[key].as_array()) {
      for (const toml::node& node : *array) result.emplace_back(*node.as_table(), values_);
    }
    return result;
  }

  /// The value of the key, or of the free parameter `symbol` if the file leaves the key out or says "free".
  [[nodiscard]] double parameter(std::string_view key, const std::string& symbol) const {
    return has(key) && text(key) != "free" ? entry(key) : free(symbol);
  }
  [[nodiscard]] double free(const std::string& symbol) const {
    const auto found = values_.find(symbol);
    return found == values_.end() ? 0.0 : found->second;
  }

  /// An entry that may contain the joint's variable, as a linear function of it.
  struct Linear {
    double slope;
    double rest;
  };
  [[nodiscard]] Linear linear(std::string_view key, const std::string& variable) const {
    if (!has(key)) return {0, 0};
    Values at = values_;
    at[variable] = 0;
    const double rest = number(*table_.get(key), at);
    at[variable] = 1;
    return {std::round(number(*table_.get(key), at) - rest), rest};
  }

 private:
  const toml::table& table_;
  const Values& values_;
};

/// True for letters, digits and the underscore.
bool is_in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Returns the names in a sum in their order, without units. The blank between a factor and a name becomes
/// '*'.
std::vector<std::string> take_names(std::string& sum) {
  std::vector<std::string> names;
  std::size_t end = 0;
  for (std::size_t at = 0; at < sum.size(); at = std::max(end, at + 1)) {
    end = static_cast<std::size_t>(
        std::find_if_not(sum.begin() + static_cast<std::ptrdiff_t>(at), sum.end(), is_in_word) - sum.begin());
    const std::string word = sum.substr(at, end - at);
    if (word.empty() || is_digit(word.front()) || word == "deg" || word == "rad") continue;
    names.push_back(word);
    if (at > 1 && sum[at - 1] == ' ' && (is_digit(sum[at - 2]) || sum[at - 2] == ')')) sum[at - 1] = '*';
  }
  for (std::size_t at = 1; at + 1 < sum.size(); ++at)
    if (sum[at] == ' ' && is_digit(sum[at - 1]) && sum[at + 1] == '(') sum[at] = '*';
  return names;
}

/// Reads a sum of multiples of names and a constant: the factors by what the sum is where one name has the
/// value 1 and all others 0. Returns the constant.
double read_relation(const std::string& text, Joint& joint) {
  std::string sum = text;
  const std::vector<std::string> names = take_names(sum);
  Values zero;
  for (const std::string& each : names) zero[each] = 0;
  if (sum.find('^') != std::string::npos) {
    joint.leaders.emplace_back(names.front(), 0);
    joint.polynomial = sum;
    return 0;
  }
  const double constant = evaluate(sum, zero);
  for (const std::string& each : names) {
    Values one = zero;
    one[each] = 1;
    joint.leaders.emplace_back(each, evaluate(sum, one) - constant);
  }
  return constant;
}

void read_motors(const Reader& root, Chain& chain) {
  for (const Reader& table : root.tables("motor")) {
    const std::string variable = table.text("variable");
    chain.motors.push_back({variable, table.parameter("rotor_inertia", "Ia_" + variable),
                            table.parameter("viscous_friction", "Fv_" + variable),
                            table.parameter("coulomb_friction", "Fc_" + variable)});
  }
}

/// Once all joints are read, since a joint may lead one before it.
void tie_followers(const std::vector<Reader>& tables, Chain& chain) {
  std::size_t i = 0;
  for (const Reader& table : tables) {
    if (table.text("variable").empty()) continue;
    Joint& joint = chain.joints[i++];
    if (!table.has("follows")) continue;
    double offset = table.entry("offset");
    if (table.text("follows").find_first_of(" +-*/^()") == std::string::npos)
      joint.leaders = {{table.text("follows"), table.has("ratio") ? table.entry("ratio") : 1.0}};
    else
      offset = read_relation(table.text("follows"), joint);
    joint.offset = offset;
    joint.before = joint.before * (joint.revolute ? turn(offset, joint.axis) : shift(offset * joint.axis));
  }
}

void read_link(const Reader& reader, const std::string& number, Joint& joint) {
  joint.mass = reader.parameter("mass", "m" + number);
  joint.rotor_inertia = reader.parameter("rotor_inertia", "Ia" + number);
  joint.viscous_friction = reader.parameter("viscous_friction", "Fv" + number);
  joint.coulomb_friction = reader.parameter("coulomb_friction", "Fc" + number);
  joint.centre_of_mass = reader.has("centre_of_mass")
                             ? reader.vector("centre_of_mass")
                             : Vector3d(reader.free("c" + number + "x"), reader.free("c" + number + "y"),
                                        reader.free("c" + number + "z"));
  VectorXd tensor = reader.list("inertia");
  if (tensor.size() == 0) {
    tensor.resize(6);
    Eigen::Index i = 0;
    for (const char* suffix : {"xx", "yy", "zz", "xy", "yz", "xz"}) {
      tensor[i++] = reader.free("I" + number + suffix);
    }
  }
  joint.inertia = tensor.head<3>().asDiagonal();
  if (tensor.size() == 6) {
    joint.inertia(0, 1) = joint.inertia(1, 0) = tensor[3];
    joint.inertia(1, 2) = joint.inertia(2, 1) = tensor[4];
    joint.inertia(0, 2) = joint.inertia(2, 0) = tensor[5];
  }
  const VectorXd limits = reader.list("limits");
  if (limits.size() == 2) {
    joint.lower = limits[0];
    joint.upper = limits[1];
  }
}

Joint start(const Reader& reader, std::size_t number) {
  Joint joint;
  joint.variable = reader.text("variable");
  joint.revolute = reader.text("type") != "prismatic";
  read_link(reader, std::to_string(number), joint);
  return joint;
}

/// "base" is none.
Eigen::Index named_joint(const Chain& chain, const std::string& name) {
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    if (chain.joints[i].variable == name) return static_cast<Eigen::Index>(i);
  return -1;
}

void read_joints(const Reader& root, Chain& chain) {
  for (const Reader& table : root.tables("joint")) {
    Joint joint = start(table, chain.joints.size() + 1);
    joint.axis = table.axis();
    joint.before = shift(table.vector("origin")) * table.rotation();
    joint.after = shift(table.vector("link"));
    if (table.has("parent")) joint.parent = named_joint(chain, table.text("parent"));
    chain.joints.push_back(joint);
  }
}

void read_table(const Reader& root, Chain& chain) {
  const bool standard = root.text("convention") == "standard";
  Isometry3d pending = Isometry3d::Identity();
  for (const Reader& row : root.tables("dh")) {
    const std::string variable = row.text("variable");
    const auto theta = row.linear("theta", variable);
    const auto d = row.linear("d", variable);
    const Isometry3d along_x = shift(row.entry("a"), 0, 0) * turn(row.entry("alpha"), Vector3d::UnitX());
    const Isometry3d turn_z = turn(theta.rest, Vector3d::UnitZ());
    const Isometry3d shift_z = shift(0, 0, d.rest);
    const Isometry3d before = standard ? turn_z : along_x * turn_z;
    const Isometry3d after = standard ? shift_z * along_x : shift_z;
    if (variable.empty()) {
      pending = pending * before * after;
      continue;
    }
    Joint joint = start(row, chain.joints.size() + 1);
    joint.revolute = row.text("type") == "revolute" || (d.slope == 0 && row.text("type") != "prismatic");
    const double slope = joint.revolute ? theta.slope : d.slope;
    joint.axis = Vector3d(0, 0, slope == 0 ? 1 : slope);
    joint.before = pending * before;
    joint.after = after;
    pending = Isometry3d::Identity();
    chain.joints.push_back(joint);
  }
  chain.tool = pending * chain.tool;
}

/// All frames parallel to the base at zero: from one to the next is the vector between their points.
void read_screws(const Reader& root, Chain& chain) {
  Vector3d at = Vector3d::Zero();
  for (const Reader& table : root.tables("screw")) {
    Joint joint = start(table, chain.joints.size() + 1);
    const Vector3d point = table.has("point") ? table.vector("point") : at;
    joint.axis = table.axis();
    joint.before = shift(point - at);
    at = point;
    chain.joints.push_back(joint);
  }
  chain.tool = shift(-at) * root.frame("home") * chain.tool;
}

/// Fixed to the link of the joint that is named, or of the last one.
void read_frames(const Reader& root, std::string_view key, Chain& chain) {
  for (const Reader& table : root.tables(key)) {
    NamedFrame frame{table.text("name"), chain.joints.size() - 1,
                     shift(table.vector("translation")) * table.rotation()};
    for (std::size_t i = 0; i < chain.joints.size(); ++i)
      if (chain.joints[i].variable == table.text("joint")) frame.joint = i;
    chain.frames.push_back(frame);
  }
}

Chain read(const toml::table& file, const Values& given) {
  Values values = given;
  if (const toml::table* defaults = file["defaults"].as_table()) {
    for (const auto& [key, node] : *defaults) values.emplace(std::string(key.str()), number(node, {}));
  }
  const Reader root(file, values);
  Chain chain;
  chain.name = root.text("name");
  chain.base = root.frame("base");
  chain.tool = root.frame("tool");
  if (root.has("joint")) read_joints(root, chain);
  if (root.has("dh")) read_table(root, chain);
  if (root.has("screw")) read_screws(root, chain);
  read_motors(root, chain);
  for (const char* key : {"joint", "dh", "screw"}) tie_followers(root.tables(key), chain);
  for (const char* key : {"frame", "tip"}) read_frames(root, key, chain);
  if (chain.joints.empty()) throw std::runtime_error("no joints");
  return chain;
}

}  // namespace

Chain load(const std::filesystem::path& file, const Values& values) {
  return read(toml::parse_file(file.string()), values);
}

Chain load_text(const std::string& toml, const Values& values) { return read(toml::parse(toml), values); }

}  // namespace reference
