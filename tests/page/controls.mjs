// SPDX-License-Identifier: GPL-3.0-or-later
// Search, verdicts, keys and links: what a reader does to find a claim.
import assert from "node:assert/strict";

const shown = (page) => page.$$eval("article.claim", (all) => all.filter((a) => a.checkVisibility()).map((a) => a.id));
const count = (page) => page.textContent("#count");
const focused = (page) => page.evaluate(() => document.activeElement.id);
const is_open = (page) => page.$eval("[id='claim:closed'] details", (details) => details.open);

async function is_revealed(page, id) {
  await page.evaluate(async () => {
    for (let frame = 0; frame < 4; ++frame) await new Promise(requestAnimationFrame);
  });
  const box = await page.locator(`[id='${id}']`).boundingBox();
  assert.ok(box, `${id} is not shown`);
  assert.ok(box.y >= 0 && box.y < 900, `${id} is at ${box.y}, out of sight`);
  const covered = await page.$eval(`[id='${id}'] h3`, (heading) => {
    const { left, top } = heading.getBoundingClientRect();
    return !heading.contains(document.elementFromPoint(left + 1, top + 3));
  });
  assert.ok(!covered, `something covers ${id}`);
}

export const controls = [
  {
    name: "a search finds ids, titles, places and statements, and counts",
    async check(page) {
      assert.equal(await count(page), "14 claims");
      for (const [words, id] of [["SMOOTH the", "smooth"], ["cos(u - v)", "wave"], ["(1)", "binomial"], ["side.sq", "sides.side.square"]]) {
        await page.fill("#query", words);
        assert.deepEqual(await shown(page), [`claim:${id}`], words);
        assert.equal(await count(page), "1 of 14 claims");
      }
      await page.fill("#query", "no such words");
      assert.equal(await count(page), "0 of 14 claims");
      await page.fill("#query", "");
      assert.equal(await count(page), "14 claims");
      assert.equal(await page.locator("details[open]").count(), 0);
    },
  },
  {
    name: "each verdict can be left out; the address keeps it, and leads there again",
    async check(page) {
      await page.click("button[data-verdict=proven]");
      assert.equal(await count(page), "5 of 14 claims");
      await page.click("button[data-verdict=conditional]");
      await page.fill("#query", "corner");
      assert.deepEqual(await shown(page), ["claim:wrong"]);
      await page.goto(page.url());
      await page.reload();
      assert.deepEqual(await shown(page), ["claim:wrong"]);
      assert.equal(await page.getAttribute("button[data-verdict=proven]", "aria-pressed"), "false");
      await page.fill("#query", "");
      await page.click("button[data-verdict=proven]");
      await page.click("button[data-verdict=conditional]");
      assert.equal(new URL(page.url()).hash, "");
    },
  },
  {
    name: "keys lead to the search, out of it, from claim to claim, and fold",
    async check(page) {
      await page.keyboard.press("/");
      assert.equal(await focused(page), "query");
      await page.keyboard.type("jk");
      assert.equal(await page.inputValue("#query"), "jk");
      await page.keyboard.press("Escape");
      assert.equal(await page.inputValue("#query"), "");
      await page.keyboard.press("j");
      assert.equal(await focused(page), "claim:smooth");
      await page.keyboard.press("j");
      assert.equal(await focused(page), "claim:closed");
      await is_revealed(page, "claim:closed");
      await page.keyboard.press("Enter");
      assert.equal(await is_open(page), true);
      await page.keyboard.press("Enter");
      assert.equal(await is_open(page), false);
      await page.keyboard.press("k");
      assert.equal(await focused(page), "claim:smooth");
    },
  },
  {
    name: "everything unfolds at once, and folds",
    async check(page) {
      await page.click("#unfold");
      assert.equal(await page.$$eval("#claims details:not([open])", (all) => all.length), 0);
      await page.click("#unfold");
      assert.equal(await page.$$eval("#claims details[open]", (all) => all.length), 0);
    },
  },
  {
    name: "a mark in a table leads to the claim of its cell",
    async check(page) {
      await page.click("td a[href='#claim:sides.area.square']");
      await is_revealed(page, "claim:sides.area.square");
    },
  },
  {
    name: "a link leads to a claim that is filtered out",
    async check(page) {
      await page.fill("#query", "rests");
      await page.click("[id='claim:rests'] dd a[href='#claim:wave']");
      await is_revealed(page, "claim:wave");
    },
  },
  {
    name: "an address leads to a claim that is folded away",
    at: "#claim:sides.side.square",
    check: (page) => is_revealed(page, "claim:sides.side.square"),
  },
];
