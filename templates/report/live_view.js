// Drawing: a camera at infinity on a canvas, arms as lines, cylinders and boxes, the target with its handles.

/// The middle of points, and how far they reach to both sides of it together.
function extent(points, right, up) {
  const span = (axis) => {
    const along = points.map((point) => dot(axis, point));
    return [Math.min(...along), Math.max(...along)];
  };
  const [[left, rightmost], [below, above]] = [span(right), span(up)];
  const centre = add(scaled((left + rightmost) / 2, right), scaled((below + above) / 2, up));
  return { centre, wide: rightmost - left, high: above - below };
}

class Camera {
  constructor(size, { azimuth, elevation } = { azimuth: -0.95, elevation: 0.36 }) {
    this.azimuth = azimuth;
    this.elevation = elevation;
    this.size = size;
    this.centre = [0, 0, 0];
    this.aim();
  }
  aim() {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    this.right = [-sa, ca, 0];
    this.toward = [ca * ce, sa * ce, se];
    this.up = cross(this.toward, this.right);
  }
  turn(dx, dy) {
    this.azimuth -= dx;
    this.elevation = Math.min(Math.max(this.elevation + dy, -1.5), 1.5);
    this.aim();
  }
  /// For a picture of so many points.
  fit(width, height) {
    this.width = width;
    this.height = height;
    this.scale = (0.5 * Math.min(width, height)) / (0.75 * this.size);
  }
  /// Moves away until all points are in the picture.
  keep(points) {
    const share = (x, whole) => Math.abs(x - whole / 2) / (0.46 * whole);
    const far = Math.max(...points.map(this.place, this).map(([x, y]) => Math.max(share(x, this.width), share(y, this.height))));
    if (!(far > 1 && far < 1e3)) return;
    this.size *= far;
    this.fit(this.width, this.height);
  }
  place(v) {
    const from = subtract(v, this.centre);
    return [this.width / 2 + this.scale * dot(this.right, from), this.height / 2 - this.scale * dot(this.up, from)];
  }
  depth(v) {
    return dot(this.toward, v);
  }
  /// A way on the picture in the world, in the plane of the picture.
  way(dx, dy) {
    return add(scaled(dx / this.scale, this.right), scaled(-dy / this.scale, this.up));
  }
}

function hull(points) {
  const sorted = points.slice().sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const left = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
  const half = (list) => {
    const chain = [];
    for (const p of list) {
      while (chain.length > 1 && !left(chain[chain.length - 2], chain[chain.length - 1], p)) chain.pop();
      chain.push(p);
    }
    chain.pop();
    return chain;
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

function prism(centre, axis, radius, halfHeight, corners) {
  const x = normalTo(axis), y = cross(axis, x);
  const ring = (side) =>
    Array.from({ length: corners }, (_, i) => {
      const angle = ((2 * i + 1) * Math.PI) / corners;
      const out = add(scaled(radius * Math.cos(angle), x), scaled(radius * Math.sin(angle), y));
      return add(add(centre, scaled(side * halfHeight, axis)), out);
    });
  return [ring(-1), ring(1)];
}

/// Returns where joints are drawn: those at one point move apart along their axes.
function symbolPlaces(skeleton, radius) {
  const { joints, tool } = skeleton;
  const places = joints.map((joint) => joint.point);
  for (let begin = 0, end; begin < joints.length; begin = end) {
    end = begin + 1;
    while (end < joints.length && norm(subtract(joints[end].point, joints[begin].point)) < radius) ++end;
    const before = begin === 0 ? [0, 0, 0] : places[begin - 1];
    const behind = end < joints.length ? joints[end].point : tool.p;
    for (let i = begin; i < end; ++i) {
      const sense = dot(joints[i].axis, subtract(behind, before)) < -1e-9 ? -1 : 1;
      places[i] = add(joints[begin].point, scaled(3.2 * radius * (i - (begin + end - 1) / 2) * sense, joints[i].axis));
    }
  }
  return places;
}

class View {
  constructor(canvas, camera) {
    this.canvas = canvas;
    this.camera = camera;
    this.pen = canvas.getContext("2d");
    this.radius = 0.03 * camera.size;
    this.readColours();
  }
  readColours() {
    const style = getComputedStyle(this.canvas);
    this.colour = Object.fromEntries(
      ["paper", "ink", "soft", "line", "shade", "accent"].map((name) => [name, style.getPropertyValue("--" + name).trim()]),
    );
  }
  clear() {
    const ratio = window.devicePixelRatio || 1;
    const { clientWidth, clientHeight } = this.canvas;
    if (this.canvas.width !== Math.round(clientWidth * ratio) || this.canvas.height !== Math.round(clientHeight * ratio)) {
      this.canvas.width = Math.round(clientWidth * ratio);
      this.canvas.height = Math.round(clientHeight * ratio);
    }
    this.camera.fit(clientWidth, clientHeight);
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.clearRect(0, 0, clientWidth, clientHeight);
    this.pen.lineJoin = this.pen.lineCap = "round";
  }
  path(points, closed = false) {
    this.pen.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? this.pen.moveTo(x, y) : this.pen.lineTo(x, y)));
    if (closed) this.pen.closePath();
  }
  line(points, colour, width, dash = []) {
    this.path(points.map((p) => this.camera.place(p)));
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = width;
    this.pen.setLineDash(dash);
    this.pen.stroke();
    this.pen.setLineDash([]);
  }
  solid(rings, axis, fill) {
    const placed = rings.map((ring) => ring.map((p) => this.camera.place(p)));
    const near = dot(axis, this.camera.toward) > 0 ? placed[1] : placed[0];
    this.pen.strokeStyle = this.colour.ink;
    this.pen.lineWidth = 1.25;
    for (const [outline, inside] of [[hull(placed.flat()), this.colour.paper], [near, fill]]) {
      this.path(outline, true);
      this.pen.fillStyle = inside;
      this.pen.fill();
      this.pen.stroke();
    }
  }
  /// An arm in a picture too small for its joints' symbols.
  small(skeleton, chosen) {
    this.line([[0, 0, 0], skeleton.points[0]], this.colour.line, 1);
    this.line(skeleton.points, chosen ? this.colour.accent : this.colour.ink, 1.8);
    for (const joint of skeleton.joints) this.dot(joint.point);
    const tips = this.handles(skeleton.tool).slice(1);
    tips.forEach((tip, k) => this.line([skeleton.tool.p, tip], this.colour.soft, 1, [[1, 2], [4, 2], []][k]));
  }
  ground() {
    const s = 0.15 * this.camera.size;
    for (let i = -2; i <= 2; ++i) {
      this.line([[i * s, -2 * s, 0], [i * s, 2 * s, 0]], this.colour.line, 1);
      this.line([[-2 * s, i * s, 0], [2 * s, i * s, 0]], this.colour.line, 1);
    }
  }
  /// Arms that are possible, thin, with their branches beside the middle joint; those that look alike share a name.
  ghosts(list) {
    const names = new Map();
    for (const { skeleton, name } of list) {
      this.line(skeleton.points, this.colour.soft, 1.1);
      for (const joint of skeleton.joints) this.dot(joint.point);
      const place = this.camera.place(skeleton.joints[Math.floor((skeleton.joints.length - 1) / 2)].point);
      const key = place.map((x) => Math.round(x / 3)).join();
      names.set(key, { place, text: names.has(key) ? `${names.get(key).text}, ${name}` : name });
    }
    this.pen.font = "11px Arial, 'Liberation Sans', sans-serif";
    this.pen.fillStyle = this.colour.soft;
    for (const { place, text } of names.values()) this.pen.fillText(text, place[0] + 6, place[1] - 6);
  }
  dot(point) {
    const [x, y] = this.camera.place(point);
    this.pen.beginPath();
    this.pen.arc(x, y, 2.2, 0, 2 * Math.PI);
    this.pen.fillStyle = this.colour.soft;
    this.pen.fill();
  }
  arm(skeleton) {
    const places = symbolPlaces(skeleton, this.radius);
    skeleton.joints.forEach((joint, i) => {
      const reach = scaled(2.6 * this.radius, joint.axis);
      this.line([subtract(places[i], reach), add(places[i], reach)], this.colour.soft, 0.9, [5, 3, 1, 3]);
      this.line([joint.point, places[i]], this.colour.ink, 2.5);
      if (!joint.revolute) this.line([joint.point, joint.moved], this.colour.ink, 4);
    });
    this.line(skeleton.points, this.colour.ink, 2.5);
    this.symbols(skeleton.joints, places);
  }
  /// The symbols of joints at places, the nearest to the reader last.
  symbols(joints, places) {
    const order = places.map((p, i) => i).sort((a, b) => this.camera.depth(places[a]) - this.camera.depth(places[b]));
    for (const i of order) {
      const { axis, revolute } = joints[i];
      const rings = revolute
        ? prism(places[i], axis, this.radius, 1.1 * this.radius, 24)
        : prism(places[i], axis, 1.05 * this.radius, 1.3 * this.radius, 4);
      this.solid(rings, axis, this.colour.shade);
    }
  }
  /// Returns where the target may be taken hold of, in the world: its ball first, then the tips of its axes.
  handles(target) {
    const length = 5 * this.radius;
    return [target.p, ...[0, 1, 2].map((k) => add(target.p, scaled(length, column(target.r, k))))];
  }
  /// `count`: how many of the handles are drawn.
  target(target, held, count = 4) {
    const [ball, ...tips] = this.handles(target).slice(0, count);
    const dashes = [[2, 3], [6, 3], []];
    tips.forEach((tip, k) => this.line([ball, tip], this.colour.accent, 1.6, dashes[k]));
    [ball, ...tips].forEach((point, k) => {
      const [x, y] = this.camera.place(point);
      this.pen.beginPath();
      this.pen.arc(x, y, k === 0 ? 6.5 : 4.5, 0, 2 * Math.PI);
      this.pen.fillStyle = held === k ? this.colour.accent : this.colour.paper;
      this.pen.strokeStyle = this.colour.accent;
      this.pen.lineWidth = 1.6;
      this.pen.fill();
      this.pen.stroke();
    });
  }
}

/// Draws a picture at the next frame, once however often this is called before it.
function drawAtNextFrame(picture) {
  if (picture.waiting) return;
  picture.waiting = true;
  requestAnimationFrame(() => {
    picture.waiting = false;
    picture.draw();
  });
}
