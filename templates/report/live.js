// The arm that is moved by hand.

class Live extends ByHand {
  constructor(arm) {
    super();
    this.arm = arm;
    this.joints = arm.data.joints;
    this.q = arm.data.start.slice();
    this.found = { verdict: "none", rows: [] };
    this.note = "";
    const signs = document.getElementById("branch-signs");
    this.signs = arm.armAngle ? armAngleSigns : signs ? JSON.parse(signs.textContent) : [];
    const canvas = document.getElementById("live-canvas");
    this.camera = new Camera(arm.data.size);
    const points = [[0, 0, 0], ...arm.skeleton(this.q).points];
    this.camera.centre = extent(points, this.camera.right, this.camera.up).centre;
    this.view = new View(canvas, this.camera);
    this.all = document.getElementById("live-all");
    this.hold = document.getElementById("live-hold");
    this.addControls();
    this.moveTo(this.q);
    listen(this, canvas);
  }

  addControls() {
    const at = (id) => document.getElementById(id);
    const { arm, joints } = this;
    const sliders = jointSliders(at("live-joints"), joints, (i, value) => this.moveJoint(i, value));
    this.showJoints = sliders.show;
    const { given, size } = arm.data;
    const strip = given >= 0 && !arm.armAngle;
    this.showFeasible = strip ? feasibleStrip(sliders.row(given), joints[given]) : () => {};
    this.ring = arm.armAngle && new ArmAngleRing(at("live-ring"), (psi) => this.moveElbow(psi));
    this.showTarget = targetInputs(at("live-target"), (target) => this.moveTarget(target));
    const names = [...arm.data.measures, "manipulability"];
    this.measures = (q) => [...arm.measures(q), arm.manipulability(q)];
    this.largest = largestOf(joints, this.measures);
    this.measureNames = names;
    this.showMeasures = measureList(at("live-measures"), names, this.largest);
    this.showSolutions = solutionTable(at("live-solutions"), joints, (branch) => branchName(this.signs, branch), (i) => this.choose(i));
    this.gallery = new Gallery(at("live-gallery"), size, (i) => this.choose(i));
    assumedLimits(at("live-limits"), joints, () => {
      this.drawn = null;
      this.redraw();
    });
  }

  /// All solutions of a target: with an arm angle, that of the joints if none is said, or with the seed's value of
  /// the joint that is given.
  solutions(target, seed, psi) {
    if (!this.arm.armAngle) return this.arm.solutions(target, seed);
    return this.arm.solutionsAt(target, psi ?? this.psi ?? this.arm.armAngle(seed), seed);
  }

  /// The arm to joint values; the target goes with it.
  moveTo(q) {
    this.q = q.slice();
    this.target = this.arm.pose(this.q);
    this.psi = this.arm.armAngle?.(this.q);
    this.found = this.solutions(this.target, this.q);
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
    if (!this.arm.armAngle) return this.accept(found);
    this.psi = this.arm.armAngle(found.rows[0].q);
    this.accept(this.solutions(this.target, found.rows[0].q));
  }

  /// The null motion: the elbow turns, the tool stands.
  moveElbow(psi) {
    const found = this.solutions(this.target, this.q, psi);
    if (found.rows.length === 0) return;
    const branch = this.found.rows[this.chosen()]?.branch;
    const same = found.rows.findIndex((row) => row.branch === branch);
    this.psi = psi;
    this.found = found;
    this.note = "";
    this.q = unwound(this.joints, found.rows[Math.max(same, 0)].q, this.q);
    this.redraw();
  }

  moveTarget(target) {
    this.target = target;
    const found = this.solutions(target, this.q);
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

  /// Over the range of the joint that is given: whether some solution within limits has that value. Of an arm angle
  /// the generated functions know the intervals.
  feasible() {
    const { given } = this.arm.data;
    if (this.drawn === this.target) return;
    this.drawn = this.target;
    if (this.ring) this.intervals = this.arm.intervals(this.target);
    if (given < 0 || this.ring) return;
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

  status(measured) {
    const { rows, verdict } = this.found;
    if (this.note) return this.note;
    const small = this.measureNames.filter((_, i) => Math.abs(measured[i]) < littleShare * this.largest[i]);
    const near = small.length ? ["nearly singular: " + small.join(", ")] : [];
    if (!this.arm.data.inverse) return near.join("");
    const number = rows.length === 1 ? "1 solution" : `${rows.length} solutions`;
    return [number + (verdict === "solved" ? "" : ", " + verdict), ...meetings(this.signs, this.joints, rows), ...near].join("; ");
  }

  readColours() {
    super.readColours();
    this.gallery.readColours();
  }

  draw() {
    const chosen = this.chosen();
    const { rows } = this.found;
    const skeletons = rows.map((row) => this.arm.skeleton(row.q));
    const arm = this.arm.skeleton(this.q);
    this.view.clear();
    if (this.held < 0) this.camera.keep([arm, ...skeletons].flatMap(({ points }) => points).concat(this.view.handles(this.target)));
    this.view.ground();
    if (this.all.checked) {
      const ghosts = skeletons.map((skeleton, i) => ({ skeleton, name: String(rows[i].branch) }));
      this.view.ghosts(ghosts.filter((_, i) => i !== chosen));
    }
    this.view.arm(arm);
    this.view.target(this.target, this.held);
    this.showPanel(chosen);
    const named = skeletons.map((skeleton, i) => ({ skeleton, name: `${rows[i].branch}: ${branchName(this.signs, rows[i].branch)}`.replace(/: $/, "") }));
    this.gallery.show(named, chosen, this.camera);
  }

  showPanel(chosen) {
    const { rows } = this.found;
    this.showJoints(this.q);
    this.showTarget(this.target);
    this.feasible();
    if (this.ring) {
      const branch = rows[Math.max(chosen, 0)]?.branch ?? 0;
      this.ring.show(this.psi, this.intervals, branch, branchName(this.signs, branch));
    }
    const measured = this.measures(this.q);
    this.showMeasures(measured);
    this.showSolutions(rows, chosen);
    const text = this.status(measured);
    const place = document.getElementById("live-status");
    if (place.textContent !== text) place.textContent = text;
  }

  handleAt(place) {
    return this.nearestHandle(this.view.handles(this.target), place, grip)[0];
  }
}

const liveData = document.getElementById("live-data");
if (liveData) {
  loadArm(JSON.parse(liveData.textContent)).then((arm) => {
    document.getElementById("live").hidden = false;
    window.live = new Live(arm);
  });
}
