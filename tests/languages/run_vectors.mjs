// SPDX-License-Identifier: MIT
// Runs a robot's vectors in JavaScript: node run_vectors.mjs MODULE VECTORS.json
//
// First with the sines that C had, put in place of the engine's: every bit must be C's. Then with the engine's own, whose
// last digit may differ: the functions without branches must agree to rounding.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [modulePath, vectorsPath] = process.argv.slice(2);
const robot = await import(pathToFileURL(modulePath));
const vectors = JSON.parse(readFileSync(vectorsPath, "utf8"));

const view = new DataView(new ArrayBuffer(8));
const numberOf = (bits) => (view.setBigUint64(0, BigInt("0x" + bits)), view.getFloat64(0));
const bitsOf = (x) => (view.setFloat64(0, x), view.getBigUint64(0).toString(16).padStart(16, "0"));
const camel = (name) => name.replace(/_+([a-z0-9])/g, (_, c) => c.toUpperCase());

function argumentOf(text) {
  if (text === "none") return null;
  if (text === "geometry") return robot.defaultGeometry;
  if (text === "inertia") return robot.defaultInertia;
  return text.map(numberOf);
}

/** The numbers of a result, in the order of its fields; of rows as many as it counts. */
function flat(value, into = []) {
  if (typeof value === "number") into.push(value);
  else if (value.rows !== undefined && value.count !== undefined)
    for (const key of Object.keys(value)) flat(key === "rows" ? value.rows.slice(0, value.count) : value[key], into);
  else for (const each of Object.values(value)) flat(each, into);
  return into;
}

const same = (wanted, x) =>
  wanted[0] === "#" ? Number(wanted.slice(1)) === x : bitsOf(x) === wanted || (Number.isNaN(x) && Number.isNaN(numberOf(wanted)));
const near = (wanted, x, size) =>
  wanted[0] === "#" ? Number(wanted.slice(1)) === x : Math.abs(x - numberOf(wanted)) <= 1e-12 * size || same(wanted, x);

/** The first fifty rows within limits, whole turns counted. */
function representatives(orientation, position, lower, upper) {
  const all = robot.startRepresentatives(robot.inverseKinematics(orientation, position), lower, upper);
  const rows = [];
  while (rows.length < 50 && robot.nextRepresentative(all)) rows.push(all.row.q.slice());
  return rows;
}

/** Branches of the best rows, and all rows, by four metrics. */
function metrics(orientation, position, seed, speeds, accelerations) {
  const orders = [
    [seed, false, (way) => robot.fastestTime(way, { speeds, accelerations })],
    [seed, true, (way) => robot.weightedDistance(way, speeds)],
    [seed, false, (way) => robot.largestJoint(way, accelerations)],
    [null, false, (way) => robot.largestJoint(way)],
  ];
  return orders.map(([from, withinLimits, metric]) => {
    const found = robot.inverseKinematics(orientation, position);
    const best = robot.bestBy(found, seed, withinLimits, metric);
    robot.sortBy(found, from, withinLimits, metric);
    return [best === null ? -2 : best.branch, found.rows.slice(0, found.count).map((row) => Array.from(row.q))];
  });
}

function run(call) {
  if (call.function === "metrics") return flat(metrics(...call.arguments.map(argumentOf)));
  if (call.function === "representatives") return flat(representatives(...call.arguments.map(argumentOf)));
  const own = robot[camel(call.function)];
  if (own === undefined) throw new Error(`the module has no ${camel(call.function)}`);
  const list = call.arguments.map(argumentOf);
  // A number alone is an array of one in the file; the function's length of arguments tells nothing of it.
  return flat(own(...list.map((each, i) => (Array.isArray(each) && call.numbers.includes(i) ? each[0] : each))));
}

function check(agree, what) {
  let failures = 0;
  for (const call of vectors.calls) {
    const given = run(call);
    const size = Math.max(1, ...call.result.map((r) => (r[0] === "#" ? 0 : Math.abs(numberOf(r)) || 0)).filter(Number.isFinite));
    const wrong = call.result.findIndex((wanted, i) => !agree(wanted, given[i], size));
    if (given.length === call.result.length && wrong < 0) continue;
    if (++failures <= 5)
      console.error(`${what}: ${call.function}(${call.arguments}): number ${wrong} is ${given[wrong]} (${given.length}), ` +
        `not ${call.result[wrong]} (${call.result.length})`);
  }
  return failures;
}

const own = {};
const { library } = vectors;
for (const [name, table] of Object.entries(library)) {
  own[name] = Math[name];
  Math[name] = (...inputs) => {
    const known = table[inputs.map(bitsOf).join(" ")];
    if (known === undefined) throw new Error(`Math.${name}(${inputs}) was not asked for in C`);
    return numberOf(known);
  };
}
const count = vectors.calls.length;
let failures = check(same, "with C's sines");
for (const name of Object.keys(own)) Math[name] = own[name];
vectors.calls = vectors.calls.filter((call) => !call.function.startsWith("inverse_kinematics") && !["metrics", "representatives"].includes(call.function));
failures += check(near, "with Math's sines");
console.log(`${count} vectors of ${vectors.robot} in JavaScript, ${failures} failures`);
process.exit(failures === 0 && count > 0 ? 0 : 1);
