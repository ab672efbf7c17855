// On paper: in the light theme, with a picture of each view as it stands.
import type { View } from './scene/view';
import type { Signal } from './state/signal';
import type { Theme } from './state/theme';
import { element } from './text/element';

/** Across a page of A4 between its margins, in CSS pixels. */
const kPaper_px = 688;

/** Keeps the size that a view has on the screen and scales all of it, labels too; says how to undo that. */
function fitOnPaper(scene: HTMLElement, views: number): () => void {
  const { clientWidth, clientHeight, style } = scene;
  const scale = Math.min(1, kPaper_px / views / Math.max(1, clientWidth));
  Object.assign(style, { width: `${clientWidth}px`, height: `${clientHeight}px`, flex: 'none', zoom: String(scale) });
  return () => Object.assign(style, { width: '', height: '', flex: '', zoom: '' });
}

export function preparePrinting(views: View[], theme: Signal<Theme>): void {
  let before: Theme | null = null;
  const undo: (() => void)[] = [];
  addEventListener('beforeprint', () => {
    before = theme.value;
    theme.set('light');
    for (const view of views) {
      // The picture is only there until the browser shows the next frame.
      view.draw();
      const picture = element('img', { class: 'printed', alt: 'The swarm', src: view.canvas.toDataURL() });
      view.canvas.after(picture);
      undo.push(() => picture.remove(), fitOnPaper(view.holder, views.length));
    }
  });
  addEventListener('afterprint', () => {
    for (const step of undo.splice(0)) step();
    if (before) theme.set(before);
  });
}
