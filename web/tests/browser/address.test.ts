// The address of the page: it follows what is seen, and opens it again.
import assert from 'node:assert/strict';
import type { Page } from 'playwright-core';
import { pageTest, projected, selectedBee, settled } from './opened_page';

const kTime = (page: Page): Promise<number> => page.evaluate(() => Number(document.documentElement.dataset.timeS));

async function reopened(page: Page, address: string): Promise<void> {
  // Another hash alone would not load the page anew.
  await page.goto('about:blank');
  await page.goto(address);
  await page.waitForSelector('html[data-beespace="ready"]');
  await settled(page);
}

pageTest('a page that was only opened has no state in its address', 'recording', {}, async ({ page }) => {
  await page.waitForTimeout(500);
  assert.equal(new URL(page.url()).hash, '');
});

pageTest('time, selection, camera and filter are in the address, and come back', 'recording', {}, async ({ page }) => {
  await page.locator('.pairs tbody tr').nth(3).click();
  await page.keyboard.press('.');
  await page.keyboard.press('o');
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => /camera=/.test(location.hash) && /only=risk/.test(location.hash));
  await page.waitForTimeout(400);
  const bee = await selectedBee(page);
  const [time, at] = [await kTime(page), await projected(page, Number(bee))];
  const pair = await page.locator('.who-they-are').innerText();
  assert.ok(at);
  await reopened(page, page.url());
  assert.equal(await selectedBee(page), bee);
  assert.equal(await page.locator('.who-they-are').innerText(), pair);
  assert.ok(Math.abs((await kTime(page)) - time) < 2e-3);
  assert.ok(await page.locator('#only-at-risk').isChecked());
  const again = await projected(page, Number(bee));
  assert.ok(again && Math.hypot(again.x - at.x, again.y - at.y) < 2, `${at.x}, ${at.y} and ${again?.x}, ${again?.y}`);
});

pageTest('a link to a moment opens it, one that is none opens the page', 'recording', {}, async ({ page }) => {
  const own = page.url();
  await reopened(page, `${own}#t=2.5&bees=7`);
  assert.equal(await kTime(page), 2.5);
  assert.equal(await selectedBee(page), '7');
  await reopened(page, `${own}#t=a&bees=9999999&camera=1,2&group=77,8`);
  assert.ok((await page.locator('.pairs tbody tr').count()) > 0);
  // In the open page too.
  await page.evaluate(() => (location.hash = '#t=1.25&bees=3,4'));
  await page.waitForFunction(() => Number(document.documentElement.dataset.timeS) === 1.25);
  assert.equal(await selectedBee(page), '3');
});

pageTest('the link to this moment is copied', 'recording', {}, async ({ page }) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.getByRole('button', { name: /Copied|See address/ }).waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText().catch(() => location.href));
  assert.match(copied, /recording\.html#t=[\d.]+&bees=\d+,\d+&camera=/);
});

pageTest('the link to this moment of two that are compared opens both there', 'compared-recordings', {}, async ({ page }) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.locator('.pairs tbody tr').nth(2).click();
  await page.keyboard.press('ArrowRight');
  await page.locator('.legend select').first().selectOption('speed');
  await settled(page);
  const bee = Number(await selectedBee(page));
  const seen = async (): Promise<({ x: number; y: number } | null)[]> => [await projected(page, bee, 0), await projected(page, bee, 1)];
  const [time, before] = [await kTime(page), await seen()];
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.getByRole('button', { name: /Copied|See address/ }).waitFor();
  await reopened(page, await page.evaluate(() => navigator.clipboard.readText().catch(() => location.href)));
  assert.ok(Math.abs((await kTime(page)) - time) < 2e-3);
  assert.equal(await selectedBee(page), String(bee));
  assert.equal(await page.locator('.legend select').last().inputValue(), 'speed');
  const after = await seen();
  before.forEach((at, swarm) => {
    const again = after[swarm];
    assert.ok(at && again && Math.hypot(again.x - at.x, again.y - at.y) < 2, `swarm ${swarm}: ${at?.x}, ${at?.y} and ${again?.x}, ${again?.y}`);
  });
});
