// The arm that is moved by hand.

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

class Live {
  constructor(arm) {
    this.arm = arm;
    this.joints = arm.data.joints;
    this.q = arm.data.start.slice();
    this.found = { verdict: "none", rows: [] };
    this.note = "";
    this.held = -1;
    const canvas = document.getElementById("live-canvas");
    this.camera = new Camera(arm.data.size);
    this.camera.centre = [0, 0, 0.32 * arm.data.size];
    this.view = new View(canvas, this.camera);
    this.all = document.getElementById("live-all");
    this.hold = document.getElementById("live-hold");
    const sliders = jointSliders(document.getElementById("live-joints"), this.joints, (i, value) => this.moveJoint(i, value));
    this.showJoints = sliders.show;
    const { given } = arm.data;
    this.showFeasible = given < 0 ? () => {} : feasibleStrip(sliders.row(given), this.joints[given]);
    this.showTarget = targetInputs(document.getElementById("live-target"), (target) => this.moveTarget(target));
    this.showMeasures = measureList(document.getElementById("live-measures"), arm.data.measures);
    this.showSolutions = solutionTable(document.getElementById("live-solutions"), this.joints, (i) => this.choose(i));
    this.moveTo(this.q);
    this.listen(canvas);
  }

  /// The arm to joint values; the target goes with it.
  moveTo(q) {
    this.q = q.slice();
    this.target = this.arm.pose(this.q);
    this.found = this.arm.solutions(this.target, this.q);
    this.note = "";
    this.redraw();
  }

  moveJoint(i, value) {
    const q = this.q.slice();
    q[i] = value;
    if (i !== this.arm.data.given || !this.hold?.checked) return this.moveTo(q);
    // The tool stands: the other joints make room for this one.
    const found = this.arm.solutions(this.target, q);
    if (found.rows.length === 0) {
      this.note = `with ${this.joints[i].name} at ${jointText(this.joints[i], value)} the tool cannot stay`;
      return this.redraw();
    }
    this.accept(found);
  }

  moveTarget(target) {
    this.target = target;
    const found = this.arm.solutions(target, this.q);
    if (found.rows.length > 0) return this.accept(found);
    this.q = this.arm.follow(target, this.q);
    const reached = this.arm.pose(this.q);
    const miss = norm(subtract(reached.p, target.p)) + norm(turnVector(product(reached.r, transposed(target.r))));
    if (miss < 1e-6) return this.moveTo(this.q);
    this.found = { ...found, rows: [] };
    this.note = "out of reach: the arm stands near it";
    this.redraw();
  }

  accept(found) {
    this.found = found;
    this.q = unwound(this.joints, found.rows[0].q, this.q);
    this.note = "";
    this.redraw();
  }

  choose(index) {
    const row = this.found.rows[index];
    this.q = unwound(this.joints, row.q, this.q);
    this.redraw();
  }

  /// The row at which the arm stands, -1 if none.
  chosen() {
    return this.found.rows.findIndex((row) => apart(this.joints, row.q, this.q) < 1e-6);
  }

  /// Over the range of the joint that is given: whether some solution within limits has that value.
  feasible() {
    const { given } = this.arm.data;
    if (given < 0 || this.drawn === this.target) return;
    this.drawn = this.target;
    const { lower, upper } = this.joints[given];
    const count = 120;
    const good = Array.from({ length: count }, (_, i) => {
      const seed = this.q.slice();
      seed[given] = lower + ((i + 0.5) / count) * (upper - lower);
      const { rows } = this.arm.solutions(this.target, seed);
      return rows.some((row) => row.q.every((value, k) => value >= this.joints[k].lower - 1e-9 && value <= this.joints[k].upper + 1e-9));
    });
    this.showFeasible(good);
  }

  status() {
    const { rows, verdict } = this.found;
    if (this.note) return this.note;
    if (!this.arm.data.inverse) return "";
    const meeting = [];
    rows.forEach((a, i) => rows.slice(i + 1).forEach((b) => {
      if (apart(this.joints, a.q, b.q) < 0.05) meeting.push(`branches ${a.branch} and ${b.branch} meet`);
    }));
    const number = rows.length === 1 ? "1 solution" : `${rows.length} solutions`;
    return [number + (verdict === "solved" ? "" : ", " + verdict), ...meeting].join("; ");
  }

  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    const chosen = this.chosen();
    this.view.clear();
    this.view.ground();
    if (this.all.checked) {
      const others = this.found.rows.filter((row, i) => i !== chosen);
      this.view.ghosts(others.map((row) => ({ skeleton: this.arm.skeleton(row.q), name: String(row.branch) })));
    }
    this.view.arm(this.arm.skeleton(this.q));
    this.view.target(this.target, this.held);
    this.showJoints(this.q);
    this.showTarget(this.target);
    this.feasible();
    this.showMeasures([...this.arm.measures(this.q), this.arm.manipulability(this.q)]);
    this.showSolutions(this.found.rows, chosen);
    const text = this.status();
    const place = document.getElementById("live-status");
    if (place.textContent !== text) place.textContent = text;
  }

  listen(canvas) {
    let last = null;
    const at = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      last = at(event);
      this.held = this.handleAt(last);
      canvas.setPointerCapture(event.pointerId);
      this.redraw();
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!last) return;
      const now = at(event);
      this.drag(now, now[0] - last[0], now[1] - last[1]);
      last = now;
    });
    const release = () => {
      last = null;
      this.held = -1;
      this.redraw();
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    canvas.addEventListener("keydown", (event) => this.key(event));
    this.all.addEventListener("change", () => this.redraw());
    document.getElementById("live-zero").addEventListener("click", () =>
      this.moveTo(this.joints.map(({ lower, upper }) => Math.min(Math.max(0, lower), upper))));
    document.getElementById("live-start").addEventListener("click", () => this.setStart());
    document.getElementById("live-play").addEventListener("click", () => this.play());
    new ResizeObserver(() => this.redraw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.view.readColours();
      this.redraw();
    });
  }

  handleAt([x, y]) {
    let best = -1, least = 14;
    this.view.handles(this.target).forEach((point, k) => {
      const [hx, hy] = this.camera.place(point);
      const distance = Math.hypot(hx - x, hy - y) + (k === 0 ? 0 : 1);
      if (distance < least) [best, least] = [k, distance];
    });
    return best;
  }

  drag(now, dx, dy) {
    if (this.held < 0) {
      this.camera.turn(0.008 * dx, 0.008 * dy);
      return this.redraw();
    }
    if (this.held === 0) return this.moveTarget({ r: this.target.r, p: add(this.target.p, this.camera.way(dx, dy)) });
    this.moveTarget({ r: this.turnedTo(now), p: this.target.p });
  }

  /// The target's rotation with the held axis pointing to a place of the picture.
  turnedTo([x, y]) {
    const axis = column(this.target.r, this.held - 1);
    const length = 5 * this.view.radius;
    const [bx, by] = this.camera.place(this.target.p);
    const flat = this.camera.way(x - bx, y - by);
    const rest = length * length - dot(flat, flat);
    const depth = rest > 0 ? Math.sqrt(rest) * (this.camera.depth(axis) < 0 ? -1 : 1) : 0;
    const wanted = unit(add(flat, scaled(depth, this.camera.toward)));
    return product(turnFromTo(axis, wanted), this.target.r);
  }

  key(event) {
    const ways = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, -1, 0], ArrowDown: [0, 1, 0], PageUp: [0, 0, -1], PageDown: [0, 0, 1] };
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    if (event.shiftKey) {
      this.camera.turn(0.1 * way[0], 0.1 * way[1]);
      return this.redraw();
    }
    const step = 0.01 * this.arm.data.size;
    const flat = add(scaled(step * way[0], this.camera.right), scaled(-step * way[1], this.camera.up));
    this.moveTarget({ r: this.target.r, p: add(this.target.p, add(flat, scaled(step * way[2], this.camera.toward))) });
  }

  setStart() {
    this.start = { target: this.target, q: this.q.slice() };
    this.note = "path from here: move the target to its end, then play";
    this.redraw();
  }

  /// Leads the target straight from the start to where it is, the arm from the start's joints; says whether it
  /// stays on its branch.
  play() {
    if (!this.start) return this.setStart();
    const end = this.target;
    const { target: from, q } = this.start;
    this.q = q.slice();
    this.found = this.arm.solutions(from, q);
    const branch = this.found.rows[0]?.branch;
    let left = "";
    const steps = 120;
    const step = (i) => {
      const before = this.q;
      this.moveTarget(between(from, end, i / steps));
      const row = this.found.rows[0];
      const jump = apart(this.joints, before, this.q) > 0.35;
      if (!left && (!row || row.branch !== branch || jump))
        left = `${row ? (jump ? "jumps" : "leaves branch " + branch) : "gets out of reach"} at ${Math.round((100 * i) / steps)} %`;
      if (i < steps) return requestAnimationFrame(() => step(i + 1));
      this.note = "path: " + (left || "stays on branch " + branch);
      this.redraw();
    };
    step(0);
  }
}

const liveData = document.getElementById("live-data");
if (liveData) {
  loadArm(JSON.parse(liveData.textContent)).then((arm) => {
    document.getElementById("live").hidden = false;
    window.live = new Live(arm);
  });
}
