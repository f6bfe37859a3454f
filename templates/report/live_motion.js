"use strict";
// Vectors, rotations by rows, rigid motions { r, p }.
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(...a);
const unit = (a) => scaled(1 / norm(a), a);
const column = (r, k) => [r[0][k], r[1][k], r[2][k]];
const transposed = (r) => [column(r, 0), column(r, 1), column(r, 2)];
const rotated = (r, v) => [dot(r[0], v), dot(r[1], v), dot(r[2], v)];
const product = (a, b) => a.map((row) => [0, 1, 2].map((k) => dot(row, column(b, k))));
const compose = (a, b) => ({ r: product(a.r, b.r), p: add(rotated(a.r, b.p), a.p) });
const identity = () => [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

function turnAbout(a, angle) {
  const c = Math.cos(angle), s = Math.sin(angle), v = 1 - c;
  return [
    [c + v * a[0] * a[0], v * a[0] * a[1] - s * a[2], v * a[0] * a[2] + s * a[1]],
    [v * a[1] * a[0] + s * a[2], c + v * a[1] * a[1], v * a[1] * a[2] - s * a[0]],
    [v * a[2] * a[0] - s * a[1], v * a[2] * a[1] + s * a[0], c + v * a[2] * a[2]],
  ];
}

function normalTo(axis) {
  const other = Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  return unit(subtract(other, scaled(dot(other, axis), axis)));
}

/// The shortest turn of one unit vector into another.
function turnFromTo(a, b) {
  const axis = cross(a, b), s = norm(axis), c = dot(a, b);
  if (s < 1e-12) return c > 0 ? identity() : turnAbout(normalTo(a), Math.PI);
  return turnAbout(scaled(1 / s, axis), Math.atan2(s, c));
}

function rotationOf([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/// Unit quaternion w x y z of a rotation, by its largest component (Shepperd 1978).
function quaternionOf(r) {
  const trace = r[0][0] + r[1][1] + r[2][2];
  const candidates = [trace, r[0][0], r[1][1], r[2][2]];
  const k = candidates.indexOf(Math.max(...candidates));
  let q;
  if (k === 0) q = [1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
  if (k === 1) q = [r[2][1] - r[1][2], 1 + r[0][0] - r[1][1] - r[2][2], r[0][1] + r[1][0], r[0][2] + r[2][0]];
  if (k === 2) q = [r[0][2] - r[2][0], r[0][1] + r[1][0], 1 + r[1][1] - r[0][0] - r[2][2], r[1][2] + r[2][1]];
  if (k === 3) q = [r[1][0] - r[0][1], r[0][2] + r[2][0], r[1][2] + r[2][1], 1 + r[2][2] - r[0][0] - r[1][1]];
  const size = Math.hypot(...q);
  return q.map((part) => part / size);
}

/// Turn vector (axis times angle) of a rotation.
function turnVector(r) {
  const [w, x, y, z] = quaternionOf(r);
  const s = Math.hypot(x, y, z);
  if (s < 1e-15) return [0, 0, 0];
  const angle = 2 * Math.atan2(s, Math.abs(w)) * Math.sign(w || 1);
  return scaled(angle / s, [x, y, z]);
}

/// Angles about z, y, x, in this order (rad), and back.
function yawPitchRoll(r) {
  return [Math.atan2(r[1][0], r[0][0]), Math.atan2(-r[2][0], Math.hypot(r[0][0], r[1][0])), Math.atan2(r[2][1], r[2][2])];
}
const fromYawPitchRoll = ([yaw, pitch, roll]) =>
  product(turnAbout([0, 0, 1], yaw), product(turnAbout([0, 1, 0], pitch), turnAbout([1, 0, 0], roll)));

/// The motion a part t of the way from one to another: straight, by one turn.
function between(a, b, t) {
  const turn = turnVector(product(b.r, transposed(a.r)));
  const angle = norm(turn);
  const r = angle < 1e-12 ? a.r : product(turnAbout(scaled(1 / angle, turn), t * angle), a.r);
  return { r, p: add(scaled(1 - t, a.p), scaled(t, b.p)) };
}
