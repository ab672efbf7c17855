// Who was out of its contract, since when and why; of flights of which the log of the planner is known.
import type { Fleet } from '../data/fleet';
import type { RecordingHead } from '../data/page';
import { formatMoment } from '../text/calendar';
import { button, element, panel } from '../text/element';
import { isolate, nameElement } from '../text/names';
import type { Noun } from '../data/page';
import { counted, nounOf } from '../text/noun';
import { formatCount } from '../text/numbers';
import type { Actions, Shown } from './shown';

const kListed = 100;

function headline(fleet: Fleet, noun: Noun): string {
  const { outcasts, doubted, known } = fleet;
  const of = `of ${counted(known, noun)}`;
  const out = outcasts.length === 0 ? `None ${of} was out of its contract` : `${formatCount(outcasts.length)} ${of} out of contract at some time`;
  return `${out}; doubted at some time ${formatCount(doubted)}.`;
}

function listOf(shown: Shown, fleet: Fleet, { time }: RecordingHead, actions: Actions): HTMLElement {
  const { swarm, index } = shown;
  const items = fleet.outcasts.slice(0, kListed).map(({ bee, time_s, reason }) => {
    const name = swarm.names.of(bee);
    const made = button('', { class: 'link', 'aria-label': `Show ${isolate(name)} where it was first out of its contract` }, () =>
      actions.select({ swarm: index, bee, other: null, place: null }, { fly: true, time_s }),
    );
    made.append(nameElement(name));
    const when = element('span', { class: 'figure' }, formatMoment(time_s, time));
    return element('li', {}, made, when, element('span', { class: 'when' }, reason));
  });
  if (fleet.outcasts.length > kListed) {
    items.push(element('li', { class: 'more' }, `and ${formatCount(fleet.outcasts.length - kListed)} more`));
  }
  return element('ul', { class: 'neighbours' }, ...items);
}

/** Nothing where nothing is known of contracts. */
export function contractPanel(all: Shown[], actions: Actions): HTMLElement | null {
  const parts = all.flatMap((shown) => {
    const { swarm } = shown;
    if (swarm.kind !== 'recording' || !swarm.fleet) return [];
    const list = swarm.fleet.outcasts.length > 0 ? listOf(shown, swarm.fleet, swarm.head, actions) : null;
    const label = shown.label ? element('h3', {}, shown.label) : null;
    return [element('div', {}, label, element('p', { class: 'rule' }, headline(swarm.fleet, nounOf(swarm.head))), list)];
  });
  return parts.length === 0 ? null : panel('contracts', 'Contracts', ...parts);
}
