// SPDX-License-Identifier: GPL-3.0-or-later
// Contrast and width, with everything unfolded.
import assert from "node:assert/strict";

// In the page: every text whose colour is too near to what lies behind it.
function faint() {
  const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
  const luminance = ([r, g, b]) =>
    [r, g, b].map((c) => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const over = (above, below, opacity) => above.slice(0, 3).map((c, i) => c * opacity + below[i] * (1 - opacity));
  function ground(element) {
    if (!element) return [255, 255, 255];
    const colour = numbers(getComputedStyle(element).backgroundColor);
    return colour.length === 4 && colour[3] === 0 ? ground(element.parentElement) : colour;
  }
  function opacity(element) {
    return element ? Number(getComputedStyle(element).opacity) * opacity(element.parentElement) : 1;
  }
  const found = new Set();
  for (const element of document.querySelectorAll("body *")) {
    const has_text = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
    if (!has_text || !element.checkVisibility() || element.closest("svg")) continue;
    const behind = ground(element);
    const colour = over(numbers(getComputedStyle(element).color), behind, opacity(element));
    const [low, high] = [luminance(colour), luminance(behind)].sort((a, b) => a - b);
    const contrast = (high + 0.05) / (low + 0.05);
    if (contrast < 4.5) found.add(`${element.tagName}.${element.className}: ${contrast.toFixed(2)}`);
  }
  return [...found];
}

const contrast = (colorScheme) => ({
  name: `all text can be told from its ground, ${colorScheme}`,
  colorScheme,
  async check(page) {
    const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.equal(Number(ground.match(/\d+/)[0]) < 128, colorScheme === "dark");
    await page.click("#unfold");
    await page.click("button[data-verdict=proven]");
    assert.deepEqual(await page.evaluate(faint), []);
    await page.click("button[data-verdict=proven]");
    assert.deepEqual(await page.evaluate(faint), []);
  },
});

const fits = (width) => ({
  name: `nothing is wider than a window of ${width}`,
  width,
  async check(page) {
    await page.click("#unfold");
    for (const details of await page.locator("details").all()) await details.evaluate((d) => (d.open = true));
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width);
  },
});

export const looks = [contrast("light"), contrast("dark"), fits(360), fits(768), fits(1280)];
