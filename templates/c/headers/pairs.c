// Sums and products of columns in the order of pairs.h, where two numbers share a register.

/// Numbers that say where a pose is, as a position and a turn.
enum { most_coordinates = 6 };

/// Numbers of a column: as many as its least squares have rows.
typedef struct Vector {
  double of[most_rows];
} Vector;

static double sum_of_products(int rows, const Vector* a, const Vector* b) {
  if (rows % 2 == 0) {
    double even = a->of[0] * b->of[0], odd = a->of[1] * b->of[1];
    for (int i = 2; i < rows; i += 2) {
      even += a->of[i] * b->of[i];
      odd += a->of[i + 1] * b->of[i + 1];
    }
    return even + odd;
  }
  double sum = 0;
  for (int i = 0; i < rows; ++i) sum += a->of[i] * b->of[i];
  return sum;
}

/// v + factor a
static void add_multiple(int rows, double factor, const Vector* a, Vector* v) {
  for (int i = 0; i < rows; ++i) v->of[i] += factor * a->of[i];
}
