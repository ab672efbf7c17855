// Time: the line moves bees, plays, and goes to conflicts.
import assert from 'node:assert/strict';
import type { Page } from 'playwright-core';
import { kArtefacts, pageTest, projected } from './opened_page';

/** Without what isolates names. */
const plain = (text: string | null): string => (text ?? '').replace(/[\u2066-\u2069]/g, '').replace(/[\u202f\u00a0]/g, ' ');

const kTime = (page: Page): Promise<number> => page.evaluate(() => Number(document.documentElement.dataset.timeS));

/** Waits until time has gone beyond this. */
const later = async (page: Page, time_s: number): Promise<void> => {
  await page.waitForFunction((time) => Number(document.documentElement.dataset.timeS) > time, time_s);
};

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
  await later(page, opened);
  await page.keyboard.press(' ');
  await page.reload();
  await page.waitForSelector('html[data-beespace="ready"]');
  await page.keyboard.press(' ');
  await page.waitForFunction((time) => Number(document.documentElement.dataset.timeS) < time, opened);
  await page.keyboard.press(' ');
  const played = await kTime(page);
  assert.ok(played < opened, `played to ${played} s, opened at ${opened} s`);
});

pageTest('it plays, steps, goes to conflicts and shows trails', 'recording', {}, async ({ page }) => {
  await page.keyboard.press('Home');
  await page.keyboard.press(' ');
  await later(page, 0);
  await page.keyboard.press(' ');
  const paused = await kTime(page);
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

  assert.ok(!(await page.locator('#trails').isChecked()));
  await page.keyboard.press('l');
  assert.ok(await page.locator('#trails').isChecked());
});

pageTest('at its end all bees are where their last fixes were', 'end', {}, async ({ page }) => {
  await page.keyboard.press('End');
  for (let bee = 0; bee < 4; ++bee) assert.ok(await projected(page, bee), `bee ${bee} is gone`);
});

pageTest('of few it opens with trails, and the address says where a reader wants none', 'again', {}, async ({ page }) => {
  const trails = page.locator('#trails');
  assert.ok(await trails.isChecked());
  await page.keyboard.press('l');
  assert.ok(!(await trails.isChecked()));
  await page.waitForFunction(() => location.hash.includes('trails=0'));
  await page.reload();
  await page.waitForSelector('html[data-beespace="ready"]');
  assert.ok(!(await trails.isChecked()));
});

pageTest('keys go through all conflicts of a pair', 'again', {}, async ({ page }) => {
  const rows = page.locator('.pairs tbody tr');
  const count = await rows.count();
  const ofAB = await rows.filter({ hasText: 'a' }).count();
  assert.ok(ofAB > 2 && count > ofAB, `${ofAB} of ${count} conflicts`);
  await page.keyboard.press('Escape');
  for (let place = 0; place < count; ++place) {
    await page.keyboard.press('n');
    const marked = await page.locator('.pairs tbody tr[aria-current]').evaluateAll((all) => all.map((one) => (one as HTMLElement).dataset.place));
    assert.deepEqual(marked, [String(place)]);
  }
  await page.keyboard.press('p');
  assert.equal(await page.locator('.pairs tbody tr[aria-current]').getAttribute('data-place'), String(count - 2));
});

pageTest('says nothing of two bees that are away', 'again', {}, async ({ page }) => {
  const box = await page.locator('.plot svg').first().boundingBox();
  assert.ok(box);
  // From 40 to 60 of 120 s a and b are away; the plot has margins of 52 and 12 pixels.
  await page.mouse.click(box.x + 52 + (box.width - 64) * (50 / 120), box.y + 30);
  const says = await page.locator('.time-says').innerText();
  assert.equal(plain(says), '0 in conflict · unknown where a and b are · closest two unknown here');
});

pageTest('time in which bees are unknown is hatched, and said', 'again', {}, async ({ page }) => {
  const plot = page.locator('.plot');
  // Of the closest two, and of who is in conflict.
  const hatched = await plot.locator('.unknown').evaluateAll((all) => all.map((one) => one.getBoundingClientRect()).map(({ left, width }) => [left, width]));
  const box = await plot.locator('> svg').boundingBox();
  assert.ok(box && hatched.length === 2, JSON.stringify(hatched));
  // The plot has margins of 66 and 12 pixels.
  for (const [left, width] of hatched) {
    assert.ok(Math.abs(left - box.x - 66 - (box.width - 78) * (40 / 120)) < 3, `begins at ${left}`);
    assert.ok(Math.abs(width - (box.width - 78) * (20 / 120)) < 4, `${width} wide`);
  }
  const words = plain(await plot.locator('> svg').textContent());
  assert.match(words, /closest two.*unknown where hatched/);
  assert.match(words, /unknown here/);
  assert.match(words, /at once, up to 2 unknown \(hatched\)/);
  assert.match((await plot.getAttribute('aria-label')) ?? '', /^Time; in a stretch of it not all bees are known, which is hatched$/);

  await page.mouse.move(hatched[0][0] + hatched[0][1] / 2, box.y + 30);
  assert.match(plain(await plot.locator('.plot-tip').innerText()), /unknown where a and b are\s+closest two unknown here: another may be closer/);
  await page.mouse.down();
  await page.mouse.up();
  assert.match(plain(await plot.getAttribute('aria-valuetext')), /, unknown where a and b are$/);
  // At the fixes around the gap they are known.
  await page.keyboard.press('Home');
  assert.doesNotMatch(plain(await plot.getAttribute('aria-valuetext')), /unknown/);
  for (const theme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme: theme });
    await plot.screenshot({ path: `${kArtefacts}/unknown-${theme}.png` });
  }
});

pageTest('names the closest, also where others are chosen', 'again', {}, async ({ page }) => {
  // In its closest moment, with 4 m, a and b are 3 m apart.
  await page.locator('.pairs tbody tr').filter({ hasText: 'c' }).click();
  assert.match((await page.locator('.time-says').innerText()).replaceAll('\u202f', ' '), /closest two 3\.00 m/);
});

pageTest('what is said of a moment is of that moment, not of the sample before it', 'slow', {}, async ({ page }) => {
  // From 9 km two fly towards each other, at 1 m/s each; between two samples there are 10 s.
  const box = await page.locator('.plot > svg').boundingBox();
  assert.ok(box);
  for (const share of [0.101, 0.287, 0.433, 0.659]) {
    const at = [box.x + 66 + (box.width - 78) * share, box.y + 30] as const;
    await page.mouse.move(...at);
    const told = [plain(await page.locator('.plot-tip').innerText())];
    await page.mouse.click(...at);
    told.push(`${plain(await page.locator('.time-now').innerText())}\n${plain(await page.locator('.time-says').innerText())}`);
    for (const text of told) {
      const [time, apart] = [/^([\d., ]+)\s?s/, /([\d., ]+)\s?m[ :]/].map((form) => Number((form.exec(text)?.[1] ?? '').replace(/[, ]/g, '')));
      assert.ok(Math.abs(apart - (9000 - 2 * time)) < 3, text);
      assert.doesNotMatch(text, / at /);
    }
  }
});
