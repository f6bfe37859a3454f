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
  place.style.setProperty("--names", Math.max(...joints.map((joint) => joint.name.length)) + 1 + "ch");
  const rows = joints.map((joint, i) => {
    const id = "live-joint-" + i;
    const slider = element("input", { type: "range", id, step: "any" });
    const output = element("output", { htmlFor: id });
    const room = element("div", { className: "room", title: "way to the nearest limit" });
    slider.addEventListener("input", () => changed(i, Number(slider.value)));
    const row = element("div", { className: "live-joint" }, element("label", { htmlFor: id, textContent: joint.name }), slider, output, room);
    place.append(row);
    return { row, slider, output, room, joint };
  });
  const show = (q) => {
    rows.forEach(({ slider, output, room, joint }, i) => {
      [slider.min, slider.max, slider.value] = [joint.lower, joint.upper, q[i]];
      const share = limitShare(joint, q[i]);
      const limit = joint.limited ? `, ${Math.round(100 * Math.max(share, 0))} % of the way to a limit left` : "";
      slider.setAttribute("aria-valuetext", jointText(joint, q[i]) + limit);
      output.textContent = jointText(joint, q[i]);
      room.hidden = !joint.limited;
      room.style.transform = `scaleX(${Math.min(Math.max(share, 0), 1)})`;
      room.classList.toggle("little", share < 0.1);
    });
  };
  return { show, row: (i) => rows[i].row };
}

/// How far a joint is from its nearest limit: 1 in the middle of its range, 0 at a limit, less beyond.
const limitShare = (joint, value) => (2 * Math.min(value - joint.lower, joint.upper - value)) / (joint.upper - joint.lower);

/// Limits for the turns that the description leaves without, for as long as a number of degrees stands there.
function assumedLimits(input, joints, changed) {
  const free = joints.filter((joint) => !joint.limited && joint.revolute);
  if (!input) return;
  input.closest("label").hidden = free.length === 0;
  input.addEventListener("change", () => {
    const angle = Number(input.value) * degree;
    const limited = angle > 0 && angle < Math.PI;
    for (const joint of free) Object.assign(joint, { limited, lower: limited ? -angle : -Math.PI, upper: limited ? angle : Math.PI });
    changed();
  });
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

/// Measures of singularity, each with a bar: its share of the largest value that random joint values have.
function measureList(place, names, largest) {
  const values = names.map((name) => {
    const number = element("span");
    const bar = element("div", { className: "room" });
    place.append(element("dt", { textContent: name }), element("dd", {}, number, bar));
    return { number, bar };
  });
  return (numbers) => numbers.forEach((value, i) => {
    const share = Math.min(Math.abs(value) / largest[i], 1);
    values[i].number.textContent = value.toPrecision(4).replace("-", "−");
    values[i].bar.style.transform = `scaleX(${share})`;
    values[i].bar.classList.toggle("little", share < littleShare);
  });
}

/// A measure is called small below this share.
const littleShare = 0.03;

/// The largest sizes of functions of joint values over some random ones, the same in every visit.
function largestOf(joints, measures, count = 300) {
  let state = 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  let largest = [];
  for (let i = 0; i < count; ++i) {
    const values = measures(joints.map(({ lower, upper }) => lower + random() * (upper - lower)));
    largest = values.map((value, k) => Math.max(Math.abs(value), largest[k] ?? 1e-300));
  }
  return largest;
}

function solutionTable(table, joints, nameOf, choose) {
  if (!table) return () => {};
  const heads = ["branch", ...joints.map((joint) => joint.name), "room", ""];
  const body = element("tbody");
  table.append(element("thead"), body);
  table.tHead.append(element("tr", {}, ...heads.map((text, i) =>
    element("th", { scope: "col", className: i > 0 && text ? "number" : "", textContent: text || "limits" }))));
  return (rows, chosen) => {
    const made = rows.map((row, index) => {
      const button = element("button", { type: "button", textContent: String(row.branch) });
      button.addEventListener("click", () => choose(index));
      const beyond = joints.filter((joint, i) => row.q[i] < joint.lower - 1e-9 || row.q[i] > joint.upper + 1e-9);
      const note = [row.free ? "a joint is free" : "", beyond.length ? "beyond: " + beyond.map((j) => j.name).join(" ") : ""];
      const limited = joints.flatMap((joint, i) => (joint.limited ? [limitShare(joint, row.q[i])] : []));
      const room = limited.length ? Math.round(100 * Math.min(...limited)) + " %" : "–";
      return element("tr", { className: index === chosen ? "chosen" : "" },
        element("th", { scope: "row" }, button, element("span", { className: "signs", textContent: nameOf(row.branch) })),
        ...joints.map((joint, i) => element("td", { className: "number", textContent: jointText(joint, row.q[i]) })),
        element("td", { className: "number", textContent: room.replace("-", "−") }),
        element("td", { textContent: note.filter(Boolean).join(", ") }));
    });
    body.replaceChildren(...made);
  };
}
