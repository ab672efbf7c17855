// The bar below the swarm: play, step, speed, what time it is, and the plot.
import type { Recording } from '../data/recording';
import { sampleAt } from '../data/recording';
import type { Shown } from '../panels/shown';
import type { Choices } from '../state/choices';
import { button, element } from '../text/element';
import { formatHorizontal, formatVertical } from '../text/apart';
import { isolate } from '../text/names';
import { decimalsWithin, formatBelow, formatCount, formatDuration, formatTime } from '../text/numbers';
import { kSpeeds } from './clock';
import { icon, type Icon } from './icons';
import type { LinkedTimes } from './linked_times';
import { SeparationPlot } from './separation_plot';
import { isOpenAt, unknownText } from './unknown';

/** When a conflict of any of the recordings begins, as the clock counts; ascending. */
export function conflictBeginnings(all: Shown[], times: LinkedTimes): Float64Array {
  const begins = all.flatMap((shown) =>
    shown.swarm.kind === 'recording'
      ? Array.from(shown.swarm.conflicts.begins_s, (time) => times.clockTime(shown, time))
      : [],
  );
  return Float64Array.from(new Set(begins)).sort();
}

/** Moments nearer to each other than this are one. */
const kMoment_s = 1e-6;

/** The conflict that is at its closest in the moment shown, so that the moment says what its row says. */
function closestAt({ conflicts }: Recording, within_s: number): number {
  return conflicts.closest_s.findIndex((time_s) => Math.abs(time_s - within_s) < kMoment_s);
}

function statement(shown: Shown & { swarm: Recording }, within_s: number, inConflict: number): string {
  const { separation, names, conflicts, head } = shown.swarm;
  const start = shown.label ? `${shown.label}: ` : '';
  const unknown = unknownText(shown.swarm, within_s);
  const risk = [`${formatCount(inConflict)} in conflict`, unknown].filter(Boolean).join(' · ');
  const exact = closestAt(shown.swarm, within_s);
  const sample = sampleAt(separation.time_s, within_s);
  // Others may be closer to each other in that moment.
  const closest = exact >= 0 && (separation.apart !== null || sample < 0 || conflicts.distance_m[exact] <= separation.distance_m[sample]);
  if (!closest && isOpenAt(separation, within_s)) return `${start}${risk} · closest two unknown here`;
  const [of, place] = closest ? [conflicts, exact] : [separation, sample];
  if (place < 0) return start + risk;
  // Between two samples the earlier one is shown, with its time; nothing of bees that have gone since.
  const since_s = closest ? 0 : within_s - separation.time_s[sample];
  const bees = [of.first[place], of.second[place]];
  if (since_s < -kMoment_s || !bees.every((bee) => shown.swarm.fixes.isThere(bee, within_s))) return start + risk;
  const { begins_s, ends_s, since_1970 } = head.time;
  const told_s = begins_s + within_s - since_s;
  const when = since_s > kMoment_s ? ` at ${formatTime(told_s, since_1970, decimalsWithin(ends_s - begins_s))}` : '';
  const pair = bees.map((bee) => isolate(names.of(bee))).join(' and ');
  if (of.apart && head.vertical_m !== undefined) {
    const apart = `${formatHorizontal(of.apart.horizontal_m[place], head)} horizontally, ${formatVertical(of.apart.height_m[place], head)} in height`;
    return `${start}${risk} · nearest to a conflict: ${apart}${when} (${pair})`;
  }
  return `${start}${risk} · closest two ${formatBelow(of.distance_m[place], head.threshold_m, 3)}${when} (${pair})`;
}

function iconButton(name: Icon, label: string, key: string, act: () => void): HTMLButtonElement {
  const made = button('', { 'aria-label': label, title: `${label} (${key})` }, act);
  made.append(icon(name));
  return made;
}

/** Lines of velocity lead so far ahead. */
function vectorTitle(all: Shown[]): string {
  const ahead = all.flatMap(({ swarm, view }) => (swarm.kind === 'recording' && view ? [formatDuration(view.aheadOf(swarm.fixes), 2)] : []));
  return `A line from each bee to where it would be after ${[...new Set(ahead)].join(' or ') || 'a while'} (v)`;
}

export interface Timeline {
  box: HTMLElement;
  goToConflict: (direction: 1 | -1) => void;
}

export function timeline(all: Shown[], times: LinkedTimes, choices: Choices): Timeline {
  const { clock } = times;
  const beginnings = conflictBeginnings(all, times);
  const goToConflict = (direction: 1 | -1): void => {
    const now = clock.time.value;
    const found =
      direction > 0
        ? beginnings.find((time) => time > now + 1e-9)
        : Array.from(beginnings).reverse().find((time) => time < now - 1e-9);
    clock.pause();
    if (found !== undefined) clock.go(found);
  };

  const play = button('', { class: 'play', title: 'Play or pause (Space)' }, () => clock.toggle());
  clock.playing.watch((playing) => {
    play.replaceChildren(icon(playing ? 'pause' : 'play'));
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
  });
  const speed = element('select', { 'aria-label': 'Speed', title: 'Speed (< and >)' });
  speed.append(...kSpeeds.map((value) => element('option', { value: String(value) }, `${value}×`)));
  speed.addEventListener('change', () => clock.speed.set(Number(speed.value)));
  clock.speed.watch((value) => (speed.value = String(value)));

  const trails = element('input', { type: 'checkbox', id: 'trails' });
  trails.addEventListener('change', () => choices.trails.set(trails.checked));
  choices.trails.watch((on) => (trails.checked = on));

  const vectors = element('input', { type: 'checkbox', id: 'vectors' });
  vectors.addEventListener('change', () => choices.vectors.set(vectors.checked));
  choices.vectors.watch((on) => (vectors.checked = on));

  const read = element('output', { class: 'time-now', 'aria-label': 'Time shown' });
  const says = element('p', { class: 'time-says' });
  clock.time.watch((time) => {
    read.textContent = formatTime(times.zero_s + time, times.since1970, decimalsWithin(clock.ends_s - clock.begins_s));
    document.documentElement.dataset.timeS = time.toFixed(3);
    const statements = all.flatMap((shown) => {
      if (shown.swarm.kind !== 'recording') return [];
      const within = times.within(shown);
      const inConflict = shown.swarm.spans.beesAt(within).length;
      return [element('span', {}, statement({ ...shown, swarm: shown.swarm }, within, inConflict))];
    });
    says.replaceChildren(...statements);
  });

  const box = element(
    'section',
    { class: 'timeline', 'aria-label': 'Time line' },
    element(
      'div',
      { class: 'time-controls', role: 'group', 'aria-label': 'Playing' },
      iconButton('conflictBefore', 'To the conflict before', '[', () => goToConflict(-1)),
      iconButton('back', 'A step back', ',', () => clock.step(-1)),
      play,
      iconButton('on', 'A step on', '.', () => clock.step(1)),
      iconButton('nextConflict', 'To the next conflict', ']', () => goToConflict(1)),
      speed,
      element('label', { class: 'check', for: 'trails' }, trails, 'Trails'),
      element('label', { class: 'check', for: 'vectors', title: vectorTitle(all) }, vectors, 'Vectors'),
      read,
    ),
    says,
    new SeparationPlot(all, times).box,
  );
  return { box, goToConflict };
}
