// How long a metre is on the screen, where the camera looks at.
import type { LengthUnits } from '../text/apart';
import { element } from '../text/element';
import { niceBelow } from '../text/nice_steps';

const kLongest_px = 130;

export class ScaleBar {
  readonly #bar = element('span', { class: 'bar' });
  readonly #text = element('span', { class: 'length' });
  readonly box = element(
    'div',
    { class: 'scale-bar', title: 'Length at the middle of the view' },
    this.#bar,
    this.#text,
  );

  show(metresPerPixel: number, viewWidth: number, lift: number, units: LengthUnits): void {
    const longest_m = kLongest_px * metresPerPixel;
    const unit = units.ground(longest_m);
    const value = niceBelow(longest_m / unit.metres);
    const metres = value * unit.metres;
    // As a share of the view, it stays right on paper too.
    this.#bar.style.width = `${((100 * metres) / metresPerPixel / viewWidth).toFixed(3)}cqw`;
    const length = unit.text(Number(value.toPrecision(6)));
    this.#text.textContent = lift === 1 ? length : `${length}, heights ×${lift}`;
  }
}
