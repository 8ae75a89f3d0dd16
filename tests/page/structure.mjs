// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader without eyes, without scripts or with paper has of the page.
import assert from "node:assert/strict";

async function none(page, selector) {
  const found = await page.$$eval(selector, (all) => all.map((e) => e.outerHTML.slice(0, 120)));
  assert.deepEqual(found, [], selector);
}

export const structure = [
  {
    name: "landmarks and headings are in order",
    async check(page) {
      for (const landmark of ["main", "body > header", "nav[aria-label]", "form[role=search]", "h1"])
        assert.equal(await page.locator(landmark).count(), 1, landmark);
      const levels = await page.$$eval("h1, h2, h3, h4, h5, h6", (all) => all.map((h) => Number(h.tagName[1])));
      assert.equal(levels[0], 1);
      levels.forEach((level, i) => assert.ok(i === 0 || level <= levels[i - 1] + 1, `heading ${i} leaves a level out`));
      await none(page, "main section:not([aria-labelledby])");
      assert.equal(await page.getAttribute("html", "lang"), "en");
    },
  },
  {
    name: "everything that can be used has a name, and headers of tables a direction",
    async check(page) {
      await page.click("#unfold");
      await page.locator("figure.surface").first().scrollIntoViewIfNeeded();
      await page.waitForSelector("canvas");
      for (const role of ["button", "link", "searchbox", "group", "img", "region"])
        for (const one of await page.getByRole(role).all())
          assert.match(await one.evaluate((e) => {
            const labelled = e.getAttribute("aria-labelledby");
            const label = labelled ? document.getElementById(labelled).textContent : e.getAttribute("aria-label");
            return label || (e.labels && e.labels[0] && e.labels[0].textContent) || e.textContent;
          }), /\w/, `a ${role} has no name`);
      await none(page, "th:not([scope])");
      await none(page, ":not([aria-label]) > table");
      const ids = await page.$$eval("[id]", (all) => all.map((e) => e.id));
      assert.equal(new Set(ids).size, ids.length, "two elements have the same id");
    },
  },
  {
    name: "every link within the page leads somewhere",
    async check(page) {
      const lost = await page.$$eval("a[href^='#']", (all) =>
        all.map((a) => decodeURIComponent(a.getAttribute("href").slice(1))).filter((id) => !document.getElementById(id)));
      assert.deepEqual(lost, []);
    },
  },
  {
    name: "every formula is MathML",
    async check(page) {
      await none(page, ".formula > code");
      assert.ok((await page.locator(".formula > math").count()) > 20);
      await none(page, "math:empty");
    },
  },
  {
    name: "everything can be read without scripts",
    javaScriptEnabled: false,
    async check(page) {
      assert.equal(await page.locator("#controls").isVisible(), false);
      assert.equal(await page.locator("canvas").count(), 0);
      assert.equal(await page.locator("figure").count(), 2);
      for (const figure of await page.locator("figure svg").all()) assert.ok(await figure.isVisible());
      await page.locator("details.cells > summary").click();
      for (const claim of await page.locator("article").all()) {
        assert.ok(await claim.isVisible());
        const details = claim.locator("details");
        if ((await details.count()) === 0) continue;
        await details.first().locator("> summary").click();
        assert.ok(await details.first().locator("li").first().isVisible());
      }
    },
  },
  {
    name: "on paper nothing is left out but what answers to hands",
    async check(page) {
      await page.emulateMedia({ media: "print" });
      for (const gone of ["#controls", "nav", ".skip"]) assert.equal(await page.locator(gone).isVisible(), false, gone);
      for (const claim of await page.locator("article.claim").all()) assert.ok(await claim.isVisible());
    },
  },
];
