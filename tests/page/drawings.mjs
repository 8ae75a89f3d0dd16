// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings that turn.
import assert from "node:assert/strict";

// What is seen of the drawing: a number for each picture, and the part of it that is not ground.
async function picture(page) {
  const png = await page.locator("canvas").first().screenshot();
  return page.evaluate(async (bytes) => {
    const image = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
    const flat = new OffscreenCanvas(image.width, image.height).getContext("2d");
    flat.drawImage(image, 0, 0);
    const pixels = new Uint32Array(flat.getImageData(0, 0, image.width, image.height).data.buffer);
    const ground = pixels[8 * image.width + 8];
    return { number: pixels.reduce((number, pixel) => (number * 31 + pixel) % 1000003, 0),
      part: pixels.filter((pixel) => pixel !== ground).length / pixels.length };
  }, [...png]);
}

async function first_drawing(page) {
  await page.locator("figure.surface").first().scrollIntoViewIfNeeded();
  const canvas = page.locator("canvas").first();
  await canvas.waitFor();
  return canvas;
}

export const drawings = [
  {
    name: "a drawing takes the place of its picture, and turns by hand and by key",
    async check(page) {
      const canvas = await first_drawing(page);
      assert.equal(await page.locator("figure.surface .still").first().isVisible(), false);
      let last = await picture(page);
      assert.ok(last.part > 0.1 && last.part < 0.9, `${last.part} of it is painted`);
      const changes = async (what, action) => {
        await action();
        const next = await picture(page);
        assert.notEqual(next.number, last.number, `${what} changes nothing`);
        assert.ok(next.part > 0.02, `${what} leaves nothing`);
        last = next;
      };
      const first = last;
      const { x, y, width, height } = await canvas.boundingBox();
      await changes("a drag", async () => {
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down();
        await page.mouse.move(x + width / 2 + 60, y + height / 2 + 30, { steps: 4 });
        await page.mouse.up();
      });
      for (const key of ["ArrowLeft", "ArrowUp", "+"]) await changes(key, () => canvas.press(key));
      await changes("Hide lines", () => page.getByRole("button", { name: "Hide lines" }).first().click());
      await changes("Show lines", () => page.getByRole("button", { name: "Show lines" }).first().click());
      await changes("Reset", () => page.getByRole("button", { name: "Reset the view" }).first().click());
      assert.equal(last.number, first.number);
    },
  },
  {
    name: "the picture stays where a browser has no WebGL",
    async check(page) {
      await page.addInitScript(() => {
        HTMLCanvasElement.prototype.getContext = () => null;
      });
      await page.reload();
      await page.locator("figure.surface").first().scrollIntoViewIfNeeded();
      assert.equal(await page.locator("canvas").count(), 0);
      assert.ok(await page.locator("figure.surface svg").first().isVisible());
    },
  },
];
