// The measure tool on a view: two clicks, on bees or on the floor, and how far apart these are.
import { measured } from '../data/measure';
import type { Triple } from '../data/positions';
import type { Choices } from '../state/choices';
import { formatHorizontal, formatVertical } from '../text/apart';
import { element } from '../text/element';
import { nameElement } from '../text/names';
import { nounOf } from '../text/noun';
import { formatError, formatMetres } from '../text/numbers';
import type { View } from '../scene/view';
import type { Shown } from './shown';

type End = { bee: number } | { place: Triple };

export interface Measuring {
  /** Takes a click on the view. */
  take: (bee: number | null, x: number, y: number) => void;
}

export function measuringOn(shown: Shown & { view: View }, choices: Choices): Measuring {
  const { view, swarm } = shown;
  const text = element('div', { class: 'measure', role: 'status', hidden: '' });
  view.holder.append(text);
  const ask = `Measure: click two ${nounOf(swarm.head).several}, or places on the floor.`;
  let ends: End[] = [];
  let told = '';

  const placeOf = (end: End): Triple | null => ('bee' in end ? (view.sceneOf(end.bee) && view.placeOf(end.bee)) : end.place);
  const nameOf = (end: End): Node => ('bee' in end ? nameElement(swarm.names.of(end.bee)) : element('span', {}, 'a place on the floor'));

  const tell = (): void => {
    const places = ends.map(placeOf).filter((place) => place !== null);
    const key = JSON.stringify([ends, places]);
    if (key === told) return;
    told = key;
    view.measureLine(places);
    if (ends.length < 2) {
      text.replaceChildren(ask, ...(ends.length === 1 ? [' From ', nameOf(ends[0]), ' to …'] : []));
      return;
    }
    const names = [element('span', {}, nameOf(ends[0]), ' to ', nameOf(ends[1]))];
    if (places.length < 2) {
      text.replaceChildren(...names, element('div', {}, 'One of them is not there now.'));
      return;
    }
    const { head } = swarm;
    const { straight_m, horizontal_m, height_m } = measured(places[0], places[1], head.origin);
    const row = (label: string, value: string): HTMLElement => element('div', { class: 'measure-row' }, element('span', {}, label), element('strong', {}, value));
    text.replaceChildren(
      ...names,
      ...(head.flat
        ? [row('apart', formatHorizontal(horizontal_m, head))]
        : [
            row('straight', formatMetres(straight_m, 4)),
            row('horizontally', formatHorizontal(horizontal_m, head)),
            row('in height', formatVertical(height_m, head)),
          ]),
      element('div', { class: 'quiet' }, `of shown positions: each to within ${formatError(2 * head.position_error_m)}`),
    );
  };

  choices.measuring.watch((on) => {
    ends = [];
    told = '';
    text.hidden = !on;
    view.holder.classList.toggle('measuring', on);
    if (on) tell();
    else view.measureLine([]);
  });
  view.onPlaced(() => {
    if (choices.measuring.value && ends.length > 0) tell();
  });
  return {
    take: (bee, x, y) => {
      const place = bee === null ? view.sight.floorUnder(x, y) : null;
      if (bee === null && place === null) return;
      if (ends.length === 2) ends = [];
      ends.push(bee === null ? { place: place as Triple } : { bee });
      tell();
    },
  };
}
