// What colours tell, velocity vectors, the measure tool, and the ground of wide areas.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { headOf, kPages, pageTest, projected, settled } from './opened_page';
import { canvasClip, coastPixels, redPixels } from './pixels';

const kPlain = (text: string): string => text.replace(/[\u202f\u00a0]/g, ' ').replaceAll(',', '');

async function clickBee(page: Page, bee: number): Promise<void> {
  const at = await projected(page, bee);
  assert.ok(at);
  await page.mouse.click(at.x, at.y);
}

async function measured(page: Page, label: string): Promise<number> {
  const row = page.locator('.measure-row').filter({ hasText: label });
  return parseFloat(kPlain(await row.locator('strong').innerText()));
}

for (const [name, exact_m] of [['snapshot', 0.1], ['cylinder', 0.1]] as const) {
  pageTest('the measure tool says of the closest pair what the engine says', name, {}, async ({ page }) => {
    const { risk } = (await headOf(page)) as unknown as { risk: { closest: { first: number; second: number; distance_m: number; horizontal_m: number; height_m: number } } };
    await settled(page);
    await page.keyboard.press('m');
    await clickBee(page, risk.closest.first);
    await clickBee(page, risk.closest.second);
    assert.equal(await page.locator('.measure .name').count(), 2);
    assert.ok(Math.abs((await measured(page, 'straight')) - risk.closest.distance_m) < exact_m);
    assert.ok(Math.abs((await measured(page, 'horizontally')) - risk.closest.horizontal_m) < exact_m);
    assert.ok(Math.abs((await measured(page, 'in height')) - risk.closest.height_m) < exact_m);
    await page.keyboard.press('Escape');
    assert.ok(!(await page.locator('.measure').isVisible()));
    // It was no selection, and what was selected still is.
    assert.equal(await page.locator('.marker:not([hidden])').count(), 2);
  });
}

pageTest('the measure tool follows bees as time goes on, and takes places on the floor', 'recording', {}, async ({ page }) => {
  await settled(page);
  const { risk } = await headOf(page);
  assert.ok(risk.closest);
  await page.keyboard.press('m');
  await clickBee(page, risk.closest.first);
  const box = await canvasClip(page);
  await page.keyboard.press('r');
  await settled(page);
  // In a corner of what is seen there is floor, and no bee.
  await page.mouse.click(box.x + box.width / 2, box.y + box.height - 60);
  const before = await measured(page, 'straight');
  assert.ok(before > 0);
  await page.keyboard.press('.');
  await page.keyboard.press('.');
  assert.notEqual(await measured(page, 'straight'), before);
});

pageTest('colours tell what the reader asks for', 'recording', {}, async ({ page }) => {
  await settled(page);
  const select = page.locator('.legend select');
  assert.deepEqual(await select.locator('option').evaluateAll((all) => all.map((one) => (one as HTMLOptionElement).value)), ['nearest', 'height', 'speed', 'group', 'none']);
  const picture = async (): Promise<string> => {
    await settled(page);
    return (await page.screenshot({ clip: await canvasClip(page) })).toString('base64');
  };
  const seen = new Set([await picture()]);
  for (const by of ['height', 'speed', 'group', 'none']) {
    await page.keyboard.press('c');
    assert.equal(await select.inputValue(), by);
    seen.add(await picture());
  }
  assert.equal(seen.size, 5);
  // Groups are told by the fill of those at risk; with any other meaning these are red.
  await select.selectOption('group');
  const inGroups = await redPixels(page, await canvasClip(page));
  await select.selectOption('height');
  assert.ok((await redPixels(page, await canvasClip(page))) > 1.5 * inGroups);
  assert.match(kPlain(await page.locator('.ramp-row').innerText()), /m$/);
});

pageTest('velocity vectors are drawn, and taken away', 'recording', {}, async ({ page }) => {
  const picture = async (): Promise<Buffer> => {
    await settled(page);
    return page.screenshot({ clip: await canvasClip(page) });
  };
  const without = await picture();
  await page.keyboard.press('v');
  assert.ok(await page.locator('#vectors').isChecked());
  assert.ok(!(await picture()).equals(without));
  await page.keyboard.press('v');
  assert.ok((await picture()).equals(without));
});

pageTest('coasts and borders lie on the floor of a wide area', 'wide', {}, async ({ page }) => {
  await page.keyboard.press('r');
  await settled(page);
  const found = await coastPixels(page, await canvasClip(page));
  assert.ok(found > 1000, `${found} pixels of coasts`);
  assert.match(await page.locator('.about').innerText(), /Natural Earth/);
});

pageTest('a local swarm has no coasts, and its page no weight of them', 'snapshot', {}, async ({ page }) => {
  assert.equal(await page.locator('#beespace-ground').count(), 0);
  assert.ok(statSync(`${kPages}/one-bee.html`).size + 50000 < statSync(`${kPages}/wide.html`).size);
});
