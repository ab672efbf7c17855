// How long the first frame takes and how fast frames follow; printed, not asserted: machines are shared.
import assert from 'node:assert/strict';
import { pageTest, settled, type Hook } from './opened_page';
import type { Page } from 'playwright-core';

async function firstFrame(page: Page): Promise<number> {
  return page.evaluate(() => performance.getEntriesByName('beespace: first frame')[0].startTime);
}

function rate(page: Page, frames: number): Promise<number> {
  return page.evaluate((count) => (window as unknown as { beespace: Hook }).beespace.framesPerSecond(count), frames);
}

pageTest('the first frame comes soon', 'million', {}, async ({ page }, tell) => {
  const drawn = await firstFrame(page);
  const ready = await page.evaluate(() => performance.now());
  await settled(page);
  tell(`first frame ${Math.round(drawn)} ms, all panels by ${Math.round(ready)} ms`);
  tell(`${(await rate(page, 5)).toFixed(1)} frames/s while it turns`);
  assert.ok(drawn > 0);
});

pageTest('it turns smoothly', 'hundred-thousand', {}, async ({ page }, tell) => {
  await settled(page);
  const frames = await rate(page, 20);
  tell(`first frame ${Math.round(await firstFrame(page))} ms, ${frames.toFixed(1)} frames/s`);
  assert.ok(frames > 0);
});

pageTest('a long recording opens and goes on', 'long-recording', {}, async ({ page }, tell) => {
  tell(`first frame ${Math.round(await firstFrame(page))} ms`);
  const took = await page.evaluate(async () => {
    const begins = performance.now();
    for (let i = 0; i < 10; ++i) {
      document.body.dispatchEvent(new KeyboardEvent('keydown', { key: '.', bubbles: true }));
      (window as unknown as { beespace: Hook }).beespace.settle();
    }
    return (performance.now() - begins) / 10;
  });
  tell(`a step of time in ${took.toFixed(0)} ms`);
  assert.ok(took > 0);
});
