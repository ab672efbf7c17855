// Where the data came from, how exact the picture is, and what was left out.
import { formatTime } from '../text/calendar';
import { element, panel } from '../text/element';
import { nameElement } from '../text/names';
import { formatDigits, formatError } from '../text/numbers';
import { nounOf } from '../text/noun';
import { tooClose } from '../text/threshold';
import type { Shown } from './shown';

function originText(origin: { longitude_deg: number; latitude_deg: number }): string {
  const degrees = (value: number, positive: string, negative: string): string =>
    `${formatDigits(Math.abs(value), 8)}° ${value < 0 ? negative : positive}`;
  return `${degrees(origin.latitude_deg, 'N', 'S')}, ${degrees(origin.longitude_deg, 'E', 'W')}`;
}

function factsOf({ swarm }: Shown): [string, Node | string][] {
  const { head } = swarm;
  const facts: [string, Node | string][] = [
    ['File', nameElement(head.title)],
    ['Read from', nameElement(head.source)],
    ['Too close', tooClose(head)],
    ['Positions', `shown to within ${formatError(head.position_error_m)}; who is at risk was decided on the exact ones`],
  ];
  if (head.flat) facts.push(['Heights', 'the input has none: distances are those in the plane']);
  if (head.origin) {
    facts.push(['Zero of east and north', originText(head.origin)]);
    const counted = head.heights?.by_pressure ? 'by pressure of the standard atmosphere' : 'those of the input, taken as above the WGS84 ellipsoid if the notes say nothing else';
    if (!head.flat) facts.push(['Heights', `${counted}; east and north are along the ground`]);
  }
  if (head.kind === 'recording') {
    const { begins_s, ends_s, clock } = head.time;
    const where = clock?.zone ? ` (${clock.zone})` : '';
    facts.push(['Time', `${formatTime(begins_s, head.time)} to ${formatTime(ends_s, head.time)}${where}`]);
    facts.push(['Between fixes', `${nounOf(head).several} move in straight lines`]);
    if (head.fleet) facts.push(["Planner's log", nameElement(head.fleet.title)]);
  }
  return facts;
}

function noteList(shown: Shown): HTMLElement | null {
  const { notes } = shown.swarm.head;
  if (notes.length === 0) return null;
  return element('ul', { class: 'notes' }, ...notes.map((note) => element('li', { dir: 'auto' }, ...withWholeOptions(note))));
}

/** Options of the command are not broken at their hyphens. */
function withWholeOptions(note: string): (Node | string)[] {
  return note.split(/(--[a-z-]+)/).map((part) => (part.startsWith('--') ? element('span', { class: 'whole' }, part) : part));
}

export function notesPanel(all: Shown[], version: string, ownNotes: string[]): HTMLElement {
  const parts = all.flatMap((shown) => [
    shown.label ? element('h3', {}, shown.label) : null,
    noteList(shown),
    element(
      'dl',
      { class: 'facts wide' },
      ...factsOf(shown).map(([label, value]) => element('div', {}, element('dt', {}, label), element('dd', {}, value))),
    ),
  ]);
  if (ownNotes.length > 0) {
    parts.unshift(element('ul', { class: 'notes' }, ...ownNotes.map((note) => element('li', {}, note))));
  }
  parts.push(element('p', { class: 'made-by' }, `Made by beespace ${version}. This page needs no network.`));
  return panel('about', 'About these data', ...parts);
}
