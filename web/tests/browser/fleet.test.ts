// The log of a fleet: the ghost of the selected bee, its tube and its claim are seen, and contracts are told.
import assert from 'node:assert/strict';
import type { Page } from 'playwright-core';
import { pageTest, selectedBee, settled } from './opened_page';
import { canvasClip, violetPixels } from './pixels';

const kFact = async (page: Page, label: string): Promise<string | null> => {
  const rows = page.locator('.selection .facts > div').filter({ has: page.locator('dt', { hasText: new RegExp(`^${label}$`) }) });
  return (await rows.count()) === 1 ? rows.locator('dd').innerText() : null;
};

const kMetres = async (page: Page, label: string): Promise<number> => {
  const text = (await kFact(page, label)) ?? 'NaN';
  return parseFloat(text) * (text.endsWith('mm') ? 0.001 : 1);
};

pageTest('who was out of its contract is listed, and shown from when it was', 'fleet', {}, async ({ page }) => {
  const links = page.locator('.contracts .link');
  assert.ok((await links.count()) > 0);
  assert.match(await page.locator('.contracts .rule').innerText(), /of 20 bees out of contract at some time/);
  await links.first().click();
  assert.equal(await page.locator('.selection .who-it-is').innerText(), await links.first().innerText());
  assert.ok((await kFact(page, 'Contract'))?.includes('out'));
  assert.equal(await kFact(page, 'Certified'), 'no');
  assert.equal(await kFact(page, 'Why'), 'too far from its nominal place');
  assert.ok((await kMetres(page, 'Off its nominal place')) > (await kMetres(page, 'Tube')));
});

pageTest('a bee that keeps its contract is in its tube', 'fleet', {}, async ({ page }) => {
  const outcasts = await page.locator('.contracts .link').allInnerTexts();
  const sound = Array.from({ length: 20 }, (_, bee) => String(bee)).filter((bee) => !outcasts.includes(bee));
  await page.keyboard.press('Home');
  for (const bee of sound.slice(0, 3)) {
    await page.fill('#search', bee);
    await page.keyboard.press('Enter');
    assert.equal(await selectedBee(page), bee);
    await page.locator('.scene canvas').focus();
    for (let step = 0; step < 15; ++step) {
      await page.keyboard.press('.');
      const off_m = await kMetres(page, 'Off its nominal place');
      const tube_m = await kMetres(page, 'Tube');
      assert.ok(off_m <= tube_m + 0.01, `bee ${bee} is ${off_m} m off, of ${tube_m} m`);
    }
  }
});

pageTest('the ghost, its tube and its claim are drawn of the selected bee', 'fleet', {}, async ({ page }) => {
  await page.locator('.contracts .link').first().click();
  await settled(page);
  const seen = await violetPixels(page, await canvasClip(page));
  await page.keyboard.press('Escape');
  await settled(page);
  const unseen = await violetPixels(page, await canvasClip(page));
  assert.ok(seen > unseen + 300, `${seen} pixels against ${unseen}`);
});

pageTest('says nothing of contracts where nothing is known of them', 'recording', {}, async ({ page }) => {
  assert.equal(await page.locator('.contracts').count(), 0);
  await page.fill('#search', '3');
  await page.keyboard.press('Enter');
  assert.equal(await kFact(page, 'Contract'), null);
  assert.equal(await page.locator('.glyph-ghost').count(), 0);
});
