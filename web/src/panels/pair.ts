// The selected pair: how far apart the two are now and over time, how fast they close, and a look at it in slow motion.
import type { ApartNow } from '../data/pair_ways';
import { apartOf, pairsOf } from '../data/swarm';
import type { Choices, Selected } from '../state/choices';
import { formatApart, formatHorizontal, formatVertical } from '../text/apart';
import { formatMoment } from '../text/calendar';
import { button, element, panel } from '../text/element';
import { isolate, nameElement } from '../text/names';
import { formatBelow, formatCount, formatDuration, formatStep } from '../text/numbers';
import { formatSpeed } from '../text/speeds';
import type { Recording } from '../data/recording';
import type { LinkedTimes } from '../time/linked_times';
import { pairChart } from '../time/pair_chart';
import { seekable, type TimeChart } from '../time/time_chart';
import type { Shown } from './shown';

/**
 * Who closes slower than this, or than this share of the speed, does not; in the closest moment, which is told to a tick, than
 * the other share.
 */
const kStill_mps = 5e-4;
const kStillShare = 1e-4;
const kStillShareWhenClosest = 1e-2;

type Fact = [label: string, value: string, risky?: boolean];

/** So long before and after the closest moment one looks: longer for what lasts longer. */
const kAround_s = [5, 30, 60, 300, 1800, 7200, 21600];

/** Where the way of the pair stands in the list of ways; null where there is none. */
function wayOf(swarm: Recording, { place }: Selected): number | null {
  // Where there is no conflict, the only way is that of the closest encounter.
  const way = place ?? (swarm.conflicts.first.length === 0 ? 0 : null);
  return way !== null && swarm.pairWays.span(way) ? way : null;
}

function aroundOf(swarm: Recording, place: number | null): number {
  const lasts_s = place === null ? 0 : swarm.conflicts.ends_s[place] - swarm.conflicts.begins_s[place];
  return kAround_s.find((around_s) => lasts_s <= 4 * around_s) ?? kAround_s[kAround_s.length - 1];
}

function limitFacts(shown: Shown, apart: { distance_m: number; horizontal_m: number; height_m: number }): Fact[] {
  const { head } = shown.swarm;
  const inAll: Fact = ['Apart', formatBelow(apart.distance_m, head.threshold_m), apart.distance_m < head.threshold_m];
  if (head.flat) return [inAll];
  if (head.vertical_m === undefined) {
    return [
      inAll,
      ['Horizontally', formatHorizontal(apart.horizontal_m, head)],
      ['In height', formatVertical(apart.height_m, head)],
    ];
  }
  const [across, up] = [apart.horizontal_m < head.threshold_m, apart.height_m < head.vertical_m];
  return [
    ['Horizontally', formatHorizontal(apart.horizontal_m, head), across && up],
    ['In height', formatVertical(apart.height_m, head), across && up],
    ['In a straight line', formatBelow(apart.distance_m, head.threshold_m)],
  ];
}

/** Ways of pairs are kept to so much of the threshold: less than that is nothing. */
const kKept = 1e-5;

function rounded(apart: ApartNow, threshold_m: number): ApartNow {
  const least_m = kKept * threshold_m;
  const told = (metres: number): number => (metres < least_m ? 0 : metres);
  return { ...apart, horizontal_m: told(apart.horizontal_m), height_m: told(apart.height_m) };
}

/** What is known of a pair of a snapshot, or of the closest moment of a conflict. */
function stillFacts(shown: Shown, { bee, other, place }: Selected): Fact[] {
  const { swarm } = shown;
  const pairs = pairsOf(swarm);
  const closest = swarm.head.risk.closest;
  const isClosest = closest && Math.min(bee, other ?? bee) === closest.first && Math.max(bee, other ?? bee) === closest.second;
  const distance_m = place !== null ? pairs.distance_m[place] : isClosest ? closest.distance_m : null;
  if (distance_m === null) return [];
  const horizontal_m = place !== null ? pairs.apart?.horizontal_m[place] : closest?.horizontal_m;
  const height_m = place !== null ? pairs.apart?.height_m[place] : closest?.height_m;
  if (horizontal_m === undefined || height_m === undefined) return [['Apart', formatBelow(distance_m, swarm.head.threshold_m)]];
  return limitFacts(shown, { distance_m, horizontal_m, height_m });
}

function closestText(swarm: Recording, place: number): string {
  const { conflicts, head } = swarm;
  return `${formatApart(conflicts.distance_m[place], apartOf(swarm, place), head)} at ${formatMoment(conflicts.closest_s[place], head.time)}`;
}

/** How long a conflict lasts; and all of the two together, where that is known and they have more than this one. */
function durationFacts({ conflicts, head }: Recording, place: number): Fact[] {
  const lasts_s = (at: number): number => conflicts.ends_s[at] - conflicts.begins_s[at];
  const own = formatDuration(lasts_s(place));
  const [first, second] = [conflicts.first[place], conflicts.second[place]];
  const all = Array.from(conflicts.first.keys()).filter((at) => conflicts.first[at] === first && conflicts.second[at] === second);
  if (all.length < 2 || head.risk.conflicts > conflicts.first.length) return [['In conflict for', own]];
  const inAll_s = all.reduce((sum, at) => sum + lasts_s(at), 0);
  return [
    ['This conflict lasts', own],
    ['All of these two', `${formatCount(all.length)} conflicts, ${formatDuration(inAll_s)} in all`],
  ];
}

function nowFacts(shown: Shown, swarm: Recording, way: number, within_s: number): Fact[] {
  const apart = swarm.pairWays.at(way, within_s);
  if (!apart) return [['Now', 'beyond the time that is kept of this pair']];
  // In the closest moment it is as close as its row says.
  const closest = swarm.conflicts.closest_s[way] === within_s;
  if (closest) {
    const { distance_m, apart: told } = swarm.conflicts;
    apart.distance_m = distance_m[way];
    if (told && Number.isFinite(told.horizontal_m[way])) [apart.horizontal_m, apart.height_m] = [told.horizontal_m[way], told.height_m[way]];
  }
  // What rounding leaves of nothing is nothing.
  const still_mps = Math.max(kStill_mps, (closest ? kStillShareWhenClosest : kStillShare) * apart.relative_mps);
  // So it is where it is closest, unless that is how the conflict begins or ends; with a vertical threshold it need not be.
  const { begins_s, ends_s } = swarm.conflicts;
  const turns = closest && swarm.head.vertical_m === undefined && begins_s[way] < within_s && within_s < ends_s[way];
  const closing = turns || Math.abs(apart.closing_mps) < still_mps ? 0 : apart.closing_mps;
  return [
    ...limitFacts(shown, rounded(apart, swarm.head.threshold_m)),
    [closing >= 0 ? 'Closing' : 'Parting', formatSpeed(Math.abs(closing), swarm.head.heights)],
  ];
}

function factRows(facts: Fact[]): HTMLElement[] {
  return facts.map(([label, value, risky]) =>
    element('div', {}, element('dt', {}, label), element('dd', risky ? { class: 'risky' } : {}, value)),
  );
}

export function pairPanelOf(all: Shown[], choices: Choices, times: LinkedTimes): HTMLElement {
  const body = element('div');
  const box = panel('pair', 'Selected pair', body);
  const facts = element('dl', { class: 'facts compact' });
  let chart: TimeChart | null = null;
  let durations: Fact[] = [];

  const follow = (): void => {
    const selected = choices.selected.value;
    if (!selected || selected.other === null) return;
    const shown = all[selected.swarm];
    const { swarm } = shown;
    if (swarm.kind !== 'recording') return facts.replaceChildren(...factRows(stillFacts(shown, selected)));
    const within_s = times.within(shown);
    const way = wayOf(swarm, selected);
    const closest: Fact[] = selected.place === null ? [] : [['Closest', closestText(swarm, selected.place)]];
    const rows = way === null ? stillFacts(shown, selected) : [...nowFacts(shown, swarm, way, within_s), ...closest];
    rows.push(...durations);
    facts.replaceChildren(...factRows(rows));
    chart?.follow(within_s);
  };

  choices.selected.watch((selected) => {
    chart = null;
    box.hidden = !selected || selected.other === null;
    if (!selected || selected.other === null) return;
    const shown = all[selected.swarm];
    const { swarm } = shown;
    durations = swarm.kind === 'recording' && selected.place !== null ? durationFacts(swarm, selected.place) : [];
    const names = [selected.bee, selected.other].map((bee) => swarm.names.of(bee));
    const title = element('p', { class: 'who-they-are' }, nameElement(names[0]), ' and ', nameElement(names[1]));
    const parts: Node[] = [title];
    if (swarm.kind === 'recording') {
      const way = wayOf(swarm, selected);
      if (way !== null) {
        chart = pairChart(swarm, way, `How far apart ${isolate(names[0])} and ${isolate(names[1])} are over time`);
        parts.push(replayButton(shown, swarm, selected, way, times));
      }
    }
    parts.push(facts);
    if (chart) parts.push(seekable(chart, (time_s) => times.seek(shown, time_s)));
    body.replaceChildren(...parts);
    follow();
  });
  if (all.some(({ swarm }) => swarm.kind === 'recording')) times.clock.time.listen(follow);
  return box;
}

function replayButton(shown: Shown, swarm: Recording, { place }: Selected, way: number, times: LinkedTimes): HTMLElement {
  const around_s = aroundOf(swarm, place);
  const closest_s = swarm.conflicts.closest_s[way] ?? swarm.head.risk.closest?.time_s ?? 0;
  const middle = times.clockTime(shown, closest_s);
  const text = `Replay ±${formatStep(around_s)}`;
  return element(
    'p',
    { class: 'tools' },
    button(text, { title: 'From before they are closest to after it, in slow motion around it' }, () =>
      times.clock.replay(middle - around_s, middle + around_s, around_s / 5),
    ),
    button('To the closest moment', {}, () => times.seek(shown, closest_s)),
  );
}
