// Over a wide area: heights are heights, drawn larger and said so; a pair is told horizontally and in height.
import assert from 'node:assert/strict';
import type { Page } from 'playwright-core';
import { pageTest, projected, settled } from './opened_page';

const kPlain = (text: string): string => text.replace(/[\u202f\u00a0]/g, ' ').replaceAll('\u2212', '-').replaceAll(',', '');

async function fact(page: Page, panel: string, label: string): Promise<string> {
  const rows = page.locator(`.${panel} .facts > div`).filter({ has: page.locator('dt', { hasText: new RegExp(`^${label}$`) }) });
  return kPlain(await rows.locator('dd').innerText());
}

async function choose(page: Page, name: string): Promise<void> {
  await page.fill('#search', name);
  await page.keyboard.press('Enter');
}

pageTest('an aircraft far from the middle has its height', 'wide', {}, async ({ page }) => {
  for (const [name, feet] of [['WEST', 31000], ['EAST', 39000], ['DLH4AB', 36000]] as const) {
    await choose(page, name);
    const told = await fact(page, 'selection', 'height');
    const [inFeet, metres] = [parseFloat(told), Number(/· ([\d.]+) m$/.exec(told)?.[1])];
    assert.ok(Math.abs(metres - 0.3048 * feet) < 1, `${name} is told at ${told}`);
    assert.ok(Math.abs(inFeet - feet) <= 4, `${name} is told at ${told}`);
  }
});

pageTest('from the side those of one height are on one level, and those above are above', 'wide', {}, async ({ page }) => {
  await page.keyboard.press('r');
  await page.keyboard.press('s');
  await settled(page);
  const ys: number[] = [];
  for (const bee of [0, 1, 2, 3]) ys.push((await projected(page, bee))?.y ?? NaN);
  const [dlh, ryr, west, east] = ys;
  assert.ok(east < ryr && ryr < dlh && dlh < west, ys.join(', '));
  // In the order of the numbers, to a pixel or two of what is left of perspective.
  const perFoot = (west - east) / 8000;
  assert.ok(Math.abs(west - dlh - 5000 * perFoot) < 0.1 * (west - east), ys.join(', '));
  const ticks = await page.locator('.axis-tick:visible').allInnerTexts();
  assert.ok(ticks.filter((text) => /ft$/.test(text)).length >= 2, ticks.join(' | '));
});

pageTest('lengths along the ground are in nautical miles, and heights in feet', 'wide', {}, async ({ page }) => {
  await page.keyboard.press('r');
  await settled(page);
  const ticks = await page.locator('.axis-tick').allTextContents();
  assert.ok(ticks.some((text) => text.endsWith('NM')) && ticks.some((text) => text.endsWith('ft')) && !ticks.some((text) => text.endsWith('m')), ticks.join(', '));
  assert.match(await page.locator('.scale-bar').innerText(), /NM, heights/);
});

pageTest('heights are drawn larger, which is said and can be changed', 'wide', {}, async ({ page }) => {
  const said = kPlain(await page.locator('.scale-bar').innerText());
  const lift = Number(await page.locator('#lift').inputValue());
  assert.ok(lift > 1);
  assert.ok(said.endsWith(`heights ×${lift}`), said);
  await page.keyboard.press('r');
  await page.keyboard.press('s');
  const gap = async (): Promise<number> => ((await projected(page, 2))?.y ?? NaN) - ((await projected(page, 3))?.y ?? NaN);
  const before = await gap();
  await page.locator('#lift').selectOption('1');
  const after = await gap();
  assert.ok(Math.abs(after * lift - before) < 0.2 * before, `${before} and ${after} pixels`);
  // It says so with the next picture.
  await page.waitForFunction(() => !document.querySelector('.scale-bar')?.textContent?.includes('heights'));
});

pageTest('the worst pair is marked and framed, horizontally and in height', 'wide', {}, async ({ page }) => {
  assert.equal(await page.locator('.who-they-are').innerText(), 'DLH4AB and RYR81K');
  assert.equal(await page.locator('.marker:not([hidden])').count(), 2);
  const box = await page.locator('.stage canvas').boundingBox();
  const at = await projected(page, 0);
  assert.ok(box && at);
  assert.ok(Math.hypot(at.x - box.x - box.width / 2, at.y - box.y - box.height / 2) < 0.3 * box.height);
  assert.match(await fact(page, 'pair', 'In height'), /300 ft · 91\.4\d m/);
  assert.ok(parseFloat(await fact(page, 'pair', 'Horizontally')) < 5);
  assert.equal(await page.locator('.pair .facts .risky').count(), 2);
  assert.match(kPlain(await page.locator('.time-says').innerText()), /[\d.]+ NM · [\d.]+ m horizontally 300 ft · 91\.4\d m in height/);
  // Two curves, each with its limit.
  for (const where of ['.plot', '.pair-chart']) {
    assert.equal(await page.locator(`${where} .curve`).count(), 2);
    assert.deepEqual((await page.locator(`${where} .limit-text`).allTextContents()).map(kPlain), ['5 NM', '1000 ft']);
  }
});

pageTest('the summary has both separations of the closest two, each with its limit', 'wide', {}, async ({ page }) => {
  assert.equal(await fact(page, 'summary', 'Closest encounter'), 'DLH4AB and RYR81K');
  assert.match(await fact(page, 'summary', 'horizontally'), /^[\d.]+ NM · [\d.]+ k?m limit 5 NM$/);
  assert.match(await fact(page, 'summary', 'in height'), /^300 ft · 91\.4\d m limit 1000 ft$/);
  assert.equal(await page.locator('.summary .facts .risky').count(), 2);
});

pageTest('a replay goes from before to after, slowly in the middle, and rests', 'recording', {}, async ({ page }) => {
  const time = (): Promise<number> => page.evaluate(() => Number(document.documentElement.dataset.timeS));
  const closest = await time();
  await page.evaluate(() => {
    const seen: [number, number][] = [];
    Object.assign(window, { seen });
    new MutationObserver(() => seen.push([performance.now(), Number(document.documentElement.dataset.timeS)])).observe(
      document.documentElement, { attributes: true, attributeFilter: ['data-time-s'] });
  });
  await page.locator('.pair').getByRole('button', { name: /Replay/ }).click();
  await page.waitForFunction((end) => Number(document.documentElement.dataset.timeS) >= end, closest + 4.99, { timeout: 60000 });
  await page.waitForTimeout(100);
  const ended = await time();
  await page.waitForTimeout(200);
  assert.equal(await time(), ended);
  const seen = await page.evaluate(() => (window as unknown as { seen: [number, number][] }).seen);
  assert.ok(seen[0][1] <= Math.max(0, closest - 4.5), `begins at ${seen[0][1]} s`);
  const took = (from: number, to: number): number => {
    const within = seen.filter(([, t]) => t >= from && t <= to);
    return (within[within.length - 1][0] - within[0][0]) / (within[within.length - 1][1] - within[0][1]);
  };
  assert.ok(took(closest - 0.9, closest + 0.9) > 2 * took(closest + 1.2, closest + 4.8), 'slow motion is slower');
});
