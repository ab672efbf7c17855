// Time: the line moves bees, plays, and goes to conflicts.
import assert from 'node:assert/strict';
import type { Page } from 'playwright-core';
import { pageTest, projected } from './opened_page';

const kTime = (page: Page): Promise<number> => page.evaluate(() => Number(document.documentElement.dataset.timeS));

for (const name of ['recording', 'compared-recordings']) {
  pageTest('the time line moves bees', name, {}, async ({ page }) => {
    await page.keyboard.press('Home');
    const before = await projected(page, 3);
    const plot = page.locator('.plot');
    const box = await plot.boundingBox();
    assert.ok(box);
    await page.mouse.click(box.x + box.width * 0.6, box.y + 30);
    assert.ok((await kTime(page)) > 0);
    const after = await projected(page, 3);
    assert.notDeepEqual(before, after);
    await page.keyboard.press('Home');
    assert.equal(await kTime(page), 0);
  });
}

pageTest('it opens at the worst moment, and plays from the beginning', 'recording', {}, async ({ page }) => {
  const opened = await kTime(page);
  assert.ok(await page.locator('.time-says').getByText('in conflict').count());
  await page.locator('.pairs tbody tr').first().click();
  assert.equal(await kTime(page), opened);
  // Chosen by hand, the same moment is one to play from.
  await page.keyboard.press(' ');
  await page.waitForTimeout(200);
  await page.keyboard.press(' ');
  assert.ok((await kTime(page)) > opened);
  await page.reload();
  await page.waitForSelector('html[data-beespace="ready"]');
  await page.keyboard.press(' ');
  await page.waitForTimeout(200);
  await page.keyboard.press(' ');
  const played = await kTime(page);
  assert.ok(played > 0 && played < opened, `played to ${played} s, opened at ${opened} s`);
});

pageTest('it plays, steps, goes to conflicts and shows trails', 'recording', {}, async ({ page }) => {
  await page.keyboard.press(' ');
  await page.waitForTimeout(500);
  await page.keyboard.press(' ');
  const paused = await kTime(page);
  assert.ok(paused > 0);
  await page.waitForTimeout(100);
  assert.equal(await kTime(page), paused);
  await page.keyboard.press('.');
  assert.ok((await kTime(page)) > paused);
  await page.keyboard.press(',');
  assert.ok(Math.abs((await kTime(page)) - paused) < 0.01);

  // A conflict of the table goes to its moment, and its bees are in conflict then, as close as the table says.
  await page.keyboard.press('Home');
  const row = page.locator('.pairs tbody tr').first();
  await row.click();
  assert.ok((await kTime(page)) > 0);
  assert.ok((await page.locator('.time-says').innerText()).includes(`closest two ${await row.locator('td').nth(2).innerText()}`));
  assert.ok(await page.locator('.selection .facts .risky').count());

  // Brackets go from conflict to conflict.
  await page.keyboard.press('End');
  await page.keyboard.press('[');
  const last = await kTime(page);
  await page.keyboard.press('[');
  assert.ok((await kTime(page)) < last);
  await page.keyboard.press(']');
  assert.ok(Math.abs((await kTime(page)) - last) < 1e-6);

  await page.keyboard.press('l');
  assert.ok(await page.locator('#trails').isChecked());
});
