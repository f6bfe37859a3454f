// A mechanism with closed loops moved by hand: sliders give its motors, a dragged tip is followed by them, and the mechanism
// stays on its assembly as far as there is one. The picture is computed from the description, the joints by generated code.

/// Places the parts of a linkage: its joints, the lines of its links, rods, and the points of its ties.
function placedLinkage(data, q) {
  const links = [];
  const frame = (link) => (link < 0 ? data.base : links[link]);
  const joints = data.joints.map((joint, i) => {
    const at = compose(frame(data.parents[i]), joint.before);
    const axis = rotated(at.r, joint.axis);
    const moved = joint.revolute
      ? { r: product(at.r, turnAbout(joint.axis, q[i])), p: at.p }
      : { r: at.r, p: add(at.p, scaled(q[i], axis)) };
    links.push(compose(moved, joint.after));
    return { point: at.p, axis, moved: moved.p, revolute: joint.revolute };
  });
  const lines = [], base = [];
  const carry = (link, point) => (link < 0 ? base.push(point) : lines.push([joints[link].moved, point]));
  joints.forEach((joint, i) => {
    carry(data.parents[i], joint.point);
    if (!joint.revolute) lines.push([joint.point, joint.moved]);
  });
  const ties = data.ties.map(({ links: pair, points }) =>
    pair.map((link, k) => {
      const { r, p } = frame(link);
      const point = add(rotated(r, points[k]), p);
      carry(link, point);
      return point;
    }),
  );
  data.ties.forEach(({ apart: way }, i) => way && lines.push(ties[i]));
  const tips = data.tips.map(({ link, placement }) => compose(frame(link), placement));
  data.tips.forEach(({ link }, i) => carry(link, tips[i].p));
  return { joints, lines, base, ties, tips };
}

/// The generated functions of a mechanism behind a plain face.
async function loadLinkage(data) {
  const c = await loadModule(data.module, data.geometry);
  const dof = data.joints.length, count = data.driven.length;
  const numbers = (name, size) => (q) => {
    c.give([...data.driven.map((i) => q[i]), ...q]);
    c.calls[name]();
    return c.take(size);
  };
  /// The assembly next to joints q for values of the motors, or null.
  const follow = (motors, q) => {
    c.give([...motors, ...q]);
    return c.calls.follow() ? c.take(dof) : null;
  };
  /// All assemblies, the nearest to joints q first.
  const assemble = (motors, q) => {
    if (!c.calls.assemble) return [];
    c.give([...motors, ...q]);
    return c.rows(c.calls.assemble(), dof + 3).map((row) => ({ q: row.slice(0, dof), branch: row[dof], free: row[dof + 1] !== 0, meets: row[dof + 2] !== 0 }));
  };
  const tips = data.tips.map(({ name }) => {
    if (!c.calls["pose_of_" + name]) return null;
    const pose = numbers("pose_of_" + name, 7), jacobian = numbers("jacobian_of_" + name, 6 * count);
    return {
      pose: (q) => {
        const values = pose(q);
        return { r: rotationOf(values), p: values.slice(4) };
      },
      jacobian: (q) => {
        const values = jacobian(q);
        return Array.from({ length: 6 }, (_, row) => values.slice(row * count, (row + 1) * count));
      },
    };
  });
  return { data, dof, follow, assemble, tips, motors: (q) => data.driven.map((i) => q[i]) };
}

/// As near to a place of a tip as damped least squares lead the motors, along one assembly.
function draggedTo(linkage, tip, place, from) {
  const { data } = linkage;
  let q = from;
  for (let step = 0; step < 25; ++step) {
    const error = subtract(place, tip.pose(q).p);
    const miss = norm(error);
    if (miss < 1e-10 * data.size) break;
    const j = tip.jacobian(q).slice(0, 3);
    const damping = Math.min(miss * 0.02 * data.size, 1e-2 * data.size * data.size) + 1e-12;
    const motors = linkage.motors(q);
    const gram = motors.map((_, a) => motors.map((__, b) => j.reduce((sum, row) => sum + row[a] * row[b], a === b ? damping : 0)));
    const way = solved(gram, motors.map((_, a) => j.reduce((sum, row, i) => sum + row[a] * error[i], 0))).x;
    const share = Math.min(1, 0.2 / Math.max(...way.map(Math.abs), 1e-300));
    const next = linkage.follow(motors.map((value, a) => kept(data.joints[data.driven[a]], value + share * way[a])), q);
    if (!next || !(norm(subtract(place, tip.pose(next).p)) < miss)) break;
    q = next;
  }
  return q;
}

const kept = ({ lower, upper }, value) => Math.min(Math.max(value, lower), upper);

class LiveLoops extends ByHand {
  constructor(linkage) {
    super();
    this.linkage = linkage;
    this.data = linkage.data;
    this.arm = linkage;  // its size is that of steps by keys
    this.q = this.data.start;
    this.chosen = linkage.tips.findIndex(Boolean);
    this.note = "";
    const canvas = document.getElementById("live-canvas");
    this.camera = new Camera(1, this.data.sight);
    const { centre, wide, high } = extent(this.points(placedLinkage(this.data, this.q)), this.camera.right, this.camera.up);
    Object.assign(this.camera, { centre, size: Math.max(wide, high) || 1 });
    this.view = new View(canvas, this.camera);
    this.view.radius = this.data.radius;
    this.all = document.getElementById("live-all");
    this.list = document.getElementById("live-assemblies");
    const driven = this.data.driven.map((i) => this.data.joints[i]);
    this.showMotors = jointSliders(document.getElementById("live-joints"), driven, (i, value) => this.moveMotor(i, value)).show;
    listenToHand(this, canvas);
    this.redraw();
  }

  /// The tip that was dragged last; the middle of the picture where there is none.
  get target() {
    return this.linkage.tips[this.chosen]?.pose(this.q) ?? { r: identity(), p: this.camera.centre };
  }
  points({ joints, lines, tips, base }) {
    return [...joints.map(({ point }) => point), ...lines.flat(), ...tips.map(({ p }) => p), ...base];
  }

  /// Takes a motor to a value: along the assembly, else to the nearest one that there is.
  moveMotor(i, value) {
    const motors = this.linkage.motors(this.q);
    motors[i] = value;
    const next = this.linkage.follow(motors, this.q) ?? this.linkage.assemble(motors, this.q)[0]?.q;
    this.note = next ? "" : "it cannot be assembled with the motors there";
    if (next) this.q = next;
    this.redraw();
  }

  moveTarget({ p }) {
    if (this.chosen < 0) return;
    this.q = draggedTo(this.linkage, this.linkage.tips[this.chosen], p, this.q);
    const away = norm(subtract(p, this.target.p));
    this.note = away > 1e-6 * this.data.size ? "the tip does not get there" : "";
    this.redraw();
  }

  /// Balls of tips alone are held: a tip is dragged by its place.
  handleAt(place) {
    let held = -1, least = grip;
    this.linkage.tips.forEach((tip, i) => {
      if (!tip) return;
      const [k, distance] = this.nearestHandle([tip.pose(this.q).p], place, least);
      if (k >= 0) [held, least, this.chosen] = [k, distance, i];
    });
    return held;
  }

  draw() {
    const own = placedLinkage(this.data, this.q);
    const found = this.linkage.assemble(this.linkage.motors(this.q), this.q);
    const others = this.all.checked ? found.slice(1).map(({ q }) => placedLinkage(this.data, q)) : [];
    this.view.clear();
    if (this.held < 0) this.camera.keep([own, ...others].flatMap((each) => this.points(each)));
    this.view.ground();
    for (const { lines } of others) lines.forEach((line) => this.view.line(line, this.view.colour.soft, 1.1));
    own.base.slice(1).forEach((point, i) => this.view.line([own.base[i], point], this.view.colour.line, 3));
    own.lines.forEach((line) => this.view.line(line, this.view.colour.ink, 2.5));
    this.view.symbols(own.joints, own.joints.map(({ point }) => point));
    own.ties.flat().forEach((point) => this.view.dot(point));
    this.linkage.tips.forEach((tip, i) => tip && this.view.target(tip.pose(this.q), i === this.chosen ? this.held : -1, 1));
    this.showMotors(this.linkage.motors(this.q));
    this.showAssemblies(found);
  }

  /// A button for each assembly; the present one is pressed.
  showAssemblies(found) {
    const same = found.findIndex(({ q }) => apart(this.data.joints, q, this.q) < 1e-6);
    const text = this.note || (found.length ? `${found.length} ${found.length === 1 ? "assembly" : "assemblies"}${found.some(({ meets }) => meets) ? ", of which some meet" : ""}` : "");
    const status = document.getElementById("live-status");
    if (status.textContent !== text) status.textContent = text;
    const order = found.map((_, i) => i).sort((a, b) => found[a].branch - found[b].branch);
    this.list.replaceChildren(...order.map((i) => {
      const button = element("button", { type: "button", textContent: String(found[i].branch) });
      button.setAttribute("aria-pressed", String(i === same));
      button.addEventListener("click", () => {
        this.q = found[i].q;
        this.note = "";
        this.redraw();
      });
      return button;
    }));
  }
}

const loopsData = typeof document === "undefined" ? null : document.getElementById("live-loops-data");
if (loopsData) {
  loadLinkage(JSON.parse(loopsData.textContent)).then((linkage) => {
    document.getElementById("live").hidden = false;
    window.live = new LiveLoops(linkage);
  });
}
