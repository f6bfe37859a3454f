// Least squares by modified Gram-Schmidt, and columns that depend on the others.

/// A least-squares problem's columns.
typedef struct Columns {
  int count, rows;
  double of[most_joints][most_rows];
} Columns;

typedef struct Steps {
  double by[most_joints];
} Steps;

static double sum_of_products(const double* a, const double* b, int size) {
  if (size % 2 == 0) {
    // As two numbers in a register.
    double even = a[0] * b[0], odd = a[1] * b[1];
    for (int i = 2; i < size; i += 2) {
      even += a[i] * b[i];
      odd += a[i + 1] * b[i + 1];
    }
    return even + odd;
  }
  double sum = 0;
  for (int i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

/// Takes a column's direction out of v and returns how much of the column that was; `scale` is 1 / its
/// square.
static double take_out(const double* column, double scale, double* v, int rows) {
  const double share = sum_of_products(column, v, rows) * scale;
  for (int i = 0; i < rows; ++i) v[i] += -share * column[i];
  return share;
}

/// The x for which the columns' combination comes nearest to b, by modified Gram-Schmidt. A column that adds
/// less than `nothing`, as a share of the longest, is left out: a free joint stays. Uses up columns and b.
static Steps least_squares(Columns* a, double* b, double nothing) {
  double longest = 0;
  for (int i = 0; i < a->count; ++i) longest = larger(longest, sum_of_products(a->of[i], a->of[i], a->rows));
  double r[most_joints][most_joints] = {{0}};
  Steps x = {{0}};
  for (int i = 0; i < a->count; ++i) {
    const double square = sum_of_products(a->of[i], a->of[i], a->rows);
    if (!(square > nothing * nothing * longest)) continue;
    r[i][i] = square;
    const double scale = 1 / square;
    for (int j = i + 1; j < a->count; ++j) r[i][j] = take_out(a->of[i], scale, a->of[j], a->rows);
    x.by[i] = take_out(a->of[i], scale, b, a->rows);
  }
  for (int i = a->count; i-- > 0;)
    for (int j = i + 1; j < a->count && r[i][i] > 0; ++j) x.by[i] -= r[i][j] * x.by[j];
  return x;
}

/// The columns that add less than a share of the longest to the others, and the one that adds least.
typedef struct Dependent {
  Held columns;
  int least;      // as many as there are: none
  double square;  // of what that one adds
} Dependent;

/// Always takes the longest of what is left. Uses up the columns.
static Dependent dependent(Columns* a) {
  const double nothing = tolerance_idle;
  Dependent result;
  for (int i = 0; i < a->count; ++i) result.columns.is[i] = true;
  result.square = 0;
  double limit = 0;
  for (int taken = 0; taken < a->count; ++taken) {
    int longest = a->count;
    double square[most_joints] = {0};
    result.least = a->count;
    for (int i = 0; i < a->count; ++i) {
      if (!result.columns.is[i]) continue;
      square[i] = sum_of_products(a->of[i], a->of[i], a->rows);
      if (longest == a->count || square[i] > square[longest]) longest = i;
      if (result.least == a->count || square[i] <= square[result.least]) result.least = i;
    }
    if (longest == a->count || result.least == a->count) break;
    limit = larger(limit, nothing * nothing * square[longest]);
    if (!(square[longest] > limit)) {
      result.square = square[result.least];
      return result;
    }
    result.columns.is[longest] = false;
    const double scale = 1 / square[longest];
    for (int i = 0; i < a->count; ++i)
      if (result.columns.is[i]) take_out(a->of[longest], scale, a->of[i], a->rows);
  }
  result.least = a->count;
  return result;
}
