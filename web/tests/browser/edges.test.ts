// Swarms with hardly a bee in them still make a page.
import assert from 'node:assert/strict';
import { pageTest } from './opened_page';

for (const name of ['line', 'one-bee', 'same-place', 'one-fix-each']) {
  pageTest('opens', name, {}, async ({ page }) => {
    for (const key of ['n', 'f', 'r', 't', 's', 'o', 'g', ' ', '.', ']', 'l', 'End']) await page.keyboard.press(key);
    assert.ok(await page.locator('.summary .headline').count());
    assert.ok(!/NaN|Infinity|undefined/.test(await page.locator('body').innerText()));
    const drawn = await page.locator('.histogram svg, .plot svg').evaluateAll((all) => all.map((one) => new XMLSerializer().serializeToString(one)).join());
    assert.ok(!/NaN|Infinity/.test(drawn));
  });
}
