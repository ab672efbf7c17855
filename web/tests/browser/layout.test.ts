// At three sizes: nothing wider than the window, no control over another; pictures for people to look at.
import assert from 'node:assert/strict';
import { kArtefacts, pageTest } from './opened_page';

const kSizes = [
  [1440, 900],
  [1024, 768],
  [390, 844],
] as const;

/** Controls that lie over one another, in words. */
function overlapping(): string[] {
  const boxes = [...document.querySelectorAll('.head > *, .toolbar > * > *, .time-controls > *')]
    .map((one) => ({ one, box: one.getBoundingClientRect() }))
    .filter(({ box }) => box.width > 2);
  return boxes.flatMap((a, i) =>
    boxes
      .slice(i + 1)
      .filter((b) => {
        const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
        const high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
        return wide > 1 && high > 1 && !a.one.contains(b.one) && !b.one.contains(a.one);
      })
      .map((b) => `${a.one.className || a.one.textContent} over ${b.one.className || b.one.textContent}`),
  );
}

for (const name of ['snapshot', 'recording', 'compared-snapshots', 'compared-recordings']) {
  pageTest('fits windows large and small', name, {}, async ({ page }) => {
    for (const [width, height] of kSizes) {
      await page.setViewportSize({ width, height });
      await page.keyboard.press(width === 1440 ? 'r' : 'n');
      await page.waitForTimeout(150);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width);
      assert.deepEqual(await page.evaluate(overlapping), []);
      await page.screenshot({ path: `${kArtefacts}/${name}-${width}x${height}.png` });
      await page.keyboard.press('d');
    }
  });
}

pageTest('prints', 'snapshot', {}, async ({ page }) => {
  await page.pdf({ path: `${kArtefacts}/snapshot.pdf`, format: 'A4' });
});
