// SPDX-License-Identifier: MIT
#include "report/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "report/html.h"
#include "report/view.h"

namespace qvgen::report {
namespace {

/// A chain at joint values.
struct Placed {
  const Chain& chain;
  std::vector<double> q;
};

/// Something drawn, in the world, with its distance from the reader.
struct Shape {
  std::string style;
  std::vector<std::vector<Vector>> parts;  ///< outline by hull of the first; others as they are
  bool outline = false;
  double depth = 0;
  int layer = 1;
};

struct Label {
  Vector at;
  std::string text;
  std::string style;
};

struct Box {
  double left, top, right, bottom;
  [[nodiscard]] bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

class Picture {
 public:
  Picture(double width, double height, double line, const Sight& sight = {})
      : view_(sight), width_(width), height_(height), line_(line) {}

  void line(const std::string& style, const Vector& from, const Vector& to, int layer = 0) {
    shapes_.push_back({style, {{from, to}}, false, 0, layer});
  }
  /// A prism with its near end drawn over it.
  void solid(const std::string& style, const std::vector<Vector>& corners, const Vector& axis) {
    const std::size_t half = corners.size() / 2;
    const bool second_is_near = axis.dot(view_.toward()) > 0;
    const auto middle = corners.begin() + static_cast<std::ptrdiff_t>(half);
    std::vector<Vector> end = second_is_near ? std::vector<Vector>(middle, corners.end())
                                             : std::vector<Vector>(corners.begin(), middle);
    Vector centre = Vector::Zero();
    for (const Vector& corner : corners) centre += corner / static_cast<double>(corners.size());
    shapes_.push_back({style, {corners, end}, true, view_.depth(centre)});
  }
  void label(const Vector& at, const std::string& text, const std::string& style) {
    labels_.push_back({at, text, style});
  }

  [[nodiscard]] const View& view() const { return view_; }

  /// Makes the picture no higher than what is in it.
  void crop() {
    fit();
    height_ = std::min(height_, content_height_ + 0.15 * width_);  // and names above and below
  }

  std::string svg(const Caption& caption) {
    fit();
    // Lines lie behind solids, so that links end at joints; the tool's frame lies before all.
    std::stable_sort(shapes_.begin(), shapes_.end(), [](const Shape& a, const Shape& b) {
      return std::pair(a.layer, a.layer == 1 ? a.depth : 0) < std::pair(b.layer, b.layer == 1 ? b.depth : 0);
    });
    std::string body;
    for (const Shape& shape : shapes_) body += text_of(shape);
    for (const Shape& shape : shapes_) occupy(shape);
    for (const Label& label : labels_) body += text_of(label);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" viewBox=\"0 0 {} {}\" role=\"img\" "
        "aria-labelledby=\"{}-title {}-text\">\n"
        "<title id=\"{}-title\">{}</title>\n<desc id=\"{}-text\">{}</desc>\n{}</svg>\n",
        coordinate(width_), coordinate(height_), caption.id, caption.id, caption.id, escaped(caption.title),
        caption.id, escaped(caption.description), body);
  }

 private:
  void fit() {
    constexpr double most = std::numeric_limits<double>::max();
    Box box{most, most, -most, -most};
    for (const Shape& shape : shapes_)
      for (const auto& part : shape.parts)
        for (const Vector& v : part) {
          const Point p = view_.project(v);
          box = {std::min(box.left, p[0]), std::min(box.top, p[1]), std::max(box.right, p[0]),
                 std::max(box.bottom, p[1])};
        }
    const double margin = 0.1 * width_;
    const double wide = std::max(box.right - box.left, 1e-9);
    const double high = std::max(box.bottom - box.top, 1e-9);
    scale_ = std::min((width_ - 2 * margin) / wide, (height_ - margin) / high);
    content_height_ = scale_ * high;
    shift_ = {width_ / 2 - scale_ * (box.left + box.right) / 2,
              height_ / 2 - scale_ * (box.top + box.bottom) / 2};
  }

  [[nodiscard]] Point place(const Vector& v) const {
    const Point p = view_.project(v);
    return {scale_ * p[0] + shift_[0], scale_ * p[1] + shift_[1]};
  }

  [[nodiscard]] std::vector<Point> places(const std::vector<Vector>& list) const {
    std::vector<Point> points;
    for (const Vector& v : list) points.push_back(place(v));
    return points;
  }

  static std::string path(const std::vector<Point>& points, bool closed, const std::string& style) {
    std::string d;
    for (const Point& p : points) d += (d.empty() ? "M" : " L") + coordinate(p[0]) + " " + coordinate(p[1]);
    return "<path class=\"" + style + "\" d=\"" + d + (closed ? "Z" : "") + "\"/>\n";
  }

  [[nodiscard]] std::string text_of(const Shape& shape) const {
    if (!shape.outline) return path(places(shape.parts.front()), false, shape.style);
    return path(hull(places(shape.parts.front())), true, shape.style) +
           path(places(shape.parts.back()), true, shape.style + " end");
  }

  void occupy(const Shape& shape) {
    const std::vector<Point> points = places(shape.parts.front());
    if (shape.style == "axis") return;
    if (!shape.outline) {  // a line, piece by piece
      for (int i = 0; i <= 12; ++i) {
        const double t = i / 12.0;
        const double x = points[0][0] + t * (points[1][0] - points[0][0]);
        const double y = points[0][1] + t * (points[1][1] - points[0][1]);
        taken_.push_back({x - 2, y - 2, x + 2, y + 2});
      }
      return;
    }
    Box box{width_, height_, 0, 0};
    for (const Point& p : points)
      box = {std::min(box.left, p[0]), std::min(box.top, p[1]), std::max(box.right, p[0]),
             std::max(box.bottom, p[1])};
    taken_.push_back(box);
  }

  [[nodiscard]] bool is_free(const Box& box) const {
    return box.left > 0 && box.top > 0 && box.right < width_ && box.bottom < height_ &&
           std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return box.meets(other); });
  }

  /// Beside what it names, where nothing else stands; left out if there is no such place.
  std::string text_of(const Label& label) {
    const Point at = place(label.at);
    const double wide = 0.52 * line_ * static_cast<double>(letters_in(label.text));
    for (const double far : {0.6, 1.3, 2.2, 3.2})
      for (const auto& [x, y] : {Point{1, 0}, Point{-1, 0}, Point{0.6, -0.8}, Point{0.6, 0.8},
                                 Point{-0.6, -0.8}, Point{-0.6, 0.8}, Point{0, -1}, Point{0, 1}}) {
        const double cx = at[0] + x * (far * line_ + wide / 2);
        const double cy = at[1] + y * (far * line_ + line_ / 2);
        const Box box{cx - wide / 2, cy - 0.55 * line_, cx + wide / 2, cy + 0.55 * line_};
        if (!is_free(box)) continue;
        taken_.push_back(box);
        return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                           label.style, coordinate(cx), coordinate(cy + 0.33 * line_), escaped(label.text));
      }
    return "";
  }

  View view_;
  double width_, height_, line_;
  double scale_ = 1, content_height_ = 0;
  Point shift_{};
  std::vector<Shape> shapes_;
  std::vector<Label> labels_;
  std::vector<Box> taken_;
};

/// Joints whose symbols would stand at one point move apart along their axes, as textbooks draw wrists.
std::vector<Vector> symbol_places(const Posture& posture, double radius) {
  const std::size_t count = posture.joints.size();
  std::vector<Vector> places;
  for (const auto& joint : posture.joints) places.push_back(joint.point);
  for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
    end = begin + 1;
    while (end < count && (places[end] - places[begin]).norm() < radius) ++end;
    const Vector point = places[begin];
    const Vector before = begin == 0 ? Vector(Vector::Zero()) : places[begin - 1];
    const Vector behind = end < count ? posture.joints[end].point : Vector(posture.tool.translation());
    const double middle = (static_cast<double>(end - begin) - 1) / 2;
    for (std::size_t i = begin; i < end; ++i) {
      const Vector& axis = posture.joints[i].axis;
      const double way = static_cast<double>(i - begin) - middle;
      const double sense = axis.dot(behind - before) < -1e-9 ? -1 : 1;
      places[i] = point + (3.2 * radius * way * sense) * axis;
    }
  }
  return places;
}

void draw_joint(Picture& picture, const ChainJoint& joint, const Posture::Joint& placed, const Vector& at,
                double radius) {
  picture.line("axis", at - (2.6 * radius) * placed.axis, at + (2.6 * radius) * placed.axis);
  if ((at - placed.point).norm() > 1e-9) picture.line("link", placed.point, at);
  if (joint.revolute) {
    picture.solid("turn", prism(at, placed.axis, radius, 1.1 * radius, 28), placed.axis);
    return;
  }
  if ((placed.moved - placed.point).norm() > 1e-9) picture.line("slide-way", placed.point, placed.moved);
  picture.solid("slide", prism(at, placed.axis, 1.05 * radius, 1.3 * radius, 4), placed.axis);
}

/// Axes in the styles NAME-x, NAME-y, NAME-z.
void draw_frame(Picture& picture, const std::string& name, const Motion& frame, double size) {
  const char* ends[] = {"-x", "-y", "-z"};
  for (int axis = 0; axis < 3; ++axis)
    picture.line(name + ends[axis], frame.translation(),
                 frame.translation() + size * frame.linear().col(axis), 2);
}

void draw_ground(Picture& picture, double radius) {
  std::vector<Vector> plate = prism({0, 0, -0.2 * radius}, {0, 0, 1}, 2.2 * radius, 0.2 * radius, 4);
  picture.solid("ground", plate, {0, 0, 1});
}

/// The joints' symbols or frames, with their names where they are wanted. `drawn`: joints that other limbs
/// have drawn.
void draw_joints(Picture& picture, const Chain& chain, const Posture& posture, const Caption& caption,
                 double radius, std::set<std::string>& drawn) {
  const std::vector<Vector> places = symbol_places(posture, radius);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    if (!drawn.insert(chain.joints[i].variable).second) continue;
    const Posture::Joint& joint = posture.joints[i];
    if (caption.frames)
      draw_frame(picture, "frame", joint.frame, 2.4 * radius);
    else
      draw_joint(picture, chain.joints[i], joint, places[i], radius);
    if (!caption.names) continue;
    const std::string name = caption.frames ? std::to_string(i + 1) : typeset(chain.joints[i].variable);
    picture.label(caption.frames ? joint.moved : places[i], name, "joint-name");
  }
}

std::string picture_of(const std::vector<Placed>& limbs, const Caption& caption, double width,
                       double height) {
  double size = 0;
  for (const Placed& each : limbs) size = std::max(size, size_of(each.chain));
  const double radius = 0.03 * size;
  Picture picture(width, height, 13);
  draw_ground(picture, radius);
  std::set<std::string> drawn;
  for (const auto& [chain, q] : limbs) {
    const Posture posture = posture_of(chain, q);
    for (const auto& leg : posture.legs)
      picture.line(caption.frames ? "link pale" : "link", leg.from, leg.to);
    draw_joints(picture, chain, posture, caption, radius, drawn);
    draw_frame(picture, "tool", posture.tool, 3.2 * radius);
    if (caption.names && !caption.frames && limbs.size() == 1)
      for (const auto& leg : posture.legs) picture.label(0.5 * (leg.from + leg.to), leg.name, "leg-name");
  }
  return picture.svg(caption);
}

std::string picture_of(const Linkage& linkage, const std::vector<double>& q, const Caption& caption,
                       double width, double height) {
  const PlacedLinkage at = placed(linkage, q);
  const Sight sight = sight_of(linkage, at);
  const double radius = symbol_radius(at, sight);
  Picture picture(width, height, 13, sight);
  for (const PlacedLinkage::Line& line : at.lines)
    picture.line(line.is_base ? "link pale" : "link", line.from, line.to);
  for (std::size_t i = 0; i < at.joints.size(); ++i) {
    draw_joint(picture, linkage.chain.joints[i], at.joints[i], at.joints[i].point, radius);
    if (caption.names)
      picture.label(at.joints[i].point, typeset(linkage.chain.joints[i].variable), "joint-name");
  }
  for (const Vector& end : at.ties) {
    const Vector& toward = picture.view().toward();
    picture.solid("tie", prism(end + radius * toward, toward, 0.4 * radius, 0, 12), toward);
  }
  for (const Motion& tip : at.tips) draw_frame(picture, "tool", tip, 3.2 * radius);
  if (caption.names) picture.crop();
  return picture.svg(caption);
}

/// Limbs with joint values in which most arms look like arms; joints that they share have one value.
std::vector<Placed> bent(const std::vector<Chain>& limbs) {
  std::map<std::string, double> values;
  std::vector<Placed> placed;
  for (const Chain& limb : limbs) {
    std::vector<double> q = bent_pose(limb);
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] = values.emplace(limb.joints[i].variable, q[i]).first->second;
    placed.push_back({limb, following(limb, q)});
  }
  return placed;
}

}  // namespace

std::string drawing(const Chain& chain, const std::vector<double>& q, const Caption& caption) {
  return picture_of({{chain, q}}, caption, 460, 400);
}

std::string drawing(const std::vector<Chain>& limbs, const Caption& caption) {
  return picture_of(bent(limbs), caption, 460, 400);
}

std::string drawing(const Linkage& linkage, const std::vector<double>& q, const Caption& caption) {
  return picture_of(linkage, q, caption, 460, 400);
}

std::string thumbnail(const Linkage& linkage, const std::vector<double>& q, const Caption& caption) {
  Caption plain = caption;
  plain.names = false;
  return picture_of(linkage, q, plain, 220, 190);
}

std::string thumbnail(const std::vector<Chain>& limbs, const Caption& caption) {
  Caption plain = caption;
  plain.names = false;
  return picture_of(bent(limbs), plain, 220, 190);
}

}  // namespace qvgen::report
