// The bar below the swarm: play, step, speed, what time it is, and the plot.
import type { Recording } from '../data/recording';
import type { Shown } from '../panels/shown';
import type { Choices } from '../state/choices';
import { formatTime } from '../text/calendar';
import { nounOfAll } from '../text/noun';
import { button, element } from '../text/element';
import { decimalsWithin, formatCount, formatDuration } from '../text/numbers';
import { kSpeeds } from './clock';
import { closestAt } from './closest_at';
import { icon, type Icon } from './icons';
import type { LinkedTimes } from './linked_times';
import { SeparationPlot } from './separation_plot';
import { unknownText } from './unknown';

/** When a conflict of any of the recordings begins, as the clock counts; ascending. */
export function conflictBeginnings(all: Shown[], times: LinkedTimes): Float64Array {
  const begins = all.flatMap((shown) =>
    shown.swarm.kind === 'recording'
      ? Array.from(shown.swarm.conflicts.begins_s, (time) => times.clockTime(shown, time))
      : [],
  );
  return Float64Array.from(new Set(begins)).sort();
}

function statement(shown: Shown & { swarm: Recording }, within_s: number, inConflict: number): string {
  const start = shown.label ? `${shown.label}: ` : '';
  const unknown = unknownText(shown.swarm, within_s);
  const risk = [`${formatCount(inConflict)} in conflict`, unknown].filter(Boolean).join(' · ');
  const closest = closestAt(shown.swarm, within_s);
  if (closest === 'open') return `${start}${risk} · closest two unknown here`;
  if (closest === null) return start + risk;
  const { apart, when, pair } = closest;
  const what = shown.swarm.head.vertical_m !== undefined && shown.swarm.separation.apart ? 'nearest to a conflict:' : 'closest two';
  return `${start}${risk} · ${what} ${apart}${when} (${pair})`;
}

function iconButton(name: Icon, label: string, key: string, act: () => void): HTMLButtonElement {
  const made = button('', { 'aria-label': label, title: `${label} (${key})` }, act);
  made.append(icon(name));
  return made;
}

/** Lines of velocity lead so far ahead. */
function vectorTitle(all: Shown[]): string {
  const ahead = all.flatMap(({ swarm, view }) => (swarm.kind === 'recording' && view ? [formatDuration(view.aheadOf(swarm.fixes), 2)] : []));
  return `A line from each ${nounOfAll(all).one} to where it would be after ${[...new Set(ahead)].join(' or ') || 'a while'} (v)`;
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
    read.textContent = formatTime(times.zero_s + time, times.calendar, decimalsWithin(clock.ends_s - clock.begins_s));
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
