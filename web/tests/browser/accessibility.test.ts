// axe finds nothing serious, in either theme, empty or with a bee selected.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import type { AxeResults } from 'axe-core';
import { pageTest } from './opened_page';

const kAxe = readFileSync('node_modules/axe-core/axe.min.js', 'utf8');

for (const name of ['snapshot', 'compared-snapshots', 'recording', 'compared-recordings', 'fleet', 'wide', 'show']) {
  pageTest('axe is content', name, {}, async ({ page }) => {
    await page.evaluate(kAxe);
    const look = (): Promise<string[]> =>
      page.evaluate(async () => {
        const { axe } = window as unknown as { axe: { run: () => Promise<AxeResults> } };
        const { violations } = await axe.run();
        return violations
          .filter(({ impact }) => impact === 'serious' || impact === 'critical')
          .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html.slice(0, 160)).join(' | ')}`);
      });
    assert.deepEqual(await look(), []);
    await page.keyboard.press('n');
    await page.keyboard.press('d');
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
    assert.deepEqual(await look(), []);
  });
}
