// Times are told in the zone that was named, or as they stand in the file; what is recorded has one name throughout.
import assert from 'node:assert/strict';
import { kArtefacts, pageTest } from './opened_page';

pageTest('while clocks are set back, each time has its offset', 'zoned', {}, async ({ page }) => {
  const now = page.locator('.time-now');
  // The two meet when clocks are set back: at 01:00 UTC.
  assert.match(await now.innerText(), /^2024-10-27 02:00:00(\.0+)? \+01:00$/);
  await page.keyboard.press('Home');
  assert.match(await now.innerText(), /^2024-10-27 02:00:00(\.0+)? \+02:00$/);
  await page.keyboard.press('End');
  assert.match(await now.innerText(), /^2024-10-27 03:00:00(\.0+)? \+01:00$/);
  const moments = await page.locator('.plot .level-text').allTextContents();
  assert.ok(moments.includes('local') && moments.filter((text) => text === '02:00').length === 2, moments.join(', '));
  assert.match(await page.locator('.about').innerText(), /Europe\/Berlin/);
  assert.doesNotMatch(await page.locator('body').innerText(), /UTC/);
  await page.screenshot({ path: `${kArtefacts}/zoned.png` });
});

pageTest('what names no zone is told as it stands in the file', 'unnamed', {}, async ({ page }) => {
  assert.match(await page.locator('.time-now').innerText(), /^2024-07-01 12:00:20(\.0+)?$/);
  assert.match(await page.locator('.pair').innerText(), /at 2024-07-01 12:00:20/);
  assert.match(await page.locator('[aria-label="Conflicts"] tbody, .pairs tbody').first().innerText(), /12:00:20/);
  const said = await page.locator('.panels').innerText();
  assert.doesNotMatch(said.replace(/--time-zone UTC/g, ''), /UTC/);
  await page.screenshot({ path: `${kArtefacts}/unnamed.png` });
});

pageTest('drones are called so throughout', 'show', {}, async ({ page }) => {
  assert.equal(await page.locator('#search').getAttribute('placeholder'), 'Find a drone');
  await page.keyboard.press('?');
  assert.match(await page.locator('.help').innerText(), /Click a drone to see its numbers/);
  assert.doesNotMatch(await page.locator('body').innerText(), /\bbees?\b/i);
  const named = await page.evaluate(() => Array.from(document.querySelectorAll('[title], [aria-label]'), (one) => `${one.getAttribute('title')} ${one.getAttribute('aria-label')}`));
  assert.deepEqual(named.filter((text) => /\bbees?\b/i.test(text)), []);
});
