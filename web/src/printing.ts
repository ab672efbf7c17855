// On paper: in the light theme, with a picture of each view as it stands.
import type { View } from './scene/view';
import type { Signal } from './state/signal';
import type { Theme } from './state/theme';
import { element } from './text/element';

export function preparePrinting(views: View[], theme: Signal<Theme>): void {
  let before: Theme | null = null;
  const pictures: HTMLImageElement[] = [];
  addEventListener('beforeprint', () => {
    before = theme.value;
    theme.set('light');
    for (const view of views) {
      // The picture is only there until the browser shows the next frame.
      view.draw();
      const picture = element('img', { class: 'printed', alt: 'The swarm', src: view.canvas.toDataURL() });
      view.canvas.after(picture);
      pictures.push(picture);
    }
  });
  addEventListener('afterprint', () => {
    for (const picture of pictures.splice(0)) picture.remove();
    if (before) theme.set(before);
  });
}
