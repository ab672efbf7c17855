// A page that was cut off or changed on its way says so; it never shows other numbers instead.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { adler32 } from '../../src/data/checksum';
import { kArtefacts, kPages, launched } from './opened_page';
import { randomFrom } from '../unit/random';

const kPage = readFileSync(`${kPages}/again.html`, 'latin1');
const kJson = '<script type="application/json" id="beespace-page">';

/** What a reader sees of such a page: the body's text, and whether it says that it is damaged. */
async function seen(html: string, prepare = (): void => {}): Promise<{ text: string; state: string; says: boolean }> {
  const file = `${kArtefacts}/damaged.html`;
  writeFileSync(file, html, 'latin1');
  const context = await (await launched()).newContext({ viewport: { width: 1200, height: 800 } });
  try {
    const page = await context.newPage();
    await page.addInitScript(prepare);
    await page.goto(pathToFileURL(file).href);
    const settled = (): boolean => ['ready', 'failed'].includes(document.documentElement.dataset.beespace ?? '');
    await page.waitForFunction(settled, null, { timeout: 4000 }).catch(() => null);
    const state = await page.evaluate(() => document.documentElement.dataset.beespace ?? '');
    // Without a program the page itself says it after a while.
    const says = async (): Promise<boolean> => /damaged/.test(await page.locator('body').innerText());
    if (state === '') await page.waitForFunction(() => /damaged/.test(document.body.innerText), null, { timeout: 9000 }).catch(() => null);
    return { text: await page.locator('body').innerText(), state, says: await says() };
  } finally {
    await context.close();
  }
}

function flipped(at: number): string {
  return kPage.slice(0, at) + String.fromCharCode(kPage.charCodeAt(at) ^ 1) + kPage.slice(at + 1);
}

const kWide = readFileSync(`${kPages}/wide.html`, 'latin1');
const kGround = kWide.indexOf('id="beespace-ground"');

for (const [what, html] of [
  ['with a flipped bit in its coasts', kWide.slice(0, kGround + 9000) + String.fromCharCode(kWide.charCodeAt(kGround + 9000) ^ 1) + kWide.slice(kGround + 9001)],
  ['whose coasts are missing', kWide.replace(/<script type="text\/plain" id="beespace-ground">[^<]*<\/script>/, '')],
] as const) {
  test(`a page ${what} says so`, async () => {
    assert.ok(kGround > 0);
    const { state, says } = await seen(html);
    assert.ok(says && state === 'failed', state);
  });
}

const kCode = kPage.indexOf('id="beespace-code"');
const kData = kPage.indexOf(kJson);

for (const [what, at] of [
  ['in its program', kCode + 5000],
  ['before its data', kData - 3],
  ['in its JSON', kData + 300],
  ['in a column', kPage.indexOf('id="beespace-3"') + 25],
  ['between columns', kPage.indexOf('<script type="text/plain" id="beespace-5"')],
  ['before its end', kPage.indexOf('<script type="text/plain" id="beespace-end"')],
] as const) {
  test(`a page that is cut off ${what} says so`, async () => {
    const { state, says } = await seen(kPage.slice(0, at));
    assert.ok(says && state !== 'ready', state);
  });
}

for (const [what, at] of [
  ['its threshold', kPage.indexOf('"threshold_m":') + 14],
  ['its program', kCode + 9000],
  ['the policy of its guard', kPage.indexOf("'sha256-") + 12],
  ['its policy', kPage.indexOf("'sha256-", kPage.indexOf("'sha256-") + 9) + 12],
  ['its style', kPage.indexOf('<style>') + 40],
  ['the loader', kPage.lastIndexOf('<script>', kData) + 30],
  ['the guard', kPage.indexOf('<script>') + 30],
  ['a column', kPage.indexOf('id="beespace-2"') + 22],
] as const) {
  test(`a page with a flipped bit in ${what} says so`, async () => {
    assert.ok(at > 30);
    const { state, says, text } = await seen(flipped(at));
    // Without its guard all is still as it was: the others are checked by the browser and by the program.
    const unguarded = what.endsWith('guard') && text === (await seen(kPage)).text;
    assert.ok(unguarded || (says && state !== 'ready'), `${state}: ${text.slice(0, 200)}`);
  });
}

test('a damaged page is not drawn by a program that starts before the guard has looked', async () => {
  const interactive = (): void => {
    Object.defineProperty(document, 'readyState', { get: () => 'interactive' });
  };
  const { state, says } = await seen(flipped(kPage.indexOf('<style>') + 40), interactive);
  assert.ok(says && state === 'failed', state);
  assert.equal((await seen(kPage, interactive)).state, 'ready');
});

test('a page whose counts contradict each other says so, though its checksum is right', async () => {
  const end = kPage.indexOf('</script>', kData);
  const json = kPage.slice(kData + kJson.length, end).replace('"count":4,', '"count":5,');
  assert.ok(json.includes('"count":5,'));
  const sum = adler32(Uint8Array.from(json, (c) => c.charCodeAt(0))).toString(16).padStart(8, '0');
  const rest = kPage.slice(end).replace(/(id="beespace-end">)[0-9a-f]{8}/, `$1${sum}`);
  const { state, text } = await seen(kPage.slice(0, kData) + kJson + json + rest);
  assert.equal(state, 'failed');
  assert.match(text, /damaged: its numbers of bees contradict each other/);
});

test('no flipped bit anywhere in the data shows other numbers', { timeout: 240000 }, async () => {
  const whole = await seen(kPage);
  assert.equal(whole.state, 'ready', whole.text.slice(0, 300));
  const random = randomFrom(3);
  for (let round = 0; round < 16; ++round) {
    const at = kData + Math.floor(random() * (kPage.length - kData - 20));
    const broken = await seen(flipped(at));
    if (broken.says) assert.notEqual(broken.state, 'ready');
    else assert.equal(broken.text, whole.text, `a bit at ${at} of ${kPage.length} was not noticed`);
  }
});
