// The arm that moves along a path: a motion to choose, a slider along the path, and a mark on the map of all motions.

/// Values of a motion's places that lie around s, or null where the motion is not there: the first index, and the
/// share of the way to the next.
function placeOf(list, s) {
  const last = list.length - 1;
  if (!(s >= list[0] - 1e-6 && s <= list[last] + 1e-6)) return null;
  let [low, high] = [0, Math.max(last, 1)];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= s) low = middle;
    else high = middle;
  }
  const way = (list[high] ?? list[low]) - list[low];
  return { low, high: Math.min(high, last), share: way > 0 ? Math.min(Math.max((s - list[low]) / way, 0), 1) : 0 };
}

const mixed = ({ low, high, share }, list) => (1 - share) * list[low] + share * list[high];

class PathPlayer {
  constructor(data) {
    this.data = data;
    this.s = 0;
    this.chosen = 0;
    this.at = (id) => document.getElementById("path-" + id);
    this.skeletonOf = numerics(data.arm).skeleton;
    this.camera = new Camera(data.arm.size);
    this.view = new View(this.at("canvas"), this.camera);
    const tools = data.motions.map((motion, i) => motion.s.map((s) => this.skeleton(i, s)));
    this.tools = tools.map((list) => list.map((skeleton) => skeleton.tool.p));
    this.all = tools.flat().flatMap(({ points }) => points);
    this.camera.centre = extent([[0, 0, 0], ...this.all], this.camera.right, this.camera.up).centre;
    this.at("motion").append(...data.motions.map(({ name }, i) => element("option", { value: i, textContent: name })));
    this.addMark();
    this.listen();
    this.choose(0);
  }

  /// The motion's joints at a place; null where it is not.
  joints(i, s) {
    const place = placeOf(this.data.motions[i].s, s);
    const { q } = this.data.motions[i];
    return place && q[place.low].map((_, k) => (1 - place.share) * q[place.low][k] + place.share * q[place.high][k]);
  }

  /// The arm at a place, its base moved along rails if there are some.
  skeleton(i, s) {
    const motion = this.data.motions[i];
    const drawn = this.skeletonOf(this.joints(i, s));
    if (motion.way === undefined) return drawn;
    const place = placeOf(motion.s, s);
    const way = [0, 1, 2].map((k) => mixed(place, motion.way.map((at) => at[k])));
    const moved = (point) => add(point, way);
    const joints = drawn.joints.map((joint) => ({ ...joint, point: moved(joint.point), moved: moved(joint.moved) }));
    return { points: drawn.points.map(moved), joints, tool: { r: drawn.tool.r, p: moved(drawn.tool.p) } };
  }

  /// A line across the map's panels.
  addMark() {
    this.map = document.querySelector("#path-map svg");
    const { top } = this.data.map;
    const bottom = this.map.viewBox.baseVal.height - 54;
    this.mark = document.createElementNS("http://www.w3.org/2000/svg", "path");
    this.mark.setAttribute("d", `M0 ${top}V${bottom}`);
    this.mark.setAttribute("stroke", "#000");
    this.map.append(this.mark);
  }

  listen() {
    const canvas = this.at("canvas");
    this.at("place").addEventListener("input", () => this.moveTo(Number(this.at("place").value)));
    this.at("motion").addEventListener("change", () => this.choose(Number(this.at("motion").value)));
    this.at("all").addEventListener("change", () => this.redraw());
    this.at("play").addEventListener("click", () => (this.playing ? this.stop() : this.play()));
    const turn = (dx, dy) => {
      this.camera.turn(dx, dy);
      this.redraw();
    };
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => event.buttons > 0 && turn(0.008 * event.movementX, 0.008 * event.movementY));
    canvas.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (!way) return;
      event.preventDefault();
      turn(...way);
    });
    for (const kind of ["pointerdown", "pointermove"])
      this.map.addEventListener(kind, (event) => event.buttons > 0 && this.moveTo(this.placeOnMap(event)));
    new ResizeObserver(() => this.redraw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.view.readColours();
      this.redraw();
    });
  }

  placeOnMap(event) {
    const box = this.map.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * this.map.viewBox.baseVal.width;
    return ((x - this.data.map.left) / this.data.map.width) * this.data.end;
  }

  choose(i) {
    this.chosen = i;
    this.at("motion").value = i;
    for (const curve of this.map.querySelectorAll("[data-motion]")) curve.setAttribute("opacity", Number(curve.dataset.motion) === i ? 1 : 0.25);
    const { s } = this.data.motions[i];
    this.moveTo(Math.min(Math.max(this.s, s[0]), s[s.length - 1]));
  }

  moveTo(s) {
    this.s = Math.min(Math.max(s, 0), this.data.end);
    this.redraw();
  }

  /// From the motion's start to its end: in its least time where that is known, else in six seconds.
  play() {
    const { s, t } = this.data.motions[this.chosen];
    const clock = t ?? s.map((place) => (6 * (place - s[0])) / Math.max(s[s.length - 1] - s[0], 1e-9));
    const begin = performance.now();
    this.playing = true;
    const step = (now) => {
      if (!this.playing) return;
      const place = placeOf(clock, Math.max((now - begin) / 1000, 0));
      this.moveTo(place ? mixed(place, s) : s[s.length - 1]);
      if (place) requestAnimationFrame(step);
      else this.stop();
    };
    this.at("play").textContent = "stop";
    requestAnimationFrame(step);
  }
  stop() {
    this.playing = false;
    this.at("play").textContent = "play";
  }

  redraw() {
    drawAtNextFrame(this);
  }

  draw() {
    const { motions, map, end } = this.data;
    const here = motions.map((_, i) => i).filter((i) => placeOf(motions[i].s, this.s));
    this.view.clear();
    this.camera.keep(this.all);
    this.view.ground();
    this.view.line(this.tools[this.chosen], this.view.colour.accent, 1.6);
    if (this.at("all").checked)
      this.view.ghosts(here.filter((i) => i !== this.chosen).map((i) => ({ skeleton: this.skeleton(i, this.s), name: String(i + 1) })));
    const isHere = here.includes(this.chosen);
    if (isHere) this.view.arm(this.skeleton(this.chosen, this.s));
    this.mark.setAttribute("transform", `translate(${map.left + (map.width * this.s) / end} 0)`);
    this.show(isHere);
  }

  show(isHere) {
    const { arm, motions } = this.data;
    this.at("place").value = this.s;
    this.at("number").textContent = written(this.s, 2);
    const { name, s, t } = motions[this.chosen];
    const time = isHere && t ? `; ${written(mixed(placeOf(s, this.s), t), 3)} s` : "";
    this.at("status").textContent = name + (isHere ? time : "; it is not there at this place");
    const q = isHere ? this.joints(this.chosen, this.s) : null;
    const rows = arm.joints.flatMap((joint, i) => [
      element("dt", { textContent: joint.name }),
      element("dd", { textContent: q ? jointText(joint, q[i]) : "–" }),
    ]);
    this.at("joints").replaceChildren(...rows);
  }
}

const pathData = document.getElementById("path-data");
if (pathData) {
  document.getElementById("path").hidden = false;
  window.player = new PathPlayer(JSON.parse(pathData.textContent));
}
