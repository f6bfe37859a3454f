// SPDX-License-Identifier: MIT
// The tip of a chain where nobody has said it. One limb: its end, by what makers call tips. Several: a list,
// arms first, with the likeliest as a command to copy.
#include <algorithm>
#include <cctype>
#include <string_view>

#include "description/names.h"
#include "description/tree/limbs.h"
#include "description/tree/tree.h"

namespace qvgen::description::tree {
namespace {

using Nodes = std::vector<Node>;

std::string joints_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " joint" : " joints");
}

/// Returns the first names of a list and how many more there are.
std::string names_of(const Nodes& nodes, const std::vector<std::size_t>& which, std::size_t shown) {
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, which.size()); ++i)
    text += (i == 0 ? "" : ", ") + nodes[which[i]].name;
  if (which.size() > shown) text += " and " + std::to_string(which.size() - shown) + " more";
  return text;
}

/// Nodes that a moving joint separates from the base, in the order of the file.
std::vector<std::size_t> moved_by(const Nodes& nodes, std::size_t base) {
  std::vector<std::size_t> result;
  std::vector<std::pair<std::size_t, bool>> open{{base, false}};
  while (!open.empty()) {
    const auto [node, moves] = open.back();
    open.pop_back();
    if (moves) result.push_back(node);
    for (const std::size_t child : nodes[node].children)
      open.emplace_back(child, moves || nodes[child].moves);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// As many joints as arms have that reach any pose.
bool is_usual(std::size_t joints) { return joints == 6 || joints == 7; }

/// Arms first, those of six or seven joints before others, then the longest.
bool is_likelier(const Limb& a, const Limb& b) {
  const auto usual = [](const Limb& limb) { return is_usual(limb.joints) || is_usual(limb.own); };
  if (a.kind != b.kind) return a.kind < b.kind;
  if (usual(a) != usual(b)) return usual(a);
  return a.joints > b.joints;
}

/// Returns the link behind the last joint on the way to a link that no chain can have, or none.
std::size_t floating_base(const Nodes& nodes, std::size_t base, std::size_t link) {
  for (; link != base; link = nodes[link].parent)
    if (nodes[link].floats) return link;
  return Node::none;
}

/// Returns how many joints a chain to the end of a limb has, from behind what floats.
std::size_t usable_joints(const Nodes& nodes, std::size_t base, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t link = end; link != base && !nodes[link].floats; link = nodes[link].parent)
    count += nodes[link].moves ? 1 : 0;
  return count;
}

/// Returns the link on which the own joints of a limb hang if with a torso's they are too many: those alone
/// are a usual arm, or all together are more than a description may have. Else none.
std::size_t shoulder_of(const Nodes& nodes, std::size_t base, const Limb& limb) {
  const std::size_t all = usable_joints(nodes, base, limb.end);
  if (all <= 7 || (!is_usual(limb.own) && all <= max_joints)) return Node::none;
  std::size_t link = limb.end;
  for (std::size_t joints = 0; link != base && joints < limb.own; link = nodes[link].parent)
    joints += nodes[link].moves ? 1 : 0;
  return link;
}

std::string described(const Nodes& nodes, std::size_t base, const Limb& limb) {
  static constexpr const char* kinds[]{"arm, ", "leg, ", "", "head, ", ""};
  std::string text = nodes[frame_of(nodes, limb.end)].name + " (" + kinds[limb.kind] +
                     joints_text(usable_joints(nodes, base, limb.end));
  if (const std::size_t shoulder = shoulder_of(nodes, base, limb); shoulder != Node::none)
    text += ", " + std::to_string(limb.own) + " of them behind " + nodes[shoulder].name;
  if (!limb.fingers.empty()) text += ", without its fingers " + names_of(nodes, limb.fingers, 2);
  return text + ")";
}

/// As a word of a shell's command line.
std::string shell_word(const std::string& text) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-./+:@,=").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// The command that takes a chain: from `from` if there is such a link, else from behind what floats.
std::string command(const Context& context, const Nodes& nodes, std::size_t root, std::size_t tip,
                    std::size_t from = Node::none) {
  if (from == Node::none) from = floating_base(nodes, root, tip);
  const std::string& named = from == Node::none ? context.options.base : nodes[from].name;
  const std::string base = named.empty() ? "" : " --base " + shell_word(named);
  return "qvgen check " + shell_word(context.source.file()) + base + " --tip " + shell_word(nodes[tip].name);
}

void report_limbs(Context& context, const Nodes& nodes, std::size_t base, std::vector<Limb> limbs) {
  static constexpr std::size_t shown = 8;
  std::stable_sort(limbs.begin(), limbs.end(), is_likelier);
  std::vector<std::size_t> wheels;
  std::string list;
  std::size_t listed = 0;
  for (const Limb& limb : limbs) {
    if (limb.kind == Limb::wheel)
      wheels.push_back(limb.end);
    else if (++listed <= shown)
      list += (listed == 1 ? "" : ", ") + described(nodes, base, limb);
  }
  if (listed > shown) list += " and " + std::to_string(listed - shown) + " more";
  if (!wheels.empty())
    list += (listed == 0 ? "" : "; besides ") + std::to_string(wheels.size()) + " wheels or rotors (" +
            names_of(nodes, wheels, 4) + ")";
  context.error({}, "the chain may end at " + list,
                "say where: " + command(context, nodes, base, frame_of(nodes, limbs.front().end),
                                        shoulder_of(nodes, base, limbs.front())));
}

/// True if another limb is an arm as good as the one that has the tip: a name alone does not choose between
/// two.
bool has_rival(const Nodes& nodes, const std::vector<Limb>& limbs, std::size_t tip) {
  const std::size_t end = carrier_of(nodes, tip);
  const auto chosen =
      std::find_if(limbs.begin(), limbs.end(), [&](const Limb& limb) { return limb.end == end; });
  return chosen != limbs.end() && std::any_of(limbs.begin(), limbs.end(), [&](const Limb& limb) {
           return limb.end != end && limb.kind == Limb::arm && limb.own >= 4 && limb.own + 1 >= chosen->own;
         });
}

void note_frame(Context& context, const Nodes& nodes, std::size_t end, std::size_t tip) {
  std::vector<std::size_t> others = fixed_ends(nodes, end);
  if (others.size() < 2) return;
  std::erase(others, tip);
  context.note(nodes[tip].place, "the chain ends at '" + nodes[tip].name + "'",
               "fixed to the same link: " + names_of(nodes, others, 8) + "; --tip names another");
}

/// Says that the last joint is taken for one of the arm though it only moves a finger.
void note_finger(Context& context, const Nodes& nodes, std::size_t base, std::size_t end) {
  const std::size_t before =
      nodes[end].parent == Node::none ? Node::none : carrier_of(nodes, nodes[end].parent);
  if (before == Node::none || !is_finger(nodes[end]) || !path_between(nodes, {base, before})) return;
  const std::string joint = nodes[end].joint.empty() ? nodes[end].name : nodes[end].joint;
  context.note(nodes[end].place,
               "the last joint '" + joint + "' moves a finger, by its name; it counts as a joint of the arm",
               "leave it out: " + command(context, nodes, base, frame_of(nodes, before)));
}

}  // namespace

std::optional<std::size_t> likely_tip(Context& context, const Nodes& nodes, std::size_t base) {
  const auto moved = moved_by(nodes, base);
  if (moved.empty()) {
    context.error(nodes[base].place, "no joint between " + nodes[base].name + " and the tips moves",
                  "an arm has at least one revolute, continuous or prismatic joint");
    return std::nullopt;
  }
  const std::vector<Limb> limbs = limbs_of(nodes, base);
  const std::size_t named = named_tip(nodes, moved, false);
  if (named != Node::none && !has_rival(nodes, limbs, named)) return named;
  const bool has_hand = !limbs.front().fingers.empty();
  if (limbs.size() > 1 || limbs.front().fingers.size() > 1) {
    report_limbs(context, nodes, base, limbs);
    return std::nullopt;
  }
  const std::size_t end = has_hand ? limbs.front().fingers.front() : limbs.front().end;
  const std::size_t tip = frame_of(nodes, end);
  note_frame(context, nodes, end, tip);
  note_finger(context, nodes, base, end);
  return tip;
}

}  // namespace qvgen::description::tree
