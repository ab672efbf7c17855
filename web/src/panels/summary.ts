// The summary: which bees are at risk, how many, how close. Two swarms stand beside each other.
import type { ClosestEncounter, ClosestPair, Head, RecordingRisk, SnapshotRisk } from '../data/page';
import { pairsOf } from '../data/swarm';
import { formatHorizontal, formatVertical, limitsOf } from '../text/apart';
import { element, button, panel } from '../text/element';
import { isolate, nameElement } from '../text/names';
import { formatBelow, formatCount, formatDuration, formatMetres, formatShare } from '../text/numbers';
import type { Noun } from '../data/page';
import { capitalised, counted, nounOf, nounOfAll } from '../text/noun';
import { tooClose } from '../text/threshold';
import type { Actions, Shown } from './shown';

interface Row {
  label: string;
  /** Below the names of the closest pair. */
  ofClosest?: string;
  value: string;
  limit?: string;
  risky?: boolean;
  /** For the difference between before and after. */
  number?: number;
  unit?: 'count' | 'metres' | 'seconds';
}

/** Rows that the headline of a swarm alone tells already. */
const kInHeadline = ['At risk', 'Share at risk', 'In conflict at some time', 'Ahead'];

/** The times of conflicts are rounded to less than this share of all of the time. */
const kTimeRounding = 1e-4;

const kWithGround = 'Closest, one on the ground';
const kWithStill = 'Closest, one stands still'; // of aircraft, that do not say where they stand

/** What is longer reads from the left, below its name. */
const kLong = 40;

function countRow(label: string, count: number): Row {
  return { label, value: formatCount(count), number: count, unit: 'count' };
}

function snapshotRows(risk: SnapshotRisk, count: number, { several }: Noun): Row[] {
  return [
    countRow(capitalised(several), count),
    countRow('At risk', risk.at_risk),
    { label: 'Share at risk', value: formatShare(risk.at_risk, count) },
    countRow('Pairs too close', risk.pairs),
    countRow('Conflict groups', risk.groups),
    countRow('Largest group', risk.largest_group),
    ...(risk.ahead === undefined ? [] : [{ label: 'Ahead', value: risk.ahead }]),
    ...(risk.unknown === undefined ? [] : [{ label: 'Unknown', value: risk.unknown }]),
  ];
}

function recordingRows(risk: RecordingRisk, count: number, duration_s: number, { several }: Noun): Row[] {
  return [
    countRow(capitalised(several), count),
    countRow('In conflict at some time', risk.bees),
    countRow('Conflicts', risk.conflicts),
    ...(risk.possible > 0 ? [countRow('Of these only possible', risk.possible)] : []),
    countRow('Pairs in conflict', risk.pairs),
    {
      label: `Time in conflict, summed over ${several}`,
      value: formatDuration(risk.bee_seconds),
      number: risk.bee_seconds,
      unit: 'seconds',
    },
    { label: 'Length', value: formatDuration(duration_s) },
    ...(risk.left_out === undefined ? [] : [{ label: 'Left out', value: risk.left_out }]),
    ...(risk.unknown === undefined ? [] : [{ label: 'Unknown', value: risk.unknown }]),
  ];
}

function rowsOf(shown: Shown, noun: Noun): Row[] {
  const { head } = shown.swarm;
  const rows =
    head.kind === 'snapshot'
      ? snapshotRows(head.risk, head.count, noun)
      : recordingRows(head.risk, countOf(head), head.time.ends_s - head.time.begins_s, noun);
  return [...rows, ...closestRows(head, shownClosest(head)), ...groundRows(head)];
}

/** Of a show with drones on the ground, those that are closest in the air. */
function shownClosest(head: Head): ClosestPair | ClosestEncounter | undefined {
  if (head.kind === 'snapshot') return head.risk.closest;
  const { closest, closest_in_the_air } = head.risk;
  return closest?.stands ? closest_in_the_air : closest;
}

/** The closest of all, where one of the two stands on the ground. */
function groundRows(head: Head): Row[] {
  if (head.kind === 'snapshot' || !head.risk.closest?.stands) return [];
  const { distance_m } = head.risk.closest;
  const label = nounOf(head).one === 'aircraft' ? kWithStill : kWithGround;
  return [{ label, value: formatBelow(distance_m, head.threshold_m), number: distance_m, unit: 'metres' }];
}

/** How close the closest two are: in a straight line, or horizontally and in height where each has its limit. */
function closestRows(head: Head, closest: ClosestPair | undefined): Row[] {
  if (!closest) return [];
  const label = head.kind === 'snapshot' ? 'Closest pair' : 'Closest encounter';
  const { distance_m, horizontal_m = NaN, height_m = NaN } = closest;
  const { threshold_m, vertical_m } = head;
  const unit = 'metres';
  // Where that is not known, the page says no number of it.
  if (vertical_m === undefined || !Number.isFinite(horizontal_m) || !Number.isFinite(height_m)) {
    const none = head.kind === 'snapshot' ? head.risk.at_risk === 0 : head.risk.conflicts === 0;
    // In a cylinder two may be near each other and keep apart in height.
    const apart = none && vertical_m !== undefined ? ', not too close' : '';
    return [{ label, value: formatBelow(distance_m, threshold_m) + apart, number: distance_m, unit }];
  }
  const limits = limitsOf(head);
  const risky = head.kind === 'snapshot' ? head.risk.at_risk > 0 : head.risk.conflicts > 0;
  return [
    { label: `${label}, horizontally`, ofClosest: 'horizontally', value: formatHorizontal(horizontal_m, head), limit: limits.horizontal, risky, number: horizontal_m, unit },
    { label: `${label}, in height`, ofClosest: 'in height', value: formatVertical(height_m, head), limit: limits.vertical, risky, number: height_m, unit },
  ];
}

/** Of a recording, also who is known at no time. */
function countOf(head: Head): number {
  return head.count + (head.kind === 'recording' ? (head.risk.nowhere ?? 0) : 0);
}

function headline(shown: Shown): HTMLElement {
  const { head } = shown.swarm;
  if (head.kind === 'recording' && head.risk.nothing_compared) {
    return element('p', { class: 'headline' }, element('strong', {}, 'Nothing to compare'), `: of ${counted(countOf(head), nounOf(head))} no two are there at the same time`);
  }
  const count = head.kind === 'snapshot' ? head.risk.at_risk : head.risk.bees;
  const whole = head.risk.unknown === undefined;
  if (head.kind === 'snapshot' && !whole && count === 0) {
    const then = head.moment === undefined ? '' : ` at ${head.moment}`;
    return element('p', { class: 'headline' }, element('strong', {}, 'Not known of all'), `: of ${counted(head.count, nounOf(head))} none is known to be at risk${then}`);
  }
  if (head.kind === 'recording' && !whole && count === 0) {
    return element('p', { class: 'headline' }, element('strong', {}, 'Not known all the time'), `: of ${counted(countOf(head), nounOf(head))} none is known to be in conflict`);
  }
  const known = head.kind === 'recording' && !whole ? ' in the known time' : '';
  const when = shown.label ? 'in conflict' : 'in conflict at some time';
  const risk = whole ? 'at risk' : 'that are known at risk';
  const what = head.kind === 'snapshot' ? risk : known ? `in conflict${known}` : when;
  const moment = head.kind === 'snapshot' && head.moment !== undefined ? ` at ${head.moment}` : '';
  return element(
    'p',
    { class: count > 0 ? 'headline risky' : 'headline' },
    element('strong', {}, formatCount(count)),
    ` of ${counted(countOf(head), nounOf(head))} ${what}${moment}`,
    element('span', { class: 'share' }, ` (${formatShare(count, countOf(head))})`),
  );
}

/** A snapshot is no all-clear for what comes after it. */
function aheadWord({ swarm: { head } }: Shown): HTMLElement[] {
  if (head.kind !== 'snapshot' || head.risk.ahead === undefined) return [];
  const risky = (head.risk.ahead_count ?? 0) > 0;
  return [element('p', { class: risky ? 'headline risky ahead' : 'rule ahead' }, `Ahead: ${head.risk.ahead}.`)];
}

function closestButton(shown: Shown, closest: ClosestPair | ClosestEncounter | undefined, actions: Actions): HTMLElement | null {
  const { names, head } = shown.swarm;
  if (!closest) return null;
  const nameOf = (bee: number): string => (head.kind === 'recording' && 'time_s' in closest ? names.at(head.time.begins_s + closest.time_s, bee) : names.of(bee));
  const made = button('', { class: 'link' }, () => {
    const time = 'time_s' in closest ? { time_s: closest.time_s } : {};
    actions.select({ swarm: shown.index, bee: closest.first, other: closest.second, place: placeOf(shown, closest) }, { fly: true, ...time });
  });
  made.append(nameElement(nameOf(closest.first)), ' and ', nameElement(nameOf(closest.second)));
  made.setAttribute('aria-label', `Show the closest pair, ${isolate(nameOf(closest.first))} and ${isolate(nameOf(closest.second))}`);
  return made;
}

function groundButton(shown: Shown, actions: Actions): HTMLElement | null {
  const { risk } = shown.swarm.head;
  return closestButton(shown, risk.closest, actions);
}

/** Its place in the list of those that are too close; of two that are not there is none. */
function placeOf({ swarm }: Shown, closest: ClosestPair | ClosestEncounter): number | null {
  const { first, second } = pairsOf(swarm);
  const isIt = (place: number): boolean => {
    if (first[place] !== closest.first || second[place] !== closest.second) return false;
    if (swarm.kind === 'snapshot' || !('time_s' in closest)) return true;
    const { begins_s, ends_s } = swarm.conflicts;
    const rounding_s = kTimeRounding * (swarm.head.time.ends_s - swarm.head.time.begins_s);
    return closest.time_s >= begins_s[place] - rounding_s && closest.time_s <= ends_s[place] + rounding_s;
  };
  const place = Array.from(first.keys()).findIndex(isIt);
  return place < 0 ? null : place;
}

function change(before: Row, after: Row): string {
  if (before.number === undefined || after.number === undefined) return '';
  const difference = after.number - before.number;
  if (difference === 0) return 'same';
  const size = Math.abs(difference);
  const sign = difference > 0 ? '+' : '\u2212';
  if (before.unit === 'metres') return sign + formatMetres(size, 3);
  if (before.unit === 'seconds') return sign + formatDuration(size);
  return sign + formatCount(size);
}

/** The closest pair: how close, and who; with two limits first who, then each separation beside its own. */
function closestFacts(rows: Row[], link: HTMLElement | null): HTMLElement[] {
  const fact = (label: string, kind: string, ...children: (Node | string | null)[]): HTMLElement =>
    element('div', {}, element('dt', kind ? { class: kind } : {}, label), element('dd', {}, ...children));
  const who = link && element('span', { class: 'who' }, link);
  const [first] = rows;
  if (!first) return [];
  if (!first.ofClosest) return [fact(first.label, '', element('span', { class: 'figure' }, first.value), who)];
  return [
    fact(first.label.split(',')[0], '', who),
    ...rows.map(({ ofClosest = '', value, limit = '', risky }) =>
      fact(ofClosest, 'of-closest', element('span', { class: risky ? 'figure risky' : 'figure' }, value), element('span', { class: 'own-limit' }, ` limit ${limit}`)),
    ),
  ];
}

function single(shown: Shown, actions: Actions): Node[] {
  const noun = nounOf(shown.swarm.head);
  const told = [...kInHeadline, capitalised(noun.several)];
  const rows = rowsOf(shown, noun).filter(({ label }) => !told.includes(label));
  // How close, and who, comes first.
  const isClosest = ({ label }: Row): boolean => label.startsWith('Closest') && label !== kWithGround;
  const list = element(
    'dl',
    { class: 'facts' },
    ...closestFacts(rows.filter(isClosest), closestButton(shown, shownClosest(shown.swarm.head), actions)),
    ...closestFacts(rows.filter(({ label }) => label === kWithGround), groundButton(shown, actions)),
    ...rows
      .filter((row) => !isClosest(row) && row.label !== kWithGround)
      .map(({ label, value }) =>
        element('div', {}, element('dt', {}, label), element('dd', value.length > kLong ? { class: 'long' } : {}, element('span', { class: 'figure' }, value))),
      ),
  );
  return [headline(shown), ...aheadWord(shown), element('p', { class: 'rule' }, `Too close: ${tooClose(shown.swarm.head)}.`), ...flatWord([shown]), list];
}

/** Where the input has no heights, that is said beside the verdict. */
function flatWord(all: Shown[]): Node[] {
  if (!all.every(({ swarm }) => swarm.head.flat)) return [];
  return [element('p', { class: 'rule flat-word' }, 'In two dimensions: the input has no heights.')];
}

function beside(both: Shown[], actions: Actions): Node[] {
  const noun = nounOfAll(both);
  const [before, after] = both.map((shown) => rowsOf(shown, noun));
  const labels = [...new Set([...before, ...after].map((row) => row.label))];
  const rule = [...new Set(both.map(({ swarm }) => tooClose(swarm.head)))];
  const body = labels.map((label) => {
    const pair = [before, after].map((rows) => rows.find((row) => row.label === label));
    const cells = pair.map((row) => element('td', {}, row ? row.value : '–'));
    const difference = pair[0] && pair[1] ? change(pair[0], pair[1]) : '';
    return element('tr', {}, element('th', { scope: 'row' }, label), ...cells, element('td', { class: 'change' }, difference));
  });
  const heads = ['', 'Before', 'After', 'Change'].map((text) =>
    text ? element('th', { scope: 'col' }, text) : element('td'),
  );
  return [
    element('div', { class: 'headlines' }, ...both.map((shown) =>
      element('div', {}, element('h3', {}, shown.label), headline(shown)))),
    element('p', { class: 'rule' }, rule.length > 1 ? `Too close before: ${rule[0]}; after: ${rule[1]}.` : `Too close: ${rule[0]}.`),
    ...flatWord(both),
    element('table', { class: 'beside' }, element('thead', {}, element('tr', {}, ...heads)), element('tbody', {}, ...body)),
    ...both.map((shown) => {
      const link = closestButton(shown, shownClosest(shown.swarm.head), actions);
      return element('p', { class: 'who' }, link ? `Closest ${shown.label.toLowerCase()}: ` : '', link);
    }),
  ];
}

export function summaryPanel(all: Shown[], actions: Actions): HTMLElement {
  return panel('summary', 'Summary', ...(all.length === 2 ? beside(all, actions) : single(all[0], actions)));
}
