// How long the first frame takes and how fast frames follow is printed, not asserted: machines are shared.
// Asserted is that it was the work that counts: the frame comes before the panels, frames and steps show something new.
import assert from 'node:assert/strict';
import { pageTest, projected, settled, type Hook } from './opened_page';
import type { Page } from 'playwright-core';

async function firstFrame(page: Page): Promise<number> {
  return page.evaluate(() => performance.getEntriesByName('beespace: first frame')[0].startTime);
}

function rate(page: Page, frames: number): Promise<number> {
  return page.evaluate((count) => (window as unknown as { beespace: Hook }).beespace.framesPerSecond(count), frames);
}

pageTest('the swarm is seen before its panels are made', 'million', {}, async ({ page }, tell) => {
  const drawn = await firstFrame(page);
  const ready = await page.evaluate(() => performance.now());
  await settled(page);
  tell(`first frame ${Math.round(drawn)} ms, all panels by ${Math.round(ready)} ms`);
  tell(`${(await rate(page, 5)).toFixed(1)} frames/s while it turns`);
  assert.ok(drawn < ready);
});

const kNoteLinks = `
  globalThis.linked = [];
  const { linkProgram } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.linkProgram = function (program) {
    if (performance.getEntriesByName('beespace: first frame').length === 0) globalThis.linked.push(this.canvas.width);
    linkProgram.call(this, program);
  };`;

for (const name of ['hundred-thousand', 'recording']) {
  pageTest('the graphics card makes the programs of the first frame before the swarm is there', name, { before: kNoteLinks }, async ({ page }) => {
    const widths = await page.evaluate(() => (globalThis as unknown as { linked: number[] }).linked);
    assert.ok(widths.length >= 4, `${widths.length} programs`);
    // A canvas of one pixel is not the one that is seen.
    assert.deepEqual(widths.filter((width) => width !== 1), []);
  });
}

pageTest('it turns', 'hundred-thousand', {}, async ({ page }, tell) => {
  await settled(page);
  const before = await projected(page, 3);
  const frames = await rate(page, 20);
  assert.notDeepEqual(await projected(page, 3), before);
  tell(`first frame ${Math.round(await firstFrame(page))} ms, ${frames.toFixed(1)} frames/s`);
});

pageTest('a long recording opens and goes on', 'long-recording', {}, async ({ page }, tell) => {
  tell(`first frame ${Math.round(await firstFrame(page))} ms`);
  await page.keyboard.press('Home');
  const before = await projected(page, 3);
  const took = await page.evaluate(async () => {
    const begins = performance.now();
    for (let i = 0; i < 10; ++i) {
      document.body.dispatchEvent(new KeyboardEvent('keydown', { key: '.', bubbles: true }));
      (window as unknown as { beespace: Hook }).beespace.settle();
    }
    return (performance.now() - begins) / 10;
  });
  tell(`a step of time in ${took.toFixed(0)} ms`);
  assert.notDeepEqual(await projected(page, 3), before);
});
