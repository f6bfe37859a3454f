// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/mjcf_model.h"

/// Contents of a body once <frame>, <replicate> and <attach> are written out. Nothing is copied: each element
/// comes with the frames around it and with what its names are extended by.
namespace qvgen::description::xml {

/// A frame around elements of a body: a <frame>, or a copy of a <replicate>.
struct Around {
  std::shared_ptr<const Around> outer;  ///< or none
  const MjcfModel* model = nullptr;
  const Element* element = nullptr;
  long copy = 0;          ///< of a <replicate>, from 0
  std::size_t depth = 1;  ///< how many there are, this one included
};

/// More copies in a row, or frames in frames, than any robot has; each costs a few milliseconds.
inline constexpr long max_copies = 1000;
inline constexpr std::size_t max_frames = 32;

struct Placed {
  const Element* element = nullptr;
  const MjcfModel* model = nullptr;  ///< whose settings and classes count
  std::shared_ptr<const Around> around = nullptr;
  std::string childclass = {};  ///< of the bodies and frames around it
  std::string prefix = {}, suffix = {};

  /// The element's name as MuJoCo has it; empty if it has none.
  [[nodiscard]] std::string name() const;
  /// The element with everything that it inherits.
  [[nodiscard]] Element completed(Context& context) const;
};

class MjcfContents {
 public:
  explicit MjcfContents(Context& context) : context_(&context) {}
  /// Everything in a <body> or <worldbody> but what it is written out of, in the order of the file.
  [[nodiscard]] std::vector<Placed> of(const Placed& body);

 private:
  void add(const Element& holder, const Placed& around, std::vector<Placed>& all);
  [[nodiscard]] std::shared_ptr<const Around> within(const Placed& frame, long copy);
  void add_frame(const Placed& frame, std::vector<Placed>& all);
  void add_copies(const Placed& replicate, std::vector<Placed>& all);
  void add_attached(const Placed& attach, std::vector<Placed>& all);
  [[nodiscard]] std::optional<Placed> find(const Placed& holder, const std::string& kind,
                                           const std::string& name);
  [[nodiscard]] bool within_bounds(const Element& element);
  [[nodiscard]] long copies(const Element& replicate);

  Context* context_;
  std::size_t elements_ = 0, depth_ = 0;
  bool refused_ = false;
};

}  // namespace qvgen::description::xml
