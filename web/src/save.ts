// Files that the page makes: they go where the reader's browser saves.
import type { View } from './scene/view';

export function saveFile(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/** A name for a file that is made of a swarm of this title. */
export function fileName(title: string, ending: string): string {
  const stem = title.replace(/\.[a-z0-9]{1,8}$/i, '').replace(/[^\p{L}\p{N}._-]+/gu, '_').slice(0, 80);
  return `${stem || 'swarm'}.${ending}`;
}

/** Draws a text of the page where it stands over the view. */
function letter(context: CanvasRenderingContext2D, one: HTMLElement, left: number, top: number): void {
  const box = one.getBoundingClientRect();
  if (box.width === 0 || !one.textContent) return;
  const style = getComputedStyle(one);
  const ground = style.backgroundColor;
  if (ground !== 'rgba(0, 0, 0, 0)') {
    context.fillStyle = ground;
    context.fillRect(box.left - left, box.top - top, box.width, box.height);
  }
  context.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  context.fillStyle = style.color;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(one.innerText, box.left - left + box.width / 2, box.top - top + box.height / 2);
}

/** The view as it stands, with what is written around it. */
export async function pictureOf(view: View): Promise<Blob> {
  const { canvas, holder } = view;
  const picture = document.createElement('canvas');
  [picture.width, picture.height] = [canvas.width, canvas.height];
  const context = picture.getContext('2d');
  if (!context) throw new Error('this browser makes no pictures');
  // What was drawn is only there until the browser shows the next frame.
  view.draw();
  context.drawImage(canvas, 0, 0);
  const { left, top, width } = holder.getBoundingClientRect();
  context.scale(canvas.width / width, canvas.width / width);
  for (const one of holder.querySelectorAll<HTMLElement>('.axis-labels span, .marker .tag, .scale-bar .length')) {
    if (!one.closest('[hidden]')) letter(context, one, left, top);
  }
  const bar = holder.querySelector('.scale-bar .bar')?.getBoundingClientRect();
  if (bar) context.fillRect(bar.left - left, bar.bottom - top - 2, bar.width, 2);
  return new Promise((resolve, reject) => {
    picture.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('there is no room for a picture'))), 'image/png');
  });
}

/** Cells of a table in lines; what a spreadsheet would take for a formula gets an apostrophe before it. */
export function csvOf(rows: (string | number)[][]): string {
  const cell = (value: string | number): string => {
    if (typeof value === 'number') return Number.isFinite(value) ? String(value) : '';
    const formula = /^[=+\-@\t\r\uff1d\uff0b\uff0d\uff20]/.test(value) && !/^[+-]?\d+(\.\d+)?(e[+-]?\d+)?$/i.test(value);
    const text = formula ? `'${value}` : value;
    return /[",;\t\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return rows.map((row) => `${row.map(cell).join(',')}\r\n`).join('');
}
