// What colours and shapes mean.
import { rampOf } from '../scene/cloud';
import type { Colours } from '../scene/colouring';
import { kPalettes } from '../scene/palette';
import type { Choices, ColourBy } from '../state/choices';
import type { Noun } from '../data/page';
import { drawing, element } from '../text/element';

const kGlyphs = {
  risk: () => drawing('path', { d: 'M8 2 L14 8 L8 14 L2 8 Z', class: 'glyph-risk' }),
  pair: () => drawing('line', { x1: 2, y1: 11, x2: 14, y2: 5, class: 'glyph-pair' }),
  ghost: () => drawing('circle', { cx: 8, cy: 8, r: 4.5, class: 'glyph-ghost' }),
  out: () => drawing('circle', { cx: 8, cy: 8, r: 6.5, class: 'glyph-out' }),
};

function glyph(kind: keyof typeof kGlyphs): SVGElement {
  return drawing('svg', { viewBox: '0 0 16 16', class: 'glyph', 'aria-hidden': 'true' }, kGlyphs[kind]());
}

function namesOf({ one }: Noun): Record<ColourBy, string> {
  return { nearest: `Nearest ${one}`, height: 'Height', speed: 'Speed', group: 'Conflict group', none: 'One colour' };
}

/** What bees are coloured by: chosen here, and told with the ends of its scale. */
function colourRow(colours: Colours, noun: Noun, choices: Choices): HTMLElement {
  const what = `What the colours of ${noun.several} tell`;
  const names = namesOf(noun);
  const select = element('select', { 'aria-label': what, title: `${what} (c)` });
  select.append(...colours.offered.map((by) => element('option', { value: by }, names[by])));
  select.addEventListener('change', () => choices.colourBy.set(select.value as ColourBy));
  const ramp = element('span', { class: 'ramp' });
  const [from, to] = [element('span'), element('span')];
  const tell = (): void => {
    const colouring = colours.of(choices.colourBy.value);
    select.value = colouring.by;
    select.title = colouring.title ? `${colouring.title}: ${what.charAt(0).toLowerCase()}${what.slice(1)} (c)` : `${what} (c)`;
    const plain = colouring.codes === null;
    for (const part of [from, ramp, to]) part.hidden = plain;
    // Small numbers stand on the left, whichever colour they have.
    const turned = colouring.range[0] > colouring.range[1];
    const ramped = rampOf(colouring, kPalettes[choices.theme.value]);
    const shades = turned ? ramped.slice().reverse() : ramped;
    const steps = shades.map((shade, i) => `${shade} ${(100 * i) / shades.length}% ${(100 * (i + 1)) / shades.length}%`);
    ramp.style.background = `linear-gradient(to right, ${(colouring.by === 'group' ? steps : shades).join(', ')})`;
    [from.textContent, to.textContent] = turned ? colouring.ends.slice().reverse() : colouring.ends;
  };
  choices.theme.watch(tell);
  choices.colourBy.listen(tell);
  return element('span', { class: 'ramp-row' }, element('label', { class: 'legend-label' }, 'Colour ', select), from, ramp, to);
}

export function legend(
  colours: Colours,
  words: { risk: string; line: string; fleet: boolean; noun: Noun },
  choices: Choices,
): HTMLElement {
  const box = element(
    'div',
    { class: 'legend' },
    element('span', { class: 'legend-row' }, glyph('risk'), words.risk),
    element('span', { class: 'legend-row' }, glyph('pair'), words.line),
  );
  if (words.fleet) {
    box.append(
      element('span', { class: 'legend-row' }, glyph('ghost'), `selected ${words.noun.one}, as planned`),
      element('span', { class: 'legend-row' }, glyph('out'), 'out of its contract'),
    );
  }
  if (colours.offered.length > 1) box.append(colourRow(colours, words.noun, choices));
  return box;
}
