// The null motion of seven joints: the arm angle on a ring, with the arcs over which each branch is within limits.

function svgElement(name, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/// Zero stands above, positive angles turn to the right.
const onRing = (angle, radius) => [radius * Math.sin(angle), -radius * Math.cos(angle)];

function arcPath(lower, upper, radius) {
  const end = Math.min(upper, lower + 2 * Math.PI - 1e-4);
  const point = (angle) => onRing(angle, radius).map((x) => x.toFixed(2)).join(" ");
  return `M ${point(lower)} A ${radius} ${radius} 0 ${end - lower > Math.PI ? 1 : 0} 1 ${point(end)}`;
}

const isWithin = (interval, psi) => wrapped(psi - interval.lower - Math.PI) + Math.PI <= interval.upper - interval.lower + 1e-9;

/// How much of a turn the intervals of a branch take, in percent.
const shareOfTurn = (intervals) =>
  Math.round((100 * intervals.reduce((sum, { lower, upper }) => sum + upper - lower, 0)) / (2 * Math.PI));

class ArmAngleRing {
  constructor(place, changed) {
    this.changed = changed;
    this.arcs = svgElement("g", { "aria-hidden": "true" });
    this.hand = svgElement("line", { class: "ring-hand", x1: 0, y1: 0 });
    this.handle = svgElement("circle", { class: "ring-handle", r: 8, tabindex: 0, role: "slider", "aria-label": "arm angle",
      "aria-valuemin": -180, "aria-valuemax": 180 });
    this.text = svgElement("text", { class: "ring-text", "text-anchor": "middle", y: 5 });
    const marks = [[0, "0°"], [90, "90°"], [180, "180°"], [-90, "−90°"]].map(([angle, text]) => {
      const [x, y] = onRing(angle * degree, 108);
      return svgElement("text", { class: "ring-mark", "text-anchor": "middle", x, y: y + 4 }, text);
    });
    this.svg = svgElement("svg", { viewBox: "-125 -120 250 240", class: "ring", role: "group", "aria-label": "Arm angle of the null motion" },
      ...marks, this.arcs, this.hand, this.handle, this.text);
    this.note = element("p", { className: "note" });
    place.append(this.svg, this.note);
    this.listen();
  }

  listen() {
    const turnTo = (event) => {
      const box = this.svg.getBoundingClientRect();
      this.changed(Math.atan2(event.clientX - box.left - box.width / 2, box.top + box.height / 2 - event.clientY));
    };
    this.svg.addEventListener("pointerdown", (event) => {
      this.svg.setPointerCapture(event.pointerId);
      this.handle.focus();
      turnTo(event);
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (event.buttons) turnTo(event);
    });
    const steps = { ArrowRight: 2, ArrowUp: 2, ArrowLeft: -2, ArrowDown: -2, PageUp: 20, PageDown: -20 };
    this.handle.addEventListener("keydown", (event) => {
      if (!steps[event.key]) return;
      event.preventDefault();
      this.changed(wrapped(this.psi + steps[event.key] * degree));
    });
  }

  /// The branch of the arm outside, the others within.
  drawArcs(intervals, branch) {
    const branches = [...new Set(intervals.map((interval) => interval.branch))].sort((a, b) => a - b);
    const others = branches.filter((other) => other !== branch);
    const ring = (radius, width) => svgElement("circle", { class: "ring-track", r: radius, "stroke-width": width });
    const arcs = (name, of, radius) => intervals.filter((interval) => interval.branch === of)
      .map(({ lower, upper }) => svgElement("path", { class: name, d: arcPath(lower, upper, radius) }));
    const inner = others.flatMap((other, i) => [ring(74 - 5 * i, 0.6), ...arcs("ring-other", other, 74 - 5 * i)]);
    this.arcs.replaceChildren(ring(88, 1), ...arcs("ring-own", branch, 88), ...inner);
  }

  show(psi, intervals, branch, name) {
    this.psi = psi;
    const own = intervals.filter((interval) => interval.branch === branch);
    this.drawArcs(intervals, branch);
    const [x, y] = onRing(psi, 88);
    for (const [key, value] of [["x2", x], ["y2", y]]) this.hand.setAttribute(key, value.toFixed(2));
    for (const [key, value] of [["cx", x], ["cy", y]]) this.handle.setAttribute(key, value.toFixed(2));
    const angle = written(psi / degree, 1) + "°";
    this.text.textContent = "ψ = " + angle;
    const within = own.some((interval) => isWithin(interval, psi));
    this.handle.setAttribute("aria-valuenow", (psi / degree).toFixed(1));
    this.handle.setAttribute("aria-valuetext", `${angle}, ${within ? "within" : "beyond"} the limits`);
    const share = shareOfTurn(own);
    this.note.textContent = `Branch ${branch} (${name}): ${own.length === 0 ? "beyond a limit with every arm angle" : `within the limits over ${share} % of the turn`}. Inside the ring: the other branches.`;
  }
}
