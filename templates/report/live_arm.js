// The robot's generated functions behind a plain face. Joint values in rad and m, motions as { r, p }.

const verdicts = ["solved", "singular", "unreachable", "invalid", "incomplete"];

async function loadArm(data) {
  const bytes = Uint8Array.from(atob(data.module), (letter) => letter.charCodeAt(0));
  const { instance } = await WebAssembly.instantiate(bytes, { math: Math });
  const calls = instance.exports;
  const dof = data.joints.length;
  const at = (address, count) => new Float64Array(calls.memory.buffer, address, count);
  const give = (values, offset = 0) => at(calls.arguments(), offset + values.length).set(values, offset);
  const take = (count) => Array.from(at(calls.results(), count));
  at(calls.geometry(), data.geometry.length).set(data.geometry);

  const raw = {
    pose(q) {
      give(q);
      calls.pose();
      return take(7);
    },
    jacobian(q) {
      give(q);
      calls.jacobian();
      return take(6 * dof);
    },
    measures(q) {
      if (!calls.measures) return [];
      give(q);
      calls.measures();
      return take(data.measures.length);
    },
    /// Rows of joints, branch, and whether a joint was free; the nearest to the seed first.
    solutions(pose, seed, given) {
      if (!calls.solutions) return { verdict: "none", rows: [] };
      give([...pose, ...seed]);
      const count = calls.solutions(given);
      const all = take(count * (dof + 2));
      const rows = Array.from({ length: count }, (_, i) => all.slice(i * (dof + 2), (i + 1) * (dof + 2)));
      return { verdict: verdicts[calls.status()], rows };
    },
  };

  const pose = (q) => {
    const values = raw.pose(q);
    return { r: rotationOf(values), p: values.slice(4) };
  };

  const jacobian = (q) => {
    const values = raw.jacobian(q);
    return Array.from({ length: 6 }, (_, row) => values.slice(row * dof, (row + 1) * dof));
  };

  const solutions = (target, seed) => {
    const values = [...quaternionOf(target.r), ...target.p];
    const { verdict, rows } = raw.solutions(values, seed, data.given < 0 ? 0 : seed[data.given]);
    return {
      verdict,
      rows: rows.map((row) => ({ q: row.slice(0, dof), branch: row[dof], free: row[dof + 1] !== 0 })),
    };
  };

  return { data, dof, raw, pose, jacobian, measures: raw.measures, solutions, ...numerics(data, pose, jacobian) };
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

/// What a page computes from the pose and its Jacobian.
function numerics(data, pose, jacobian) {
  const count = data.joints.length;
  /// Yoshikawa's measure: the root of det(J J^T), or of det(J^T J) where there are fewer joints than rows.
  const manipulability = (q) => {
    const j = jacobian(q);
    const vectors = count >= 6 ? j : j[0].map((_, k) => j.map((row) => row[k]));
    const gram = vectors.map((a) => vectors.map((b) => a.reduce((sum, value, i) => sum + value * b[i], 0)));
    return Math.sqrt(Math.max(solved(gram, vectors.map(() => 0)).determinant, 0));
  };

  /// As near to the target as damped least squares lead from q within the joints' ranges.
  const follow = (target, q) => {
    let at = q.slice();
    const length = data.size;
    for (let step = 0; step < 40; ++step) {
      const now = pose(at);
      const error = [...subtract(target.p, now.p), ...scaled(length / 3, turnVector(product(target.r, transposed(now.r))))];
      const miss = Math.hypot(...error);
      if (miss < 1e-10 * length) break;
      const j = jacobian(at).map((row, i) => (i < 3 ? row : row.map((value) => (value * length) / 3)));
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

  /// The points between joints, and each joint's own point and axis, in the world.
  const skeleton = (q) => {
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
    data.joints.forEach((joint, i) => {
      go(joint.before);
      const axis = rotated(at.r, joint.axis);
      const point = at.p;
      if (joint.revolute) at = { r: product(at.r, turnAbout(joint.axis, q[i])), p: at.p };
      else at = { r: at.r, p: add(at.p, scaled(q[i], axis)) };
      joints.push({ point, axis, moved: at.p, revolute: joint.revolute });
      if (!joint.revolute) points.push(at.p);
      go(joint.after);
    });
    go(data.tool);
    return { points, joints, tool: at };
  };

  return { manipulability, follow, skeleton };
}
