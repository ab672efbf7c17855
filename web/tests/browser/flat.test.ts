// What has no heights is shown from above, and no height is told of it.
import assert from 'node:assert/strict';
import { kArtefacts, pageTest, projected, settled } from './opened_page';

pageTest('it says that it is in two dimensions, and offers no side and no heights', 'flat', {}, async ({ page }) => {
  assert.match(await page.locator('.flat-word').innerText(), /In two dimensions: the input has no heights/);
  const buttons = await page.locator('.view-buttons button').allInnerTexts();
  assert.ok(!buttons.includes('Side') && !buttons.includes('Top'), buttons.join(', '));
  assert.equal(await page.locator('#lift').count(), 0);
  const names = await page.locator('.axis-name').allInnerTexts();
  assert.deepEqual(names, ['x', 'y']);
  await page.keyboard.press('?');
  assert.doesNotMatch(await page.locator('.help').innerText(), /from the side/);
});

pageTest('a square looks like one, also after keys that turn elsewhere', 'flat', {}, async ({ page }) => {
  await page.keyboard.press('r');
  for (const key of ['', 's', 'ArrowLeft', 'ArrowUp']) {
    if (key) await page.keyboard.press(key);
    await settled(page);
    const corners = await Promise.all([0, 1, 2].map((bee) => projected(page, bee)));
    const [a, b, c] = corners.map((corner) => corner ?? { x: NaN, y: NaN });
    assert.ok(Math.abs(a.y - b.y) < 1.5 && Math.abs(b.x - c.x) < 1.5, JSON.stringify(corners));
    assert.ok(Math.abs(b.x - a.x - (b.y - c.y)) < 2.5 && b.x - a.x > 50, JSON.stringify(corners));
  }
});

pageTest('a picture is drawn as it is, y downward', 'video', {}, async ({ page }) => {
  await page.keyboard.press('r');
  await settled(page);
  const [a, b] = await Promise.all([0, 1].map((bee) => projected(page, bee)));
  assert.ok(a && b && a.x < b.x && a.y < b.y, JSON.stringify([a, b]));
  assert.doesNotMatch(await page.locator('.about').innerText(), /mirror/);
  await page.screenshot({ path: `${kArtefacts}/video.png` });
});

pageTest('neither bees nor pairs have a height', 'flat', {}, async ({ page }) => {
  const pair = await page.locator('.pair .facts dt').allInnerTexts();
  assert.ok(pair.includes('Apart') && !pair.includes('In height') && !pair.includes('Horizontally'), pair.join(', '));
  const bee = await page.locator('.selection .facts dt').allInnerTexts();
  assert.ok(bee.includes('x') && bee.includes('y') && !bee.includes('z'), bee.join(', '));
  assert.match(await page.locator('.about').innerText(), /the input has none: distances are those in the plane/);
  await page.screenshot({ path: `${kArtefacts}/flat.png` });
});
