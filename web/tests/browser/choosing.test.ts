// Choosing a bee, by click, search, table and keys; sorting and filtering.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { headOf, kPages, pageTest, projected, selectedBee, settled, type Hook } from './opened_page';

const kTexts = (page: Page, column: number): Promise<string[]> =>
  page.locator(`.pairs tbody td:nth-child(${column})`).allInnerTexts();

for (const name of ['snapshot', 'million']) {
  pageTest('a click on a bee at risk selects it, a search its number', name, {}, async ({ page }) => {
    const { risk } = await headOf(page);
    assert.ok(risk.closest);
    // From near by no other bee lies in between.
    await page.keyboard.press('1');
    await page.keyboard.press('Escape');
    assert.equal(await selectedBee(page), null);
    await settled(page);
    const at = await projected(page, risk.closest.first);
    assert.ok(at);
    await page.mouse.click(at.x, at.y);
    const chosen = Number(await selectedBee(page));
    assert.ok([risk.closest.first, risk.closest.second].includes(chosen), `bee ${chosen}`);

    if (name !== 'million') return;
    await page.locator('#search').fill('777777');
    await page.waitForSelector('#search-offers li[data-offer]');
    await page.keyboard.press('Enter');
    assert.equal(await selectedBee(page), '777777');
  });
}

pageTest('a bee is where its row of the input says', 'snapshot', {}, async ({ page }) => {
  const rows = readFileSync(`${kPages}/data/named.csv`, 'utf8').trimEnd().split('\n').slice(1);
  for (const row of [rows[0], rows[499], rows[999]]) {
    const [id, longitude, latitude, height] = row.split(',');
    await page.locator('#search').fill(id);
    await page.waitForSelector('#search-offers li[data-offer]');
    await page.keyboard.press('Enter');
    const fact = async (label: string): Promise<number> => {
      const found = page.locator('.selection .facts div').filter({ has: page.getByText(label, { exact: true }) });
      return parseFloat((await found.locator('dd').innerText()).replace('\u2212', '-').replaceAll(',', ''));
    };
    const off_m = [
      (await fact('longitude') - Number(longitude)) * 111_000,
      (await fact('latitude') - Number(latitude)) * 111_000,
      (await fact('height')) - Number(height),
    ];
    assert.ok(off_m.every((off) => Math.abs(off) < 0.1), `${id} is off by ${off_m.join(', ')} m`);
  }
});

pageTest('a row of the table selects its pair and flies there', 'snapshot', { reducedMotion: false }, async ({ page }) => {
  const row = page.locator('.pairs tbody tr').nth(2);
  await row.click();
  assert.equal(await row.getAttribute('aria-current'), 'true');
  const chosen = Number(await selectedBee(page));
  const box = await page.locator('.stage canvas').boundingBox();
  assert.ok(box);
  await page.waitForFunction(([bee, x, y, reach]) => {
    const at = (window as unknown as { beespace: Hook }).beespace.project(0, bee);
    return at && Math.hypot(at.x - x, at.y - y) < reach;
  }, [chosen, box.x + box.width / 2, box.y + box.height / 2, 0.3 * box.height] as const);
});

pageTest('the table sorts, turns its pages and keeps to a group', 'snapshot', {}, async ({ page }) => {
  const metres = async (): Promise<number[]> => (await kTexts(page, 3)).map((text) => parseFloat(text.replace(',', '')));
  const ascending = await metres();
  assert.deepEqual(ascending, ascending.slice().sort((a, b) => a - b));
  const head = page.locator('.pairs th').nth(2);
  assert.equal(await head.getAttribute('aria-sort'), 'ascending');
  await head.getByRole('button').click();
  assert.equal(await head.getAttribute('aria-sort'), 'descending');
  const descending = await metres();
  assert.deepEqual(descending, descending.slice().sort((a, b) => b - a));
  await page.locator('.pairs th').first().getByRole('button').click();
  const names = await kTexts(page, 1);
  assert.deepEqual(names, names.slice().sort((a, b) => a.localeCompare(b, 'en', { numeric: true })));
  const next = page.getByRole('button', { name: 'Next page of the table' });
  if (await next.isEnabled()) {
    await next.click();
    assert.match(await page.locator('.pairs .range').innerText(), /^51–/);
  }

  // A group fills the table with its pairs only.
  await page.locator('#group').selectOption({ index: 1 });
  const text = await page.locator('#group option:checked').innerText();
  const bees = Number(/: (\d+) bees/.exec(text)?.[1]);
  const grouped = new Set([...(await kTexts(page, 1)), ...(await kTexts(page, 2))]);
  assert.equal(grouped.size, bees);
});

pageTest('search finds a bee by its id', 'snapshot', {}, async ({ page }) => {
  const name = await page.locator('.pairs tbody td:nth-child(2)').first().innerText();
  await page.keyboard.press('/');
  await page.keyboard.type(name);
  await page.waitForSelector('#search-offers li');
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('[data-selected-name]').getAttribute('data-selected-name'), name);
});

pageTest('keys do what the help says', 'snapshot', {}, async ({ page }) => {
  await page.keyboard.press('?');
  assert.ok(await page.locator('dialog.help').isVisible());
  await page.keyboard.press('Escape');
  assert.ok(!(await page.locator('dialog.help').isVisible()));
  const { risk } = await headOf(page);
  await page.keyboard.press('Escape');
  await page.keyboard.press('n');
  assert.equal(await selectedBee(page), String(risk.closest?.first));
  await page.keyboard.press('Escape');
  assert.equal(await selectedBee(page), null);
  const before = await projected(page, 0);
  await page.keyboard.press('ArrowRight');
  const after = await projected(page, 0);
  assert.notDeepEqual(before, after);
  await page.keyboard.press('d');
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
  await page.keyboard.press('o');
  assert.ok(await page.locator('#only-at-risk').isChecked());
});
