// What colours and shapes mean.
import type { Nearest } from '../data/nearest';
import { kPalettes } from '../scene/palette';
import type { Theme } from '../state/theme';
import type { Signal } from '../state/signal';
import { drawing, element } from '../text/element';
import { formatMetres } from '../text/numbers';

const kGlyphs = {
  risk: () => drawing('path', { d: 'M8 2 L14 8 L8 14 L2 8 Z', class: 'glyph-risk' }),
  pair: () => drawing('line', { x1: 2, y1: 11, x2: 14, y2: 5, class: 'glyph-pair' }),
  ghost: () => drawing('circle', { cx: 8, cy: 8, r: 4.5, class: 'glyph-ghost' }),
  out: () => drawing('circle', { cx: 8, cy: 8, r: 6.5, class: 'glyph-out' }),
};

function glyph(kind: keyof typeof kGlyphs): SVGElement {
  return drawing('svg', { viewBox: '0 0 16 16', class: 'glyph', 'aria-hidden': 'true' }, kGlyphs[kind]());
}

export function legend(
  nearest: Nearest | null,
  range: [number, number],
  words: { risk: string; line: string; colours: string; fleet: boolean },
  theme: Signal<Theme>,
): HTMLElement {
  const box = element(
    'div',
    { class: 'legend' },
    element('span', { class: 'legend-row' }, glyph('risk'), words.risk),
    element('span', { class: 'legend-row' }, glyph('pair'), words.line),
  );
  if (words.fleet) {
    box.append(
      element('span', { class: 'legend-row' }, glyph('ghost'), 'selected bee, as planned'),
      element('span', { class: 'legend-row' }, glyph('out'), 'out of its contract'),
    );
  }
  if (nearest) {
    const ramp = element('span', { class: 'ramp' });
    theme.watch((name) => {
      ramp.style.background = `linear-gradient(to right, ${kPalettes[name].ramp.join(', ')})`;
    });
    box.append(
      element(
        'span',
        { class: 'ramp-row' },
        element('span', { class: 'legend-label' }, words.colours),
        element('span', {}, `≤ ${formatMetres(nearest.ofCode(Math.round(range[0])), 2)}`),
        ramp,
        element('span', {}, `≥ ${formatMetres(nearest.ofCode(Math.round(range[1])), 2)}`),
      ),
    );
  }
  return box;
}
