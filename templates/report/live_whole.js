// The whole robot moved by hand: a dragged tip is followed by its limb's inverse kinematics; where the base floats it
// is dragged too, and tips stay in place as far as limbs reach. Limbs compute in the base's frame.

const inverseMotion = ({ r, p }) => ({ r: transposed(r), p: scaled(-1, rotated(transposed(r), p)) });

/// A skeleton of the base's frame in the world.
const placedSkeleton = (base, { points, joints, tool }) => {
  const at = (point) => add(rotated(base.r, point), base.p);
  return {
    points: points.map(at),
    joints: joints.map((joint) => ({ ...joint, point: at(joint.point), moved: at(joint.moved), axis: rotated(base.r, joint.axis) })),
    tool: compose(base, tool),
  };
};

/// A limb with its places among all joints, and how it follows a target.
class Limb {
  constructor(arm, { tip, places, by_position: byPosition }) {
    Object.assign(this, { arm, tip, places, byPosition });
    this.handles = byPosition ? 1 : 4;
  }
  own(q) {
    return this.places.map((place) => q[place]);
  }
  gap(a, b) {
    const away = norm(subtract(a.p, b.p));
    return this.byPosition ? away : away + norm(turnVector(product(a.r, transposed(b.r))));
  }
  solutions(target, seed) {
    return (this.byPosition ? this.arm.positions(target, seed) : this.arm.solutions(target, seed)).rows;
  }
  /// Joint values for a target, from those before: a solution, else as near as Newton's steps lead. `still`: which of the
  /// limb's joints other limbs have moved already.
  followed(target, before, still) {
    const rows = still.some(Boolean) ? [] : this.solutions(target, before);
    if (rows.length > 0) return unwound(this.arm.data.joints, rows[0].q, before);
    return this.arm.follow(target, before, this.byPosition ? 0 : this.arm.data.size / 3, still);
  }
}

class LiveWhole extends ByHand {
  constructor(data, arms) {
    super();
    this.data = data;
    this.limbs = arms.map((arm, i) => new Limb(arm, data.limbs[i]));
    this.joints = data.joints.map(([limb, place]) => arms[limb].data.joints[place]);
    this.q = data.joints.map(([limb, place]) => arms[limb].data.start[place]);
    this.base = { r: identity(), p: [0, 0, 0] };
    this.chosen = 0;  // the limb that is dragged, -1: the base
    const canvas = document.getElementById("live-canvas");
    const points = this.skeletons().flatMap((skeleton) => skeleton.points);
    this.camera = new Camera(1);
    const { centre, wide, high } = extent(points, this.camera.right, this.camera.up);
    Object.assign(this.camera, { centre, size: Math.max(wide, high) });
    this.view = new View(canvas, this.camera);
    this.view.radius *= 0.6;  // a whole robot has more joints than an arm
    this.all = document.getElementById("live-all");
    this.showJoints = jointSliders(document.getElementById("live-joints"), this.joints, (i, value) => this.moveJoint(i, value)).show;
    this.carryTargets();
    listenToHand(this, canvas);
    this.redraw();
  }

  get arm() {
    return this.limbs[Math.max(this.chosen, 0)].arm;
  }
  get target() {
    return this.chosen < 0 ? this.base : this.targets[this.chosen];
  }
  tip(limb) {
    return compose(this.base, limb.arm.pose(limb.own(this.q)));
  }
  skeletons() {
    return this.limbs.map((limb) => placedSkeleton(this.base, limb.arm.skeleton(limb.own(this.q))));
  }
  /// The targets to where the tips are.
  carryTargets() {
    this.targets = this.limbs.map((limb) => this.tip(limb));
  }

  moveJoint(i, value) {
    this.q[i] = value;
    this.carryTargets();
    this.redraw();
  }

  moveTarget(target) {
    if (this.chosen < 0) this.base = target;
    else this.targets[this.chosen] = target;
    this.reach();
    this.redraw();
  }

  /// Each limb to its target, the dragged one first; joints that several limbs share are the first one's.
  reach() {
    const moved = new Set();
    const order = this.limbs.map((_, i) => i).sort((a, b) => (b === this.chosen) - (a === this.chosen));
    for (const i of order) {
      const limb = this.limbs[i];
      if (limb.gap(this.tip(limb), this.targets[i]) > 1e-12) {
        const still = limb.places.map((place) => moved.has(place));
        const local = compose(inverseMotion(this.base), this.targets[i]);
        limb.followed(local, limb.own(this.q), still).forEach((value, k) => (this.q[limb.places[k]] = value));
      }
      limb.places.forEach((place) => moved.add(place));
    }
  }

  /// The limbs whose tips are not where they should be.
  missed() {
    return this.limbs.filter((limb, i) => limb.gap(this.tip(limb), this.targets[i]) > 1e-6 * limb.arm.data.size);
  }

  /// The handles of each target, and of the base, by the limb's place, -1 for the base.
  heldPlaces() {
    const places = this.limbs.map((limb, i) => [i, this.view.handles(this.targets[i]).slice(0, limb.handles)]);
    return this.data.floating ? [...places, [-1, this.view.handles(this.base)]] : places;
  }

  handleAt(place) {
    let held = -1, least = grip;
    for (const [index, handles] of this.heldPlaces()) {
      const [k, distance] = this.nearestHandle(handles, place, least);
      if (k >= 0) [held, least, this.chosen] = [k, distance, index];
    }
    return held;
  }

  draw() {
    const skeletons = this.skeletons();
    this.view.clear();
    if (this.held < 0) this.camera.keep(skeletons.flatMap(({ points }) => points).concat(this.heldPlaces().flatMap(([, points]) => points)));
    this.view.ground();
    if (this.all.checked) this.drawOthers();
    skeletons.forEach((skeleton) => this.view.arm(skeleton));
    this.limbs.forEach((limb, i) => {
      this.view.line([this.tip(limb).p, this.targets[i].p], this.view.colour.accent, 1.5, [2, 3]);
      this.view.target(this.targets[i], i === this.chosen ? this.held : -1, limb.handles);
    });
    if (this.data.floating) this.view.target(this.base, this.chosen < 0 ? this.held : -1);
    this.showJoints(this.q);
    const missed = this.missed().map((limb) => limb.tip);
    const text = missed.length ? `out of reach: ${missed.join(", ")}` : "all tips are in place";
    const place = document.getElementById("live-status");
    if (place.textContent !== text) place.textContent = text;
  }

  /// The chosen limb's other solutions.
  drawOthers() {
    const limb = this.limbs[this.chosen];
    if (!limb) return;
    const own = limb.own(this.q);
    const rows = limb.solutions(compose(inverseMotion(this.base), this.target), own);
    const others = rows.filter((row) => apart(limb.arm.data.joints, row.q, own) > 1e-6);
    this.view.ghosts(others.map((row) => ({ skeleton: placedSkeleton(this.base, limb.arm.skeleton(row.q)), name: String(row.branch) })));
  }
}

const wholeData = document.getElementById("live-whole-data");
if (wholeData) {
  const data = JSON.parse(wholeData.textContent);
  Promise.all(data.limbs.map((limb) => loadArm(limb.arm))).then((arms) => {
    document.getElementById("live").hidden = false;
    window.live = new LiveWhole(data, arms);
  });
}
