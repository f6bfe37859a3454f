// SPDX-License-Identifier: MIT
// wasm_run.mjs PAGE MOTION.js ARM.js POINTS OUT: the functions of a page at the joint vectors of a file of doubles, results as
// doubles: a pose, a Jacobian, measures, then how many solutions the pose has, and their rows; of an arm with an arm angle
// that, and the same of its solutions.
import { readFileSync, writeFileSync } from "node:fs";
import vm from "node:vm";

const [page, motion, arm, points, out] = process.argv.slice(2);
const data = JSON.parse(readFileSync(page, "utf8").match(/id="live-data">(.*?)<\/script>/s)[1]);
vm.runInThisContext(readFileSync(motion, "utf8"));
vm.runInThisContext(readFileSync(arm, "utf8") + "\nglobalThis.loadArm = loadArm;");

const buffer = readFileSync(points);
const values = new Float64Array(buffer.buffer, buffer.byteOffset, buffer.length / 8);
const { raw, dof } = await globalThis.loadArm(data);
const results = [];
for (let i = 0; i < values.length; i += dof) {
  const q = Array.from(values.slice(i, i + dof));
  const pose = raw.pose(q);
  results.push(...pose, ...raw.jacobian(q), ...raw.measures(q));
  const { rows } = raw.solutions(pose, q, data.given < 0 ? 0 : q[data.given]);
  results.push(rows.length, ...rows.flat());
  if (!raw.armAngle) continue;
  const psi = raw.armAngle(q);
  const found = raw.solutionsAtArmAngle(pose, q, psi).rows;
  results.push(psi, found.length, ...found.flat());
}
writeFileSync(out, Buffer.from(new Float64Array(results).buffer));
