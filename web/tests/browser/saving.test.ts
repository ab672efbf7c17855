// What can be taken away from a page: pictures and tables; and the small things on the way there.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { pageTest, projected, settled } from './opened_page';

async function saved(page: Page, press: () => Promise<void>): Promise<{ name: string; bytes: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent('download'), press()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

pageTest('saves what is seen as a picture', 'snapshot', {}, async ({ page }) => {
  const { name, bytes } = await saved(page, () => page.getByRole('button', { name: 'PNG' }).click());
  assert.equal(name, 'named.png');
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  const box = await page.locator('.stage canvas').boundingBox();
  assert.ok(box && Math.abs(bytes.readUInt32BE(16) - box.width) <= 1 && Math.abs(bytes.readUInt32BE(20) - box.height) <= 1);
  // Not an empty one: those at risk are in it, in red.
  const red = await page.context().newPage().then(async (blank) => {
    const found = await blank.evaluate(async (text) => {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context?.drawImage(bitmap, 0, 0);
      const data = context?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? [];
      let pixels = 0;
      for (let i = 0; i < data.length; i += 4) if (data[i] > 130 && data[i] > 2.2 * data[i + 1] && data[i] > 2.2 * data[i + 2]) ++pixels;
      return pixels;
    }, bytes.toString('base64'));
    await blank.close();
    return found;
  });
  assert.ok(red > 500, `${red} red pixels`);
});

pageTest('saves the rows of the table as they are filtered', 'snapshot', {}, async ({ page }) => {
  await page.locator('#group').selectOption({ index: 1 });
  const range = await page.locator('.pairs .range').innerText();
  const count = Number(/of ([\d,]+)$/.exec(range)?.[1].replace(',', ''));
  const { name, bytes } = await saved(page, () => page.getByRole('button', { name: 'Save as CSV' }).click());
  assert.equal(name, 'named.csv');
  const [head, ...rows] = bytes.toString().trimEnd().split('\r\n').map((row) => row.split(','));
  assert.deepEqual(head, ['first', 'second', 'distance_m', 'horizontal_m', 'height_m']);
  assert.equal(rows.length, count);
  const shown = await page.locator('.pairs tbody tr').first().locator('td').allInnerTexts();
  assert.deepEqual(rows[0].slice(0, 2), shown.slice(0, 2));
  for (const [, , distance, horizontal, height] of rows.map((row) => row.map(Number))) {
    assert.ok(distance < 100 && Math.abs(Math.hypot(horizontal, height) - distance) < 0.1);
  }
});

pageTest('ids that a spreadsheet would take for formulas are harmless there', 'hostile', {}, async ({ page }) => {
  const { bytes } = await saved(page, () => page.getByRole('button', { name: 'Save as CSV' }).click());
  assert.doesNotMatch(bytes.toString(), /(^|,)"?[=+@]/m);
});

pageTest('a group flies into view', 'snapshot', {}, async ({ page }) => {
  await page.keyboard.press('r');
  await settled(page);
  const before = await projected(page, 3);
  await page.locator('#group').selectOption({ index: 2 });
  await settled(page);
  assert.notDeepEqual(await projected(page, 3), before);
  const text = await page.locator('.pairs tbody tr').first().locator('td').first().innerText();
  await page.fill('#search', text);
  assert.ok(await page.locator('#search-offers li').count());
});

pageTest('space plays whatever was clicked before, but for who came by the keyboard', 'recording', {}, async ({ page }) => {
  const plays = (): Promise<boolean> => page.evaluate(() => document.querySelector('.play')?.getAttribute('aria-label') === 'Pause');
  for (const clicked of ['#trails', '.view-buttons button', '.pairs tbody .link']) {
    await page.locator(clicked).first().click();
    const before = await page.locator('#trails').isChecked();
    await page.keyboard.press(' ');
    assert.ok(await plays(), clicked);
    assert.equal(await page.locator('#trails').isChecked(), before);
    await page.keyboard.press(' ');
    assert.ok(!(await plays()), clicked);
  }
  const checked = await page.locator('#trails').isChecked();
  await page.locator('.time-controls select').focus();
  await page.keyboard.press('Tab');
  await page.keyboard.press(' ');
  assert.equal(await page.locator('#trails').isChecked(), !checked);
  assert.ok(!(await plays()));
});

pageTest('the bee under the cursor is named', 'snapshot', {}, async ({ page }) => {
  const name = await page.locator('[data-selected-name]').getAttribute('data-selected-name');
  const bee = Number(await page.locator('[data-selected-bee]').getAttribute('data-selected-bee'));
  await page.keyboard.press('Escape');
  await settled(page);
  const at = await projected(page, bee);
  assert.ok(at && name);
  await page.mouse.move(at.x - 60, at.y - 60);
  await page.mouse.move(at.x, at.y);
  await page.locator('.hover-tag:not([hidden])').waitFor();
  assert.match(await page.locator('.hover-tag').innerText(), /at risk, [\d,.]+.m/);
});

pageTest('on a phone the verdict and the closest pair come first', 'wide', { width: 390, height: 844 }, async ({ page }) => {
  const top = async (what: string): Promise<number> => (await page.locator(what).first().boundingBox())?.y ?? Infinity;
  const [verdict, closest, canvas, pairs] = [await top('.headline'), await top('.summary .link'), await top('.stage canvas'), await top('.pairs')];
  assert.ok(verdict < closest && closest < canvas && canvas < pairs, [verdict, closest, canvas, pairs].join(', '));
  assert.ok(closest < 300);
});

pageTest('choosing scrolls nowhere', 'compared-recordings', { height: 700 }, async ({ page }) => {
  await page.locator('.pairs tbody tr').nth(2).click();
  const scrolled = await page.evaluate(() => [scrollY, document.documentElement.scrollTop, document.querySelector('.column')?.scrollTop, document.querySelector('.stages')?.scrollTop]);
  assert.deepEqual(scrolled, [0, 0, 0, 0]);
});

pageTest('what the time line says of a time that is pointed at', 'wide', {}, async ({ page }) => {
  const box = await page.locator('.plot').boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 2, box.y + 30);
  const tip = (await page.locator('.plot-tip:not([hidden])').innerText()).replaceAll('\u202f', ' ');
  assert.match(tip, /s\n\d+ in conflict\n[\d.]+ NM · .* m horizontally, 300 ft · 91\.44 m in height( at .*)?: .*DLH4AB.* and .*RYR81K/);
  await page.mouse.move(5, 5);
  assert.equal(await page.locator('.plot-tip:not([hidden])').count(), 0);
});
