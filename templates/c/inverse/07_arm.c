// Helpers of Newton's steps besides what headers of the C++ library say.

static const Held nothing_held = {{false}};

static Patience patience(double allowed) {
  const Patience usual = {allowed, 3, 0.5};
  return usual;
}
