// SPDX-License-Identifier: MIT
// Runs a robot's batches in WebAssembly: node run_batches.mjs PACKAGE NAME VECTORS.json
//
// The inputs of its vectors, repeated over the end of a part, must give the bits of the single calls; so must an argument that
// all configurations share. Prints how much faster batches are than single calls in this run.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, name, vectorsPath] = process.argv.slice(2);
const load = (suffix) => import(pathToFileURL(join(folder, `qvgen_${name}${suffix}.mjs`)));
const robot = await load(""), batch = await load("_batch");
const vectors = JSON.parse(readFileSync(vectorsPath, "utf8"));

const view = new DataView(new ArrayBuffer(8));
const numberOf = (bits) => (view.setBigUint64(0, BigInt("0x" + bits)), view.getFloat64(0));
const camel = (text) => text.replace(/_+([a-z0-9])/g, (_, c) => c.toUpperCase());
const same = (a, b) => Object.is(a, b);
const least = 520; // more than a part of a batch

/** Kind of an argument: what a batch shares, or "rows". */
function kindOf(call, i) {
  const text = call.arguments[i];
  if (typeof text === "string") return text;
  return call.numbers.includes(i) ? "number " + text[0] : "rows";
}
function sharedOf(kind) {
  if (kind === "none") return null;
  if (kind === "geometry") return robot.defaultGeometry;
  return kind === "inertia" ? robot.defaultInertia : numberOf(kind.slice(7));
}

/** Numbers of a result by the names of its fields, those of rows one behind the other. */
function leaves(value, into = {}) {
  for (const [key, each] of Object.entries(value)) {
    if (key === "rows") for (const row of each.slice(0, value.count)) leaves(row, into);
    else if (typeof each === "object" && each.length === undefined) leaves(each, into);
    else (into[key] ??= []).push(...flat(each));
  }
  return into;
}
const flat = (each) => (typeof each === "number" ? [each] : Array.from(each).flatMap(flat));

/** True if a configuration's part of a batch has the single result's numbers, and behind them what says that nothing is there. */
function agrees(single, part) {
  const behind = part instanceof Int32Array ? 0 : NaN;
  return Array.from(part).every((x, i) => same(x, i < single.length ? single[i] : behind));
}

function compare(own, kinds, calls, sharesLast) {
  const last = sharesLast ? kinds.lastIndexOf("rows") : -1;
  const rowsOf = (call, i) => (i === last ? calls[0] : call).arguments[i].map(numberOf);
  const single = calls.map((call) => robot[own](...kinds.map((kind, i) => (kind === "rows" ? rowsOf(call, i) : sharedOf(kind)))));
  const given = batch[own](...kinds.map((kind, i) => {
    if (kind !== "rows") return sharedOf(kind);
    return Float64Array.from(i === last ? rowsOf(calls[0], i) : calls.flatMap((call) => rowsOf(call, i)));
  }));
  return calls.filter((_, k) => {
    const one = typeof single[k] === "number" || single[k].length !== undefined ? { result: flat(single[k]) } : leaves(single[k]);
    const all = given.length === undefined ? given : { result: given };
    return !Object.keys(all).every((key) => {
      const size = all[key].length / calls.length;
      return Number.isInteger(size) && agrees(one[key] ?? [], all[key].subarray(k * size, (k + 1) * size));
    });
  }).length;
}

const groups = new Map();
for (const call of vectors.calls) {
  if (batch[camel(call.function)] === undefined) continue;
  const kinds = call.arguments.map((_, i) => kindOf(call, i));
  const key = [call.function, ...kinds].join("|");
  if (!groups.has(key)) groups.set(key, { own: camel(call.function), kinds, calls: [] });
  groups.get(key).calls.push(call);
}
let failures = 0, count = 0;
const fail = (what) => { ++failures; console.error(what); };
for (const { own, kinds, calls } of groups.values()) {
  if (!kinds.includes("rows")) continue;
  const many = Array.from({ length: least }, (_, k) => calls[k % calls.length]);
  for (const sharesLast of kinds.filter((kind) => kind === "rows").length > 1 ? [false, true] : [false]) {
    const wrong = compare(own, kinds, many, sharesLast);
    if (wrong > 0) fail(`${own}(${kinds}): ${wrong} of ${least} configurations are not those of single calls`);
    count += least;
  }
}

const throwsRange = (call) => { try { call(); return false; } catch (error) { return error instanceof RangeError; } };
if (batch.forwardKinematics([]).position.length !== 0) fail("no configurations give numbers");
if (!throwsRange(() => batch.forwardKinematics(new Float64Array(robot.dof + 1)))) fail("a part of a configuration is taken");
if (!throwsRange(() => batch.forwardKinematics())) fail("a missing argument is taken");

/** Microseconds a configuration, the best of five runs. */
function microseconds(work, size) {
  let best = Infinity;
  for (let i = 0; i < 5; ++i) {
    const start = performance.now();
    work();
    best = Math.min(best, performance.now() - start);
  }
  return (1000 * best) / size;
}
function measure(own, ...sizes) {
  if (batch[own] === undefined) return;
  const size = 1024, columns = sizes.map((each) => Float64Array.from({ length: size * each }, (_, i) => Math.sin(i)));
  if (own === "inverseKinematics") {
    const poses = batch.forwardKinematics(columns[0]);
    if (columns.splice(0, 1, poses.orientation, poses.position), batch[own].length !== robot[own].length) return;
    sizes.splice(0, 1, 4, 3);
  }
  const single = () => {
    for (let k = 0; k < size; ++k) robot[own](...columns.map((each, i) => each.subarray(k * sizes[i], (k + 1) * sizes[i])));
  };
  const [many, one] = [microseconds(() => batch[own](...columns), size), microseconds(single, size)];
  console.log(`${own}: ${many.toFixed(2)} us a configuration in a batch, ${one.toFixed(2)} us alone, ${(one / many).toFixed(1)} times`);
}
const { dof } = robot;
measure("forwardKinematics", dof);
measure("jacobian", dof);
measure("inverseDynamics", dof, dof, dof);
if (vectors.calls.some((call) => call.function === "inverse_kinematics" && call.arguments[1].length === 3)) measure("inverseKinematics", dof);
console.log(`${count} configurations of ${name} in batches, ${failures} failures`);
process.exit(failures === 0 && count > 0 ? 0 : 1);
