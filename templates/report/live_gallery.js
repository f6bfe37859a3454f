// Solutions side by side: a small picture each, all seen from where the large one is.

class Gallery {
  constructor(place, size, choose) {
    this.place = place;
    this.size = size;
    this.choose = choose;
    this.pictures = [];
    this.seen = true;
    if (place) new IntersectionObserver((entries) => (this.seen = entries[entries.length - 1].isIntersecting)).observe(place);
  }

  append() {
    const index = this.pictures.length;
    const canvas = element("canvas");
    canvas.setAttribute("aria-hidden", "true");
    const text = element("span");
    const button = element("button", { type: "button", className: "picture" }, canvas, text);
    button.addEventListener("click", () => this.choose(index));
    this.place.append(button);
    this.pictures.push({ button, canvas, text, view: new View(canvas, new Camera(this.size)) });
  }

  /// All arms in each picture, as large as they fit.
  frame(solutions, { azimuth, elevation, right, up }) {
    const points = solutions.flatMap(({ skeleton }) => [[0, 0, 0], ...skeleton.points]);
    const { centre, wide, high } = extent(points, right, up);
    const size = Math.max(high, wide / 1.25, 0.2 * this.size) / 1.25;
    for (const { view } of this.pictures) {
      Object.assign(view.camera, { azimuth, elevation, centre, size });
      view.camera.aim();
    }
  }

  readColours() {
    for (const { view } of this.pictures) view.readColours();
  }

  show(solutions, chosen, camera) {
    if (!this.place) return;
    while (this.pictures.length < solutions.length) this.append();
    if (this.seen && solutions.length > 0) this.frame(solutions, camera);
    this.pictures.forEach(({ button, text, view }, i) => {
      button.hidden = i >= solutions.length;
      if (button.hidden) return;
      const { skeleton, name } = solutions[i];
      button.setAttribute("aria-pressed", i === chosen);
      if (text.textContent !== name) text.textContent = name;
      if (!this.seen) return;
      view.clear();
      view.small(skeleton, i === chosen);
    });
  }
}
