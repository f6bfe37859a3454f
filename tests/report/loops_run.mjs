// SPDX-License-Identifier: MIT
// loops_run.mjs PAGE MOTION.js ARM.js LOOPS.js COUNT: moves the mechanism of a page and prints as JSON, as shares of its size,
// how far the picture of each assembly is from closed (points of ties that are one, lengths of rods), how far its tips are
// from the generated functions', how far Newton's steps lead away from an assembly, and how far a dragged tip stays behind.
import { readFileSync } from "node:fs";
import vm from "node:vm";

const [page, ...scripts] = process.argv.slice(2, 6);
const count = Number(process.argv[6]);
const data = JSON.parse(readFileSync(page, "utf8").match(/id="live-loops-data">(.*?)<\/script>/s)[1]);
const names = "loadLinkage, placedLinkage, draggedTo, subtract, norm, apart";
// The classes of the page are not used here: only what they extend is missing.
vm.runInThisContext("class ByHand {}\n" + scripts.map((name) => readFileSync(name, "utf8")).join("\n") + `\nObject.assign(globalThis, { ${names} });`);
const { loadLinkage, placedLinkage, draggedTo, subtract, norm, apart } = globalThis;

let state = 1;
const random = () => ((state = (state * 48271) % 2147483647) / 2147483647);
const linkage = await loadLinkage(data);
const lengths = (q) => placedLinkage(data, q).ties.map(([a, b]) => norm(subtract(a, b)));
const rods = data.ties.map(({ apart: isRod }) => isRod);
const wanted = lengths(data.start).map((length, i) => (rods[i] ? length : 0));
const result = { assemblies: 0, sets: 0, closed: 0, tips: 0, follow: 0, dragged: 0, drags: 0, lengths: wanted };
const worst = (name, value) => (result[name] = Math.max(result[name], Number.isNaN(value) ? 1 : value));

const near = (q, share) => linkage.motors(q).map((value, i) => {
  const { lower, upper } = data.joints[data.driven[i]];
  return Math.min(Math.max(value + share * (random() - 0.5) * (upper - lower), lower), upper);
});

for (let k = 0; k < count; ++k) {
  const motors = near(data.start, 0.05);
  const found = linkage.assemble(motors, data.start);
  result.sets += found.length > 0;
  for (const { q, free, meets } of found) {
    ++result.assemblies;
    lengths(q).forEach((length, i) => worst("closed", Math.abs(length - wanted[i]) / data.size));
    const drawn = placedLinkage(data, q).tips;
    linkage.tips.forEach((tip, i) => tip && worst("tips", norm(subtract(tip.pose(q).p, drawn[i].p)) / data.size));
    if (free || meets) continue;
    const followed = linkage.follow(motors, q);
    worst("follow", followed ? apart(data.joints, followed, q) : 1);
    const aim = linkage.follow(near(q, 0.005), q);
    for (const tip of aim ? linkage.tips.filter(Boolean) : []) {
      const place = tip.pose(aim).p;
      const before = norm(subtract(place, tip.pose(q).p));
      if (!(before > 1e-4 * data.size)) continue;
      ++result.drags;
      result.dragged += norm(subtract(place, tip.pose(draggedTo(linkage, tip, place, q)).p)) / before;
    }
  }
}
console.log(JSON.stringify(result));
