// The selected bee: its numbers, and the bees that are too close to it.
import { geographicOf } from '../data/earth';
import type { Fleet } from '../data/fleet';
import { flownBy, stretchAt, type Flown } from '../data/flown';
import { positionOf } from '../data/positions';
import type { Recording } from '../data/recording';
import { apartOf, counterpart, pairsOf, type Swarm } from '../data/swarm';
import type { Choices, Selected } from '../state/choices';
import type { Signal } from '../state/signal';
import { formatApart } from '../text/apart';
import { formatMoment } from '../text/calendar';
import { button, element, panel } from '../text/element';
import { formatHeight } from '../text/heights';
import { isolate, nameElement, shorten } from '../text/names';
import {
  formatCoordinate,
  formatCount,
  formatDegrees,
  formatDuration,
  formatError,
  formatMetres,
} from '../text/numbers';
import { counted, nounOf, nounOfAll, oneOf } from '../text/noun';
import { formatClimb, formatSpeed } from '../text/speeds';
import { beeChart } from '../time/bee_chart';
import { seekable, type TimeChart } from '../time/time_chart';
import type { Actions, Shown } from './shown';

const kListed = 100;

/** Where bees of recordings are now; the clock knows. */
export interface Now {
  time_s: Signal<number>;
  /** The clock's time as seconds from the beginning of a swarm. */
  within: (shown: Shown) => number;
  seek: (shown: Shown, within_s: number) => void;
}

type Fact = [label: string, value: string, kind?: string];

function positionFacts(shown: Shown, place: [number, number, number] | null): Fact[] {
  const { head } = shown.swarm;
  if (!place) return [['Position', 'not there now']];
  const facts = head.axes.slice(0, head.flat ? 2 : 3).map((axis, i): Fact => [
    axis,
    i < 2 ? formatCoordinate(place[i], head.position_error_m) : formatHeight(place[i], head.position_error_m, head.heights),
  ]);
  const error: Fact = ['shown to within', formatError(head.position_error_m)];
  if (!head.origin) return [...facts, error];
  const { longitude_deg, latitude_deg } = geographicOf(head.origin, place);
  return [
    ...facts,
    ['latitude', formatDegrees(latitude_deg, head.position_error_m)],
    ['longitude', formatDegrees(longitude_deg, head.position_error_m)],
    error,
  ];
}

function placeNow(shown: Shown, bee: number, now: Now): [number, number, number] | null {
  const { swarm } = shown;
  if (swarm.kind === 'snapshot') return positionOf(swarm.positions, bee);
  const [x, y, z] = [new Float32Array(1), new Float32Array(1), new Float32Array(1)];
  if (!swarm.fixes.place(bee, now.within(shown), x, y, z, 0)) return null;
  return positionOf({ ...swarm.fixes.positions, x, y, z } as never, 0);
}

/** Of the bee that was asked for last, as it is asked for at each moment. */
let lastFlown: { swarm: Recording; bee: number; flown: Flown } | null = null;

/** How fast it flies along the ground and up; nothing where it stands between no two fixes. */
function speedFacts(swarm: Recording, bee: number, within_s: number): Fact[] {
  if (lastFlown?.swarm !== swarm || lastFlown.bee !== bee) lastFlown = { swarm, bee, flown: flownBy(swarm, bee) };
  const { flown } = lastFlown;
  const place = stretchAt(flown, within_s);
  if (place < 0) return [];
  const { head, fixes } = swarm;
  // What rounding of the shown positions leaves of nothing is nothing.
  const rounding = Math.hypot(...fixes.positions.step) / (flown.to_s[place] - flown.from_s[place]);
  const told = (speed: number): number => (Math.abs(speed) <= rounding ? 0 : speed);
  const speed: Fact = [head.flat ? 'Speed' : head.origin ? 'Ground speed' : 'Horizontal speed', formatSpeed(told(flown.horizontal_mps[place]), head.heights)];
  return head.flat ? [speed] : [speed, ['Climb', formatClimb(told(flown.climb_mps[place]), head.heights)]];
}

/** What the planner of the fleet says of a bee. */
function fleetFacts(fleet: Fleet, bee: number, within: number, place: [number, number, number] | null): Fact[] {
  const told = fleet.told(bee, within);
  if (!told) return [['Contract', 'nothing is said of it now']];
  const { contract, reason, certified, tube_m, branches } = told;
  const facts: Fact[] = [
    ['Contract', contract, contract === 'out' ? 'outcast' : ''],
    ...(contract === 'kept' ? [] : [['Why', reason] satisfies Fact]),
    ['Certified', certified ? 'yes' : 'no'],
  ];
  const deviation_m = place && fleet.deviation(bee, within, place);
  if (deviation_m !== null) facts.push(['Off its nominal place', formatMetres(deviation_m, 3)]);
  return [...facts, ['Tube', formatMetres(tube_m, 3)], ['Branches it may be on', formatCount(branches)]];
}

function factsOf(shown: Shown, bee: number, now: Now): Fact[] {
  const { swarm, company } = shown;
  const facts: Fact[] = [];
  if (swarm.kind === 'snapshot') {
    const risky = swarm.isAtRisk(bee);
    facts.push(['State', risky ? 'at risk' : 'not at risk', risky ? 'risky' : 'calm']);
    if (swarm.nearest) {
      const { nearest } = swarm;
      facts.push([`Nearest ${nounOf(swarm.head).one}`, `about ${formatMetres(nearest.distance(bee), Math.min(4, nearest.digits))}`]);
    }
  } else {
    const within = now.within(shown);
    const place = swarm.spans.bees.indexOf(bee);
    const risky = place >= 0 && swarm.spans.covers(place, within);
    facts.push(['Now', risky ? 'in conflict' : 'not in conflict', risky ? 'risky' : 'calm']);
    facts.push(['In conflict with any', formatDuration(swarm.spans.secondsOf(bee))]);
  }
  const group = company.groups.of[bee];
  if (group >= 0) {
    facts.push(['Conflict group', `${formatCount(company.groups.list[group].number)}, of ${counted(company.groups.list[group].bees.length, nounOf(swarm.head))}`]);
  }
  const place = placeNow(shown, bee, now);
  if (swarm.kind === 'recording' && swarm.fleet) facts.push(...fleetFacts(swarm.fleet, bee, now.within(shown), place));
  if (swarm.kind === 'recording') facts.push(...speedFacts(swarm, bee, now.within(shown)));
  facts.push(...positionFacts(shown, place));
  return facts;
}

/** How high and how fast the bee flies over time, and the other one of a pair beside it. */
function chartOf(swarm: Swarm, { bee, other }: Selected): TimeChart | null {
  if (swarm.kind !== 'recording') return null;
  const names = [bee, ...(other === null ? [] : [other])].map((one) => isolate(swarm.names.of(one)));
  return beeChart(swarm, bee, other, `How ${swarm.head.flat ? '' : 'high and how '}fast ${names.join(' and ')} ${names.length > 1 ? 'fly' : 'flies'} over time`);
}

function chartKey(swarm: Swarm, { bee, other }: Selected): HTMLElement | null {
  if (other === null) return null;
  const line = (kind: string, one: number): HTMLElement => element('span', { class: `key ${kind}` }, nameElement(swarm.names.of(one)));
  return element('p', { class: 'chart-key' }, line('key-solid', bee), line('key-dashed', other));
}

function factList(facts: Fact[]): HTMLElement {
  return element(
    'dl',
    { class: 'facts compact' },
    ...facts.map(([label, value, kind]) =>
      element('div', {}, element('dt', {}, label), element('dd', { class: kind ?? '' }, value)),
    ),
  );
}

/** Facts of the same bee in two swarms, beside each other. */
function factTable(sides: { label: string; facts: Fact[] | null }[]): HTMLElement {
  const labels = [...new Set(sides.flatMap(({ facts }) => (facts ?? []).map(([label]) => label)))];
  const head = sides.map(({ label }) => element('th', { scope: 'col' }, label));
  const rows = labels.map((label) => {
    const cells = sides.map(({ facts }) => {
      const fact = facts?.find(([name]) => name === label);
      return element('td', { class: fact?.[2] ?? '' }, fact ? fact[1] : '–');
    });
    return element('tr', {}, element('th', { scope: 'row' }, label), ...cells);
  });
  return element(
    'table',
    { class: 'beside facts-beside' },
    element('thead', {}, element('tr', {}, element('td'), ...head)),
    element('tbody', {}, ...rows),
  );
}

function neighbourList(shown: Shown, bee: number, chosen: number | null, actions: Actions): HTMLElement {
  const { swarm, company, index } = shown;
  const { first, second, distance_m } = pairsOf(swarm);
  const places = company.neighbours.placesOf(bee);
  const items = Array.from(places.subarray(0, kListed), (place) => {
    const neighbour = first[place] === bee ? second[place] : first[place];
    const made = button('', { class: 'link' }, () => {
      const time = swarm.kind === 'recording' ? { time_s: swarm.conflicts.closest_s[place] } : {};
      actions.select({ swarm: index, bee, other: neighbour, place }, { fly: true, ...time });
    });
    made.append(nameElement(swarm.names.of(neighbour)));
    if (place === chosen) made.setAttribute('aria-current', 'true');
    const distance = element('span', { class: 'figure' }, formatApart(distance_m[place], apartOf(swarm, place), swarm.head));
    const when =
      swarm.kind === 'recording'
        ? element('span', { class: 'when' }, ` at ${formatMoment(swarm.conflicts.closest_s[place], swarm.head.time)}`)
        : null;
    return element('li', {}, made, distance, when);
  });
  if (places.length > kListed) {
    items.push(element('li', { class: 'more' }, `and ${formatCount(places.length - kListed)} more`));
  }
  if (places.length === 0) {
    const text = neighbourlessText(shown, bee);
    return element('p', { class: 'quiet' }, shown.label ? `${shown.label}: ${text}` : text);
  }
  const what = swarm.kind === 'snapshot' ? 'Too close to it' : 'Conflicts';
  const heading = shown.label ? `${what}, ${shown.label.toLowerCase()}` : what;
  return element('div', {}, element('h3', {}, `${heading} (${formatCount(places.length)})`), element('ul', { class: 'neighbours' }, ...items));
}

function neighbourlessText(shown: Shown, bee: number): string {
  const { swarm } = shown;
  if (swarm.kind === 'snapshot' && swarm.isAtRisk(bee)) return 'Its pairs are among those left out of this page.';
  if (swarm.kind === 'snapshot') {
    const whole = swarm.head.risk.unknown === undefined;
    return whole ? `No ${nounOf(swarm.head).one} is too close to it.` : 'None of those that are known is too close to it.';
  }
  const { head } = swarm;
  const unknown = head.kind === 'recording' && head.risk.unknown !== undefined;
  return unknown ? 'It was in no conflict in the known time.' : 'It was in no conflict.';
}

function announce(shown: Shown, { bee, other, place }: Selected): string {
  const { swarm, company } = shown;
  const name = isolate(swarm.names.of(bee));
  if (other !== null) {
    const apart = place === null ? '' : `, ${formatApart(pairsOf(swarm).distance_m[place], apartOf(swarm, place), swarm.head)} apart`;
    return `Selected ${name} and ${isolate(swarm.names.of(other))}${apart}.`;
  }
  const count = company.neighbours.placesOf(bee).length;
  const pairs = swarm.kind === 'snapshot' ? 'too close' : 'conflicts';
  return `Selected ${name}, ${formatCount(count)} ${pairs}.`;
}

export function selectionPanel(all: Shown[], choices: Choices, now: Now, actions: Actions): HTMLElement {
  const body = element('div', { class: 'selection-body' });
  const live = element('p', { class: 'hidden-text', role: 'status', 'aria-live': 'polite' });
  const box = panel('selection', `Selected ${nounOfAll(all).one}`, body, live);

  const facts = element('div');
  let chart: TimeChart | null = null;
  const tellFacts = (): void => {
    const selected = choices.selected.value;
    if (!selected) return;
    chart?.follow(now.within(all[selected.swarm]));
    const sides = all.map((shown) => {
      const bee = counterpart(all[selected.swarm].swarm, selected.bee, shown.swarm);
      return { label: shown.label, facts: bee === null ? null : factsOf(shown, bee, now) };
    });
    facts.replaceChildren(sides.length === 1 ? factList(sides[0].facts ?? []) : factTable(sides));
  };

  choices.selected.watch((selected) => {
    chart = null;
    if (!selected) {
      box.removeAttribute('data-selected-bee');
      box.removeAttribute('data-selected-name');
      body.replaceChildren(element('p', { class: 'quiet' }, `None yet. Click ${oneOf(nounOfAll(all))}, search for one, or choose a row of the table.`));
      live.textContent = '';
      return;
    }
    const home = all[selected.swarm];
    box.dataset.selectedBee = String(selected.bee);
    box.dataset.selectedName = shorten(home.swarm.names.of(selected.bee));
    const tools = element(
      'p',
      { class: 'tools' },
      button('Fly there', {}, () => actions.select(selected, { fly: true })),
      button('Clear', {}, () => actions.select(null)),
    );
    const group = home.company.groups.of[selected.bee];
    if (group >= 0) {
      tools.prepend(
        button('Only its group', {}, () =>
          choices.filter.set({ ...choices.filter.value, group: { swarm: home.index, place: group } }),
        ),
      );
    }
    const { names } = home.swarm;
    const name = names.of(selected.bee);
    const number =
      name === String(selected.bee)
        ? null
        : element('span', { class: 'quiet', title: 'Its place in the input, counted from 0' }, ` #${formatCount(selected.bee)}`);
    const lists = all.map((shown) => {
      const bee = counterpart(home.swarm, selected.bee, shown.swarm);
      const list = bee === null ? null : neighbourList(shown, bee, shown === home ? selected.place : null, actions);
      return element('div', {}, list);
    });
    chart = chartOf(home.swarm, selected);
    const curves = chart ? [chartKey(home.swarm, selected), seekable(chart, (within_s) => now.seek(home, within_s))] : [];
    body.replaceChildren(
      element('p', { class: 'who-it-is' }, nameElement(name), number),
      tools,
      facts,
      ...curves.filter((part) => part !== null),
      ...lists,
    );
    tellFacts();
    live.textContent = announce(home, selected);
  });

  // As time goes on only the numbers change, not what one may be about to click.
  if (all.some(({ swarm }) => swarm.kind === 'recording')) now.time_s.listen(tellFacts);
  return box;
}
