// A page in Chromium, watched: it may ask the network for nothing and complain about nothing.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chromium, type Browser, type Page } from 'playwright-core';

export const kArtefacts = resolve('tests/artefacts');
mkdirSync(kArtefacts, { recursive: true });

if (!process.env.BEESPACE_PAGES) {
  throw new Error('BEESPACE_PAGES must name a folder with the pages of tests/web/make_pages.sh');
}
export const kPages = resolve(process.env.BEESPACE_PAGES);

let browser: Browser | null = null;

after(async () => {
  await browser?.close();
});

export async function launched(): Promise<Browser> {
  browser ??= await chromium.launch({
    executablePath: process.env.BEESPACE_CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--use-gl=angle',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
    ],
  });
  return browser;
}

export interface Opening {
  width?: number;
  height?: number;
  theme?: 'dark' | 'light';
  before?: string;
  reducedMotion?: boolean;
}

export interface OpenedPage {
  page: Page;
  /** What went wrong so far: errors, and requests for anything but the page itself. */
  complaints: string[];
}

async function open(file: string, opening: Opening): Promise<OpenedPage> {
  const context = await (await launched()).newContext({
    viewport: { width: opening.width ?? 1440, height: opening.height ?? 900 },
    colorScheme: opening.theme ?? 'dark',
    reducedMotion: opening.reducedMotion === false ? 'no-preference' : 'reduce',
  });
  const page = await context.newPage();
  const own = pathToFileURL(file).href;
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
  page.on('console', (message) => message.type() === 'error' && complaints.push(`console: ${message.text()}`));
  page.on('request', (request) => {
    const url = request.url();
    if (url !== own && !url.startsWith('data:') && !url.startsWith('blob:')) complaints.push(`request: ${url.slice(0, 200)}`);
  });
  page.on('dialog', (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  if (opening.before) await page.addInitScript(opening.before);
  await page.goto(own, { waitUntil: 'commit' });
  await page.waitForFunction(() => ['ready', 'failed'].includes(document.documentElement.dataset.beespace ?? ''), null, {
    timeout: 60000,
  });
  return { page, complaints };
}

/** A test of one page. */
export function pageTest(
  what: string,
  name: string,
  opening: Opening,
  check: (opened: OpenedPage, tell: (text: string) => void) => Promise<void>,
): void {
  test(`${name}: ${what}`, async () => {
    const opened = await open(resolve(kPages, `${name}.html`), opening);
    try {
      assert.equal(await opened.page.evaluate(() => document.documentElement.dataset.beespace), 'ready');
      await check(opened, (text) => console.log(`    ${name}: ${text}`));
      assert.deepEqual(opened.complaints, []);
    } finally {
      await opened.page.context().close();
    }
  });
}

/** What the page's own JSON says. */
export function headOf(page: Page, swarm = 0): Promise<Record<string, never> & { count: number; kind: string; risk: { closest?: { first: number; second: number } } }> {
  return page.evaluate((place) => {
    return JSON.parse(document.getElementById('beespace-page')?.textContent ?? '').swarms[place];
  }, swarm);
}

export function selectedBee(page: Page): Promise<string | null> {
  return page.evaluate(() => document.querySelector<HTMLElement>('[data-selected-bee]')?.dataset.selectedBee ?? null);
}

export interface Hook {
  project: (swarm: number, bee: number) => { x: number; y: number } | null;
  framesPerSecond: (frames: number) => number;
  settle: () => void;
}

export function projected(page: Page, bee: number, swarm = 0): Promise<{ x: number; y: number } | null> {
  return page.evaluate(
    ([which, who]) => (window as unknown as { beespace: Hook }).beespace.project(which, who),
    [swarm, bee] as const,
  );
}

export async function settled(page: Page): Promise<void> {
  await page.evaluate(() => (window as unknown as { beespace: Hook }).beespace.settle());
}
