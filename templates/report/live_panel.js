// Controls beside the picture: sliders, numbers of the target, measures, the table of solutions.

const degree = Math.PI / 180;
const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};
const written = (value, digits) => value.toFixed(digits).replace(/^-(?=0\.?0*$)/, "").replace("-", "−");
const jointText = (joint, value) => (joint.revolute ? written(value / degree, 1) + "°" : written(value, 3) + " m");

/// A slider a joint; below it how far the nearest limit is.
function jointSliders(place, joints, changed) {
  const rows = joints.map((joint, i) => {
    const id = "live-joint-" + i;
    const slider = element("input", { type: "range", id, min: joint.lower, max: joint.upper, step: "any" });
    const output = element("output", { htmlFor: id });
    const room = element("div", { className: "room", title: "way to the nearest limit" });
    slider.addEventListener("input", () => changed(i, Number(slider.value)));
    const row = element("div", { className: "live-joint" }, element("label", { htmlFor: id, textContent: joint.name }), slider, output);
    if (joint.limited) row.append(room);
    place.append(row);
    return { row, slider, output, room, joint };
  });
  const show = (q) => {
    rows.forEach(({ slider, output, room, joint }, i) => {
      slider.value = q[i];
      slider.setAttribute("aria-valuetext", jointText(joint, q[i]));
      output.textContent = jointText(joint, q[i]);
      const share = (2 * Math.min(q[i] - joint.lower, joint.upper - q[i])) / (joint.upper - joint.lower);
      room.style.transform = `scaleX(${Math.min(Math.max(share, 0), 1)})`;
      room.classList.toggle("little", share < 0.1);
    });
  };
  return { show, row: (i) => rows[i].row };
}

/// A strip under a joint's slider: dark where the tool can stay with that value, by samples of the joint's range.
function feasibleStrip(row, joint) {
  const strip = element("div", { className: "feasible", role: "img" });
  row.append(strip);
  return (samples) => {
    const stops = samples.map((good, i) => {
      const from = (100 * i) / samples.length, to = (100 * (i + 1)) / samples.length;
      return `${good ? "var(--bar)" : "transparent"} ${from}% ${to}%`;
    });
    strip.style.backgroundImage = `linear-gradient(to right, ${stops.join(", ")})`;
    const share = Math.round((100 * samples.filter(Boolean).length) / samples.length);
    strip.setAttribute("aria-label", `${joint.name}: the tool can stay over ${share} % of the range`);
  };
}

/// Numbers of the target: metres, and degrees about z, y, x.
function targetInputs(place, changed) {
  const names = ["x", "y", "z", "yaw", "pitch", "roll"];
  const inputs = names.map((name, i) => {
    const input = element("input", { type: "number", step: i < 3 ? "0.01" : "1", id: "live-" + name });
    input.addEventListener("change", () => {
      const values = inputs.map((each) => Number(each.value));
      if (values.every(Number.isFinite))
        changed({ p: values.slice(0, 3), r: fromYawPitchRoll(values.slice(3).map((v) => v * degree)) });
    });
    place.append(element("label", { htmlFor: input.id }, name + (i < 3 ? " (m) " : " (°) "), input));
    return input;
  });
  return (target) => {
    const values = [...target.p, ...yawPitchRoll(target.r).map((angle) => angle / degree)];
    inputs.forEach((input, i) => {
      if (document.activeElement !== input) input.value = values[i].toFixed(i < 3 ? 4 : 2);
    });
  };
}

function measureList(place, names) {
  const values = [...names, "manipulability"].map((name) => {
    const value = element("dd");
    place.append(element("dt", { textContent: name }), value);
    return value;
  });
  return (numbers) => numbers.forEach((number, i) => (values[i].textContent = number.toPrecision(4).replace("-", "−")));
}

function solutionTable(table, joints, choose) {
  if (!table) return () => {};
  const heads = ["branch", ...joints.map((joint) => joint.name), ""];
  table.tHead.append(element("tr", {}, ...heads.map((text, i) =>
    element("th", { scope: "col", className: i > 0 && text ? "number" : "", textContent: text || "limits" }))));
  return (rows, chosen) => {
    const body = rows.map((row, index) => {
      const button = element("button", { type: "button", textContent: String(row.branch) });
      button.addEventListener("click", () => choose(index));
      const beyond = joints.filter((joint, i) => row.q[i] < joint.lower - 1e-9 || row.q[i] > joint.upper + 1e-9);
      const note = [row.free ? "a joint is free" : "", beyond.length ? "beyond: " + beyond.map((j) => j.name).join(" ") : ""];
      return element("tr", { className: index === chosen ? "chosen" : "" },
        element("th", { scope: "row" }, button),
        ...joints.map((joint, i) => element("td", { className: "number", textContent: jointText(joint, row.q[i]) })),
        element("td", { textContent: note.filter(Boolean).join(", ") }));
    });
    table.tBodies[0].replaceChildren(...body);
  };
}
