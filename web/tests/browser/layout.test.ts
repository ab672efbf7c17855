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

/** Texts of drawings that lie over one another or are cut at the edge, and legends that are cut. */
function illegible(): string[] {
  const faults: string[] = [];
  for (const svg of document.querySelectorAll('.histogram svg, .plot > svg, .compass')) {
    const room = svg.getBoundingClientRect();
    const texts = [...svg.querySelectorAll('text')]
      .map((one) => ({ text: one.textContent, box: one.getBoundingClientRect(), shown: getComputedStyle(one).opacity !== '0' }))
      .filter(({ shown, box }) => shown && box.width > 0);
    for (const { text, box } of texts) {
      if (box.left < room.left - 1.5 || box.right > room.right + 1.5) faults.push(`${text} is cut`);
    }
    texts.forEach((a, i) => {
      for (const b of texts.slice(i + 1)) {
        const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
        const high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
        // Boxes of lines have some air above and below the letters.
        if (wide > 1 && high > 4) faults.push(`${a.text} over ${b.text}`);
      }
    });
  }
  for (const legend of document.querySelectorAll('.legend')) {
    for (const row of legend.children) if (row.scrollWidth > row.clientWidth + 1) faults.push('a legend is cut');
  }
  return faults;
}

/** Names that are cut at an edge. */
function cutNames(): string[] {
  return [...document.querySelectorAll<HTMLElement>('.name')]
    .filter((one) => {
      for (let around: HTMLElement | null = one; around && around.clientWidth > 0 && around.id !== 'page'; around = around.parentElement) {
        if (getComputedStyle(around).overflowX === 'hidden' && around.scrollWidth > around.clientWidth + 1) return true;
      }
      return false;
    })
    .map((one) => one.textContent ?? '');
}

for (const name of ['snapshot', 'cylinder', 'recording', 'epoch', 'wide', 'fleet', 'compared-snapshots', 'compared-recordings']) {
  pageTest('fits windows large and small', name, {}, async ({ page }) => {
    for (const [width, height] of kSizes) {
      await page.setViewportSize({ width, height });
      await page.keyboard.press(width === 1440 ? 'r' : 'n');
      await page.waitForTimeout(150);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width);
      assert.deepEqual(await page.evaluate(overlapping), []);
      assert.deepEqual(await page.evaluate(illegible), []);
      assert.deepEqual(await page.evaluate(cutNames), []);
      // Where there is room beside the swarm, the page itself scrolls nowhere.
      if (width > 760) assert.deepEqual(await page.evaluate(() => [document.documentElement.scrollHeight, scrollY]), [height, 0]);
      await page.screenshot({ path: `${kArtefacts}/${name}-${width}x${height}.png` });
      await page.keyboard.press('d');
    }
  });
}

pageTest('prints', 'snapshot', {}, async ({ page }) => {
  await page.pdf({ path: `${kArtefacts}/snapshot.pdf`, format: 'A4' });
  const look = (): Promise<unknown> =>
    page.evaluate(() => {
      const scene = document.querySelector<HTMLElement>('.scene');
      return {
        theme: document.documentElement.dataset.theme,
        pictures: document.querySelectorAll('img.printed').length,
        onPaper: scene !== null && scene.clientWidth * Number(scene.style.zoom || 1) <= 690,
      };
    });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.deepEqual(await look(), { theme: 'light', pictures: 1, onPaper: true });
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.deepEqual(await look(), { theme: 'dark', pictures: 0, onPaper: false });
});
