// Rings and names over the selected bees.
import type { Camera, Vector3 } from 'three';
import { element } from '../text/element';
import { nameElement } from '../text/names';

const kTagWidth = 150;
/** How wide a name may be, and how much stands between its bee and the edge of the view beside it. */
const kWidest = 240;
const kNarrowest = 70;
const kBeside = 22;

export class Markers {
  readonly layer = element('div', { class: 'markers', 'aria-hidden': 'true' });
  #marks: HTMLElement[] = [];

  name(names: string[]): void {
    this.#marks = names.map((name, place) =>
      element(
        'div',
        { class: place === 0 ? 'marker' : 'marker other' },
        element('span', { class: 'ring' }),
        element('span', { class: 'tag' }, nameElement(name)),
      ),
    );
    this.layer.replaceChildren(...this.#marks);
  }

  /** Of each bee named, where it is; null where it is nowhere now. Names stand away from one another. */
  move(places: (Vector3 | null)[], camera: Camera, width: number, height: number): void {
    const across = this.#marks.map((mark, i) => {
      const at = places[i]?.clone().project(camera);
      mark.hidden = !at || Math.abs(at.z) > 1 || Math.abs(at.x) > 1 || Math.abs(at.y) > 1;
      if (!at || mark.hidden) return null;
      const x = ((at.x + 1) * width) / 2;
      const y = ((1 - at.y) * height) / 2;
      mark.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      return x;
    });
    const rightmost = Math.max(...across.map((x) => x ?? 0));
    across.forEach((x, i) => {
      if (x === null) return;
      const room = x > kTagWidth;
      const leftwards = x > width - kTagWidth || (room && x < rightmost);
      const mark = this.#marks[i];
      mark.classList.toggle('leftwards', leftwards);
      // On a phone a long name has more lines.
      const tag = mark.lastElementChild as HTMLElement;
      tag.style.maxWidth = `${Math.max(kNarrowest, Math.min(kWidest, (leftwards ? x : width - x) - kBeside)).toFixed(0)}px`;
    });
  }
}
