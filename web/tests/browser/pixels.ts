// Counts coloured pixels of a part of the page.
import type { Page } from 'playwright-core';

export interface Clip {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Pixels of the red that stands for risk in the dark theme. */
export function redPixels(page: Page, clip: Clip): Promise<number> {
  return pixels(page, clip, 'red');
}

/** Pixels of the violet of what a planner says of the selected bee, in the dark theme. */
export function violetPixels(page: Page, clip: Clip): Promise<number> {
  return pixels(page, clip, 'violet');
}

/** Pixels of the grey of coasts, in the dark theme. */
export function coastPixels(page: Page, clip: Clip): Promise<number> {
  return pixels(page, clip, 'coast');
}

async function pixels(page: Page, clip: Clip, colour: 'red' | 'violet' | 'coast'): Promise<number> {
  const png = (await page.screenshot({ clip })).toString('base64');
  const blank = await page.context().newPage();
  try {
    return await blank.evaluate(async ([text, wanted]) => {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d');
      if (!context) return -1;
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let found = 0;
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
        const red = r > 130 && r > 2.2 * g && r > 2.2 * b;
        const violet = b > 50 && r > 1.15 * g && b > r;
        const coast = Math.abs(r - 86) < 8 && Math.abs(g - 112) < 8 && Math.abs(b - 127) < 8;
        if ({ red, violet, coast }[wanted]) ++found;
      }
      return found;
    }, [png, colour] as const);
  } finally {
    await blank.close();
  }
}

export async function canvasClip(page: Page, swarm = 0): Promise<Clip> {
  const box = await page.locator('.stage canvas').nth(swarm).boundingBox();
  if (!box) throw new Error('no canvas');
  return box;
}
