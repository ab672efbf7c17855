// What is seen: those at risk in red where they are, and nothing red where none is at risk.
import assert from 'node:assert/strict';
import { headOf, pageTest, projected, settled } from './opened_page';
import { canvasClip, redPixels } from './pixels';

for (const name of ['snapshot', 'cylinder', 'hundred-thousand', 'million']) {
  pageTest('shows the closest pair in red', name, {}, async ({ page }) => {
    await settled(page);
    const { risk } = await headOf(page);
    assert.ok(risk.closest);
    for (const bee of [risk.closest.first, risk.closest.second]) {
      const at = await projected(page, bee);
      assert.ok(at);
      const red = await redPixels(page, { x: Math.round(at.x) - 4, y: Math.round(at.y) - 4, width: 9, height: 9 });
      assert.ok(red >= 2, `${red} red pixels at bee ${bee}`);
    }
  });
}

pageTest('shows nothing red where no bee is at risk', 'calm', {}, async ({ page }) => {
  await settled(page);
  assert.equal(await redPixels(page, await canvasClip(page)), 0);
});

pageTest('has a histogram with those at risk, and only those, before the threshold', 'snapshot', {}, async ({ page }) => {
  const bars = await page.evaluate(() => {
    const x = (one: Element): number => Number(one.getAttribute('x') ?? one.getAttribute('x1'));
    const of = (kind: string): [number, string][] =>
      [...document.querySelectorAll(`.histogram ${kind}`)].map((one) => [x(one), String(one.getAttribute('height'))]);
    return { limit: of('.limit')[0][0], all: of('.bar:not(.risk)'), risk: of('.bar.risk') };
  });
  assert.ok(bars.risk.length > 5 && bars.all.length > bars.risk.length);
  assert.deepEqual(bars.risk, bars.all.filter(([x]) => x < bars.limit - 0.01));
});

pageTest('shows both swarms', 'compared-snapshots', {}, async ({ page }) => {
  await settled(page);
  for (const swarm of [0, 1]) assert.ok((await redPixels(page, await canvasClip(page, swarm))) > 50);
  assert.equal(await page.locator('.summary thead th').count(), 3);
});

pageTest('has all numbers without WebGL', 'snapshot', {
  before: 'HTMLCanvasElement.prototype.getContext = () => null;',
}, async ({ page, complaints }) => {
  // Three.js says so on the console before it gives up.
  complaints.splice(0, complaints.length, ...complaints.filter((text) => !/WebGL/.test(text)));
  assert.match(await page.locator('.stage .message').innerText(), /cannot draw in three dimensions/);
  await page.locator('.pairs tbody tr').first().click();
  assert.ok(await page.locator('[data-selected-bee]').count());
  complaints.splice(0, complaints.length, ...complaints.filter((text) => !/WebGL/.test(text)));
});

for (const name of ['snapshot', 'recording']) {
  pageTest('opens without DecompressionStream and fromBase64', name, {
    before: 'delete window.DecompressionStream; delete Uint8Array.fromBase64;',
  }, async ({ page }) => {
    assert.ok((await page.locator('.pairs tbody tr').count()) > 0);
  });
}

pageTest('comes back when the graphics card does', 'snapshot', {}, async ({ page, complaints }) => {
  await settled(page);
  const clip = await canvasClip(page);
  const before = await redPixels(page, clip);
  assert.ok(before > 50);
  const lose = (what: 'loseContext' | 'restoreContext'): Promise<void> =>
    page.evaluate((act) => {
      const one = window as unknown as { lost?: WEBGL_lose_context | null };
      one.lost ??= document.querySelector<HTMLCanvasElement>('.stage canvas')?.getContext('webgl2')?.getExtension('WEBGL_lose_context') ?? null;
      one.lost?.[act]();
    }, what);
  await lose('loseContext');
  await page.waitForSelector('.lost');
  await lose('restoreContext');
  await page.waitForSelector('.lost', { state: 'detached' });
  await settled(page);
  assert.equal(await redPixels(page, clip), before);
  // Three.js tells the console that it was lost.
  complaints.splice(0, complaints.length, ...complaints.filter((text) => !/Context Lost/.test(text)));
});

pageTest('follows the theme of the system where the reader has not chosen the other', 'snapshot', {}, async ({ page }) => {
  const becomes = async (system: 'dark' | 'light', theme: 'dark' | 'light'): Promise<void> => {
    await page.emulateMedia({ colorScheme: system });
    await page.waitForFunction((dark) => matchMedia('(prefers-color-scheme: dark)').matches === dark, system === 'dark');
    // The page hears of it with the next frame.
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), theme);
  };
  await becomes('dark', 'dark');
  await becomes('light', 'light');
  await page.keyboard.press('d');
  await becomes('light', 'dark');
  await becomes('dark', 'dark');
  await becomes('light', 'light');
});
