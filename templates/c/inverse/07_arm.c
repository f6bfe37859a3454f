// Helpers of Newton's steps besides what headers of the C++ library say.

/// A difference of angles, rad, less the whole turns that bring it into [-pi, pi].
static inline double without_turns(double difference) {
  const double turn = constant_whole_turn;
  return difference - turn * nearest_whole(difference * (1 / turn));
}

static const Held nothing_held = {{false}};

static Patience patience(double allowed) {
  const Patience usual = {allowed, 3, 0.5};
  return usual;
}
