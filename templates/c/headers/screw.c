// Joints at the zero pose and the points that they carry. Directions and points change in place.

static inline void cross(const double* a, const double* b, double* result) {
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];
  result[2] = a[0] * b[1] - a[1] * b[0];
  result[0] = x;
  result[1] = y;
}

static inline double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static inline void difference(const double* a, const double* b, double* result) {
  for (int k = 0; k < 3; ++k) result[k] = a[k] - b[k];
}

static inline void set_triple(double* triple, double x, double y, double z) {
  triple[0] = x;
  triple[1] = y;
  triple[2] = z;
}

/// A joint at the zero pose: unit axis and, for a revolute one, a point on it.
typedef struct Screw {
  bool revolute;
  double axis[3], point[3];
} Screw;

/// A direction turned about a revolute joint's axis, in place.
static void turn_direction(const Screw* screw, Rotor value, double* v) {
  double side[3];
  cross(screw->axis, v, side);
  const double along = dot(screw->axis, v) * (1 - value.cosine);
  for (int k = 0; k < 3; ++k) v[k] = value.cosine * v[k] + value.sine * side[k] + along * screw->axis[k];
}

/// A point carried by a joint, in place. Value of a joint: an angle as its pair, a length in the cosine's
/// place.
static void move_point(const Screw* screw, Rotor value, double x[3]) {
  if (screw->revolute) {
    difference(x, screw->point, x);
    turn_direction(screw, value, x);
  }
  for (int k = 0; k < 3; ++k) x[k] += screw->revolute ? screw->point[k] : screw->axis[k] * value.cosine;
}
