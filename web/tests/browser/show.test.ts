// What a drone show declares: limits, and how they are kept; cues; and what stands in its way.
import assert from 'node:assert/strict';
import { kArtefacts, pageTest, settled } from './opened_page';

const kPlain = (text: string): string => text.replace(/[\u202f\u00a0]/g, ' ');

pageTest('the greatest of each limit stands beside it, with who and when', 'show', {}, async ({ page }) => {
  const rows = await page.locator('.limits-kept tbody tr').allInnerTexts();
  const told = rows.map((row) => kPlain(row).split('\t').join(' | '));
  assert.match(told[0], /^Horizontal speed \| 8 m\/s \| 1\.250 m\/s \| Drone 1 at 15/);
  assert.match(told[2], /^Descent \| 2\.4 m\/s \| 2\.500 m\/s \| Drone 1 at 23/);
  assert.match(told[3], /^Height \| 120 m \| 10\.00 m \|/);
  assert.match(await page.locator('.panel.show .rule').innerText(), /Beyond what the show declares: 1 stretch\./);
  assert.equal(await page.locator('.limits-kept td.risky').count(), 1);
});

pageTest('the time line has its cues, and when it is beyond its limits', 'show', {}, async ({ page }) => {
  assert.ok((await page.locator('.plot .cue').count()) > 0);
  assert.ok((await page.locator('.plot .cue-name').allTextContents()).some((text) => text.includes('Ring')));
  assert.ok((await page.locator('.plot').textContent())?.includes('over limits'));
  assert.equal(await page.locator('.plot .strip').count(), 2);
  await page.locator('.cues button').first().click();
  const cues = await page.evaluate(() => JSON.parse(document.getElementById('beespace-page')?.textContent ?? '').swarms[0].cues);
  assert.equal(Number(await page.evaluate(() => document.documentElement.dataset.timeS)), Math.max(0, cues[0].time_s));
});

pageTest('one who is beyond a limit is shown when that is', 'show', {}, async ({ page }) => {
  await page.locator('.panel.show .neighbours button').first().click();
  const begins_s = await page.evaluate(() => JSON.parse(document.getElementById('beespace-page')?.textContent ?? '').swarms[0].time.begins_s);
  assert.equal(Number(await page.evaluate(() => document.documentElement.dataset.timeS)), 23 - begins_s);
  assert.equal(await page.evaluate(() => document.querySelector<HTMLElement>('[data-selected-name]')?.dataset.selectedName), 'Drone 1');
});

pageTest('what stands in the way is drawn, and named under the cursor', 'show', {}, async ({ page }) => {
  await page.keyboard.press('r');
  await page.keyboard.press('t');
  await settled(page);
  await page.screenshot({ path: `${kArtefacts}/show.png` });
  const box = await page.locator('canvas').first().boundingBox();
  assert.ok(box);
  const seen = new Set<string>();
  const found = (): boolean => seen.has('obstacles[0], a cylinder') && seen.has('obstacles[1], a box');
  for (let y = 0.05; y < 1 && !found(); y += 0.05) {
    for (let x = 0.05; x < 1 && !found(); x += 0.04) {
      await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
      const tag = page.locator('.hover-tag');
      if (await tag.isVisible()) seen.add(await tag.innerText());
    }
  }
  assert.ok(found(), [...seen].join(' | '));
  assert.match(await page.locator('.about').innerText(), /obstacles are drawn, and nothing is said of them/);
});

pageTest('the selected drone has its height and speeds over time, beside its limits', 'show', {}, async ({ page }) => {
  await page.fill('#search', 'Drone 1');
  await page.keyboard.press('Enter');
  const chart = page.locator('.selection .bee-chart');
  const curves = await chart.locator('.curve').evaluateAll((all) => all.map((one) => one.getAttribute('d') ?? ''));
  assert.equal(curves.length, 3);
  for (const curve of curves) assert.match(curve, /^M[\d.]+ [\d.]+(?:[LM][\d.]+ [\d.]+)+$/);
  const names = (await chart.locator('.row-name').allTextContents()).map(kPlain);
  assert.match(names[0], /^Height, m, limit 120$/);
  assert.match(names[1], /^Horizontal speed, m\/s, limit 8$/);
  assert.ok((await chart.locator('.limit-text').allTextContents()).includes('\u22122.4'));
  // It descends too fast once.
  assert.equal(await chart.locator('.band').count(), 1);
  assert.match(await page.locator('.selection .facts').innerText(), /Horizontal speed\s+[\d.]+.m\/s\s+Climb/);
  await chart.scrollIntoViewIfNeeded();
  const box = await chart.boundingBox();
  assert.ok(box);
  const before = await page.evaluate(() => document.documentElement.dataset.timeS);
  await page.mouse.click(box.x + 0.9 * box.width, box.y + box.height / 2);
  assert.notEqual(await page.evaluate(() => document.documentElement.dataset.timeS), before);
});

pageTest('those who are closest in the air come first, then who is with a drone on the ground', 'standing', {}, async ({ page }) => {
  const facts = kPlain(await page.locator('.panel.summary .facts').innerText()).replace(/[\u2066-\u2069]/g, '');
  assert.match(facts, /Closest encounter\s+11(\.0+)? m\s+lands and passes\s+Closest, one on the ground\s+1(\.0+)? m\s+spare and lands/i);
  // Each is shown when it is.
  const time = (): Promise<number> => page.evaluate(() => Number(document.documentElement.dataset.timeS));
  await page.locator('.panel.summary .who button').nth(1).click();
  assert.ok((await time()) > 8, `${await time()}`);
  assert.ok(await page.locator('.panel.pair').getByText(/^(In conflict for|This conflict lasts)$/).count());
  await page.locator('.panel.summary .who button').first().click();
  assert.ok((await time()) >= 6, `${await time()}`);
});
