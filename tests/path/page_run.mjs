// SPDX-License-Identifier: MIT
// page_run.mjs PAGE: prints the places of the tool that the page's own script draws, for each motion at its places.
import { readFileSync } from "node:fs";
import vm from "node:vm";

const text = readFileSync(process.argv[2], "utf8");
const script = text.slice(text.indexOf("<script>//<![CDATA[") + 19, text.lastIndexOf("//]]></script>"));
const data = JSON.parse(text.match(/id="path-data">(.*?)<\/script>/s)[1]);
const context = vm.createContext({ document: { getElementById: () => null }, data, Math });
const tools = vm.runInContext(
  `${script};
const player = Object.assign(Object.create(PathPlayer.prototype), { data, skeletonOf: numerics(data.arm).skeleton });
data.motions.map((motion, i) => motion.s.map((s) => [s, ...player.skeleton(i, s).tool.p]));`,
  context,
);
console.log(JSON.stringify(tools));
