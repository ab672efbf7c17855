// Counts coloured pixels of a part of the page.
import type { Page } from 'playwright-core';

export interface Clip {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Pixels of the red that stands for risk in the dark theme. */
export async function redPixels(page: Page, clip: Clip): Promise<number> {
  const png = (await page.screenshot({ clip })).toString('base64');
  const blank = await page.context().newPage();
  try {
    return await blank.evaluate(async (text) => {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d');
      if (!context) return -1;
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let red = 0;
      for (let i = 0; i < data.length; i += 4) {
        if (data[i] > 130 && data[i] > 2.2 * data[i + 1] && data[i] > 2.2 * data[i + 2]) ++red;
      }
      return red;
    }, png);
  } finally {
    await blank.close();
  }
}

export async function canvasClip(page: Page, swarm = 0): Promise<Clip> {
  const box = await page.locator('.stage canvas').nth(swarm).boundingBox();
  if (!box) throw new Error('no canvas');
  return box;
}
