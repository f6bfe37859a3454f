// Moves by hand: pointer, keys, buttons, and paths that it starts.

/// A picture that is dragged. Subclasses have `view`, `camera`, `target`, `moveTarget`, `handleAt` and `draw`.
class ByHand {
  held = -1;  // 0: the target's ball, 1 to 3: the tip of an axis

  redraw() {
    drawAtNextFrame(this);
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

  /// Which of the target's handles is at a place of the picture, and how far away, if nearer than `least`.
  nearestHandle(handles, [x, y], least) {
    let best = -1;
    handles.forEach((point, k) => {
      const [hx, hy] = this.camera.place(point);
      const distance = Math.hypot(hx - x, hy - y) + (k === 0 ? 0 : 1);
      if (distance < least) [best, least] = [k, distance];
    });
    return [best, least];
  }

  readColours() {
    this.view.readColours();
  }
}

/// How near to a handle the pointer takes hold of it, in pixels.
const grip = 14;

function listenToHand(live, canvas) {
  let last = null;
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  canvas.addEventListener("pointerdown", (event) => {
    last = at(event);
    live.held = live.handleAt(last);
    canvas.setPointerCapture(event.pointerId);
    live.redraw();
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!last) return;
    const now = at(event);
    live.drag(now, now[0] - last[0], now[1] - last[1]);
    last = now;
  });
  const release = () => {
    last = null;
    live.held = -1;
    live.redraw();
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("keydown", (event) => pressed(live, event));
  live.all.addEventListener("change", () => live.redraw());
  new ResizeObserver(() => live.redraw()).observe(canvas);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    live.readColours();
    live.redraw();
  });
}

function listen(live, canvas) {
  listenToHand(live, canvas);
  const path = {};
  const click = (id, action) => document.getElementById(id).addEventListener("click", action);
  click("live-zero", () => live.moveTo(live.joints.map(({ lower, upper }) => Math.min(Math.max(0, lower), upper))));
  click("live-start", () => setStart(live, path));
  click("live-play", () => (path.q ? play(live, path) : setStart(live, path)));
}

function pressed(live, event) {
  const ways = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, -1, 0], ArrowDown: [0, 1, 0], PageUp: [0, 0, -1], PageDown: [0, 0, 1] };
  const way = ways[event.key];
  if (!way) return;
  event.preventDefault();
  const { camera, target } = live;
  if (event.shiftKey) {
    camera.turn(0.1 * way[0], 0.1 * way[1]);
    return live.redraw();
  }
  const step = 0.01 * live.arm.data.size;
  const flat = add(scaled(step * way[0], camera.right), scaled(-step * way[1], camera.up));
  live.moveTarget({ r: target.r, p: add(target.p, add(flat, scaled(step * way[2], camera.toward))) });
}

function setStart(live, path) {
  Object.assign(path, { target: live.target, q: live.q.slice(), psi: live.psi });
  live.note = "path from here: move the target to its end, then play";
  live.redraw();
}

/// Why the arm that has come from joints before is not on its branch any more; empty if it is.
function departure(live, before, branch) {
  const row = live.found.rows[0];
  if (!row) return live.arm.data.inverse ? "gets out of reach" : "";
  if (apart(live.joints, before, live.q) > 0.35) return "jumps";
  // Solutions of an elimination are numbered by their order, which says nothing along a path.
  return live.signs.length > 0 && row.branch !== branch ? "leaves branch " + branch : "";
}

/// Leads the target straight from the start to where it is, the arm from the start's joints; says whether it stays on
/// its branch.
function play(live, path) {
  const end = live.target;
  live.q = path.q.slice();
  live.psi = path.psi;
  live.found = live.solutions(path.target, live.q);
  const branch = live.found.rows[0]?.branch;
  const name = branch === undefined || live.signs.length === 0 ? "its branch" : `branch ${branch} (${branchName(live.signs, branch)})`;
  let left = "";
  const steps = 120;
  const step = (i) => {
    const before = live.q;
    live.moveTarget(between(path.target, end, i / steps));
    const why = left ? "" : departure(live, before, branch);
    if (why) left = `${why} at ${Math.round((100 * i) / steps)} %`;
    if (i < steps) return requestAnimationFrame(() => step(i + 1));
    live.note = "path: " + (left || "stays on " + name);
    live.redraw();
  };
  step(0);
}
