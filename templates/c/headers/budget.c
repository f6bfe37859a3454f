// The budget of passes and steps: budget.h of the C++ library, whose Effort the robot's header has.

/// How often a pose may be worked at: counted, so that the bound holds by construction.
typedef struct Budget {
  int passes;
  int steps;
  Effort spent;
} Budget;

static bool take_of_budget(int* spent, int most, int* used_up) {
  if (*spent >= most) {
    *spent = most;
    *used_up = 1;
    return false;
  }
  *spent += 1;
  return true;
}

static bool may_pass(Budget* budget) {
  return take_of_budget(&budget->spent.passes, budget->passes, &budget->spent.used_up);
}

static bool may_step(Budget* budget) {
  return take_of_budget(&budget->spent.steps, budget->steps, &budget->spent.used_up);
}
