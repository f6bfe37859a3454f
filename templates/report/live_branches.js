// Branches by name: the signs of the choices that the derivation's tree makes, one digit of a branch's number for each.

const armAngleSigns = [
  { name: "elbow", values: 2, meet: "stretched or folded" },
  { name: "shoulder", values: 2, meet: "first and third axis in line" },
  { name: "wrist", values: 2, meet: "first and last axis in line" },
];

function branchDigits(signs, branch) {
  const digits = signs.map(() => 0);
  for (let i = signs.length - 1; i >= 0; --i) {
    digits[i] = branch % signs[i].values;
    branch = Math.floor(branch / signs[i].values);
  }
  return digits;
}

/// "θ₁ +, θ₃ −, wrist +"; empty where the solutions of an elimination have no order by signs.
function branchName(signs, branch) {
  const digits = branchDigits(signs, branch);
  const value = (i) => (signs[i].values > 2 ? `root ${digits[i] + 1}` : digits[i] === 0 ? "+" : "−");
  return signs.map((sign, i) => `${sign.name} ${value(i)}`).join(", ");
}

/// Says in words where two branches that differ by one sign meet.
function meetingName(signs, a, b) {
  const [one, other] = [branchDigits(signs, a), branchDigits(signs, b)];
  const differ = signs.filter((_, i) => one[i] !== other[i]);
  if (differ.length !== 1) return "";
  const clauses = differ[0].meet.split("; ");
  const clause = clauses.find((text) => text.includes("coincide")) ?? clauses[0];
  return `${differ[0].name}: ${clause.replace(/: the two solutions coincide$/, "")}`;
}

/// Which rows are about to be one, and which have a joint that is free.
function meetings(signs, joints, rows) {
  const said = [];
  rows.forEach((a, i) => rows.slice(i + 1).forEach((b) => {
    if (a.branch === b.branch || apart(joints, a.q, b.q) > 0.05) return;
    const where = meetingName(signs, a.branch, b.branch);
    said.push(`branches ${a.branch} and ${b.branch} meet${where ? ` (${where})` : ""}`);
  }));
  return said;
}
