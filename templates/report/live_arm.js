// The robot's generated functions behind a plain face. Joint values in rad and m, motions as { r, p }.

const verdicts = ["solved", "singular", "unreachable", "invalid", "incomplete"];

const wrapped = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

/// The largest difference of two joint vectors, whole turns apart or not.
const apart = (joints, a, b) =>
  Math.max(...joints.map((joint, i) => Math.abs(joint.revolute ? wrapped(a[i] - b[i]) : a[i] - b[i])));

/// Angles whole turns away, as near to those before as the joints' ranges allow.
function unwound(joints, q, before) {
  return q.map((value, i) => {
    if (!joints[i].revolute) return value;
    const near = before[i] + wrapped(value - before[i]);
    return near >= joints[i].lower && near <= joints[i].upper ? near : value;
  });
}

/// The functions of a module, and its places for numbers that go in and out.
async function loadModule(text, geometry) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const { instance } = await WebAssembly.instantiate(bytes, { math: Math });
  const calls = instance.exports;
  calls._initialize?.();
  const at = (address, count) => new Float64Array(calls.memory.buffer, address, count);
  at(calls.geometry(), geometry.length).set(geometry);
  return {
    calls,
    give: (values) => at(calls.arguments(), values.length).set(values),
    put: (values) => at(calls.results(), values.length).set(values),
    take: (count) => Array.from(at(calls.results(), count)),
    rows(count, size) {
      const all = this.take(count * size);
      return Array.from({ length: count }, (_, i) => all.slice(i * size, (i + 1) * size));
    },
  };
}

/// The functions of C; those that are generated in C++ alone, where the page has them.
function rawFunctions(data, c, cpp) {
  const dof = data.joints.length;
  const numbers = (name, count) => (q) => {
    c.give(q);
    c.calls[name]();
    return c.take(count);
  };
  const none = { verdict: "none", rows: [] };
  /// Rows of joints, branch, and whether a joint was free; the nearest to the seed first.
  const solved = (module, name) => (pose, seed, value) => {
    if (!module?.calls[name]) return none;
    module.give([...pose, ...seed]);
    const count = module.calls[name](value);
    return { verdict: verdicts[module.calls.status()], rows: module.rows(count, dof + 2) };
  };
  const raw = {
    pose: numbers("pose", 7),
    jacobian: numbers("jacobian", 6 * dof),
    measures: c.calls.measures ? numbers("measures", data.measures.length) : () => [],
    solutions: solved(c.calls.solutions ? c : cpp, "solutions"),
    positions: solved(c, "positions"),
    solutionsAtArmAngle: solved(cpp, "solutions_at_arm_angle"),
  };
  if (!cpp?.calls.arm_angle) return raw;
  raw.armAngle = (q) => {
    cpp.give(q);
    return cpp.calls.arm_angle();
  };
  /// Rows of lower, upper, branch; `limits` has lower and upper of each joint in turn.
  raw.armAngleIntervals = (pose, limits) => {
    cpp.give(pose);
    cpp.put(limits);
    return cpp.rows(cpp.calls.arm_angle_intervals(), 3);
  };
  return raw;
}

async function loadArm(data) {
  const c = await loadModule(data.module, data.geometry);
  const cpp = data.cpp && (await loadModule(data.cpp, data.geometry));
  const raw = rawFunctions(data, c, cpp);
  const dof = data.joints.length;

  const pose = (q) => {
    const values = raw.pose(q);
    return { r: rotationOf(values), p: values.slice(4) };
  };
  const jacobian = (q) => {
    const values = raw.jacobian(q);
    return Array.from({ length: 6 }, (_, row) => values.slice(row * dof, (row + 1) * dof));
  };
  const numbersOf = (target) => [...quaternionOf(target.r), ...target.p];
  const named = ({ verdict, rows }) => ({
    verdict,
    rows: rows.map((row) => ({ q: row.slice(0, dof), branch: row[dof], free: row[dof + 1] !== 0 })),
  });
  /// With the seed's value of the joint that is given, if one is.
  const solutions = (target, seed) => named(raw.solutions(numbersOf(target), seed, data.given < 0 ? 0 : seed[data.given]));
  /// Those that bring the tool to the target's position, however it is turned.
  const positions = (target, seed) => named(raw.positions(numbersOf(target), seed, 0));
  const arm = { data, dof, raw, pose, jacobian, measures: raw.measures, solutions, positions, ...numerics(data, pose, jacobian) };
  if (!raw.armAngle) return arm;
  arm.armAngle = raw.armAngle;
  arm.solutionsAt = (target, psi, seed) => named(raw.solutionsAtArmAngle(numbersOf(target), seed, psi));
  arm.intervals = (target) => {
    const limits = data.joints.flatMap((joint) => (joint.limited ? [joint.lower, joint.upper] : [-Infinity, Infinity]));
    return raw.armAngleIntervals(numbersOf(target), limits).map(([lower, upper, branch]) => ({ lower, upper, branch }));
  };
  return arm;
}

/// Solves a symmetric positive definite system by Cholesky's factors.
function solved(matrix, right) {
  const n = right.length;
  const l = matrix.map((row) => row.slice());
  for (let j = 0; j < n; ++j) {
    for (let k = 0; k < j; ++k) l[j][j] -= l[j][k] ** 2;
    l[j][j] = Math.sqrt(Math.max(l[j][j], 1e-300));
    for (let i = j + 1; i < n; ++i) {
      for (let k = 0; k < j; ++k) l[i][j] -= l[i][k] * l[j][k];
      l[i][j] /= l[j][j];
    }
  }
  const y = right.slice();
  for (let i = 0; i < n; ++i) {
    for (let k = 0; k < i; ++k) y[i] -= l[i][k] * y[k];
    y[i] /= l[i][i];
  }
  for (let i = n - 1; i >= 0; --i) {
    for (let k = i + 1; k < n; ++k) y[i] -= l[k][i] * y[k];
    y[i] /= l[i][i];
  }
  return { x: y, determinant: l.reduce((all, row, i) => all * row[i] ** 2, 1) };
}

/// Computes the numbers of a page from the pose and its Jacobian.
function numerics(data, pose, jacobian) {
  const count = data.joints.length;
  /// Yoshikawa's measure: the root of det(J J^T), or of det(J^T J) where there are fewer joints than rows.
  const manipulability = (q) => {
    const j = jacobian(q);
    const vectors = count >= 6 ? j : j[0].map((_, k) => j.map((row) => row[k]));
    const gram = vectors.map((a) => vectors.map((b) => a.reduce((sum, value, i) => sum + value * b[i], 0)));
    return Math.sqrt(Math.max(solved(gram, vectors.map(() => 0)).determinant, 0));
  };

  /// As near to the target as damped least squares lead from q within the joints' ranges. `turning`: the way that a
  /// turn of a radian is worth, 0 for positions alone; `still`: which joints stay.
  const follow = (target, q, turning = data.size / 3, still = []) => {
    let at = q.slice();
    const length = data.size;
    for (let step = 0; step < 40; ++step) {
      const now = pose(at);
      const error = [...subtract(target.p, now.p), ...scaled(turning, turnVector(product(target.r, transposed(now.r))))];
      const miss = Math.hypot(...error);
      if (miss < 1e-10 * length) break;
      const j = jacobian(at).map((row, i) => row.map((value, k) => (still[k] ? 0 : i < 3 ? value : value * turning)));
      const damping = Math.min(miss * 0.02 * length, 1e-2 * length * length) + 1e-12;
      const gram = at.map((_, a) => at.map((__, b) => j.reduce((sum, row) => sum + row[a] * row[b], a === b ? damping : 0)));
      const way = solved(gram, at.map((_, a) => j.reduce((sum, row, i) => sum + row[a] * error[i], 0))).x;
      const most = Math.max(...way.map(Math.abs));
      const share = Math.min(1, 0.4 / most);
      at = at.map((value, i) => {
        const { lower, upper } = data.joints[i];
        return Math.min(Math.max(value + share * way[i], lower), upper);
      });
    }
    return at;
  };

  /// The values of all joints: those that follow others too.
  const chain = data.chain ?? data.joints;
  const following = (q) => {
    let next = 0;
    const all = chain.map((joint) => (joint.follows ? 0 : q[next++]));
    return chain.map((joint, i) => (joint.follows ? joint.follows[1] * all[joint.follows[0]] : all[i]));
  };

  /// The points between joints, and each joint's own point and axis, in the world.
  const skeleton = (q) => {
    const values = following(q);
    const points = [];
    const joints = [];
    let at = { r: identity(), p: [0, 0, 0] };
    const go = (way) => {
      for (const axis of [2, 0, 1]) {
        if (Math.abs(way.p[axis]) < 1e-12) continue;
        const from = points.length === 0 ? at.p : points[points.length - 1];
        if (points.length === 0) points.push(from);
        points.push(add(from, scaled(way.p[axis], column(at.r, axis))));
      }
      at = compose(at, way);
    };
    go(data.base);
    chain.forEach((joint, i) => {
      go(joint.before);
      const axis = rotated(at.r, joint.axis);
      const point = at.p;
      if (joint.revolute) at = { r: product(at.r, turnAbout(joint.axis, values[i])), p: at.p };
      else at = { r: at.r, p: add(at.p, scaled(values[i], axis)) };
      joints.push({ point, axis, moved: at.p, revolute: joint.revolute });
      if (!joint.revolute) points.push(at.p);
      go(joint.after);
    });
    go(data.tool);
    return { points, joints, tool: at };
  };

  return { manipulability, follow, skeleton };
}
