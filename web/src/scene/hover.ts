// The name of the bee under the cursor, or else of what stands in the way there.
import { element } from '../text/element';
import { nameElement } from '../text/names';
import type { View } from './view';

/** Of more, finding the one under the cursor takes too long for every move of a hand. */
const kMostBees = 200000;

export function nameUnderCursor(view: View, tell: (bee: number) => { name: string; more: string }): void {
  if (view.subject.count > kMostBees) return;
  const tag = element('div', { class: 'hover-tag', 'aria-hidden': 'true', hidden: '' });
  view.holder.append(tag);
  let due = 0;
  const hide = (): void => {
    cancelAnimationFrame(due);
    due = 0;
    tag.hidden = true;
  };
  view.canvas.addEventListener('pointermove', (event) => {
    if (event.pointerType !== 'mouse' || event.buttons !== 0) return hide();
    if (due !== 0) return;
    due = requestAnimationFrame(() => {
      due = 0;
      const { left, top, width } = view.canvas.getBoundingClientRect();
      const [x, y] = [event.clientX - left, event.clientY - top];
      const bee = view.pick(x, y);
      const obstacle = bee === null ? view.obstacleAt(x, y) : null;
      tag.hidden = bee === null && obstacle === null;
      if (tag.hidden) return;
      const { name, more } = bee === null ? { name: obstacle ?? '', more: '' } : tell(bee);
      tag.replaceChildren(nameElement(name), ...(more ? [element('div', { class: 'hover-more' }, more)] : []));
      tag.style.transform = `translate(${(x > width - 220 ? x - 12 : x + 12).toFixed(0)}px, ${(y + 14).toFixed(0)}px)${x > width - 220 ? ' translateX(-100%)' : ''}`;
    });
  });
  view.canvas.addEventListener('pointerleave', hide);
}
