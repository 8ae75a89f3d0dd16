// SPDX-License-Identifier: GPL-3.0-or-later
// node page.mjs PROJECT SEAMPROOF CHROMIUM FOLDER
//
// Makes the page of page.seam and looks at it in a browser: each check of the lists below has a page of
// its own to itself. What is not as it says is printed; the status is 1 then.
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { controls } from "./controls.mjs";
import { drawings } from "./drawings.mjs";
import { looks } from "./looks.mjs";
import { structure } from "./structure.mjs";

const [project, seamproof, chromium, folder] = process.argv.slice(2);
const require = createRequire(join(project, "tests/node/package.json"));
const driver = require("playwright-core").chromium;

function make() {
  try {
    execFileSync(seamproof, ["verify", join(project, "tests/page/page.seam"), "--out", folder, "--html", "--quiet"]);
  } catch (failure) {
    if (failure.status !== 1) throw failure; // the file holds what is refuted against expectation
  }
  return pathToFileURL(join(folder, "report.html")).href;
}

// Every message is a fault but what a driver of a graphics card says of its speed.
const is_fault = (message) => !/GL Driver Message.*(Performance|GPU stall)/.test(message.text());

async function run(browser, address, { name, check, ...options }) {
  const { at = "", width = 1280, ...context } = options;
  const shown = await browser.newContext({ viewport: { width, height: 900 }, reducedMotion: "reduce", ...context });
  const page = await shown.newPage();
  const faults = [];
  page.on("console", (message) => is_fault(message) && faults.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => faults.push(`script: ${error.message}`));
  page.on("request", (request) => request.url() !== address && faults.push(`request: ${request.url()}`));
  try {
    await page.goto(address + at);
    await check(page);
  } catch (error) {
    faults.push(error.message);
  }
  await shown.close();
  for (const fault of faults) console.error(`${name}: ${fault}`);
  return faults.length === 0;
}

const browser = await driver.launch({
  executablePath: chromium,
  args: [
    "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  ],
});
const address = make();
let good = true;
for (const one of [...structure, ...controls, ...drawings, ...looks]) good = (await run(browser, address, one)) && good;
await browser.close();
process.exit(good ? 0 : 1);
