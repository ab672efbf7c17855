// The bees that are too close to each other: pairs of a snapshot, conflicts of a recording.
import { apartOf, pairsOf, type Swarm } from '../data/swarm';
import type { Choices } from '../state/choices';
import { csvOf, fileName, saveFile } from '../save';
import { formatApart, rankOf } from '../text/apart';
import { clockTime, formatTime, isoTime, tellsClock } from '../text/calendar';
import { button, element, panel } from '../text/element';
import { nameElement } from '../text/names';
import { decimalsWithin, formatBelow, formatCount, formatDuration, formatSeconds } from '../text/numbers';
import { capitalised, nounOf } from '../text/noun';
import { PagedTable, type TableColumn } from './paged_table';
import type { Actions, Shown } from './shown';

const kDay_s = 86400;

/** Numbers that sort bees as their names do, digits by their value. */
function rankNames(shown: Shown): (bee: number) => number {
  const { names } = shown.swarm;
  if (names.areNumbers) return (bee) => bee;
  let ranks: Map<number, number> | null = null;
  return (bee) => {
    if (!ranks) {
      const { first, second } = pairsOf(shown.swarm);
      const named = Array.from(new Set([...first, ...second]), (one) => ({ one, name: names.of(one) }));
      const { compare } = new Intl.Collator('en', { numeric: true });
      named.sort((a, b) => compare(a.name, b.name));
      ranks = new Map(named.map(({ one }, rank) => [one, rank]));
    }
    return ranks.get(bee) ?? 0;
  };
}

/** What a bee of that pair is called, when the two are closest. */
function nameIn(swarm: Swarm, place: number, bee: number): string {
  return swarm.kind === 'snapshot' ? swarm.names.of(bee) : swarm.names.at(swarm.head.time.begins_s + swarm.conflicts.closest_s[place], bee);
}

function columnsOf(shown: Shown): TableColumn[] {
  const { swarm } = shown;
  const { first, second, distance_m } = pairsOf(swarm);
  const rank = rankNames(shown);
  const bee = (label: string, bees: Uint32Array): TableColumn => ({
    label,
    rank: (place) => rank(bees[place]),
    cell: (place) => nameElement(nameIn(swarm, place, bees[place])),
  });
  const columns: TableColumn[] = [
    bee(capitalised(nounOf(swarm.head).one), first),
    bee('Other', second),
    {
      label: swarm.kind === 'snapshot' ? 'Distance' : 'Closest',
      rank: (place) => (swarm.kind === 'snapshot' ? distance_m[place] : rankOf(distance_m[place], apartOf(swarm, place), swarm.head)),
      cell: (place) =>
        swarm.kind === 'snapshot'
          ? formatBelow(distance_m[place], swarm.head.threshold_m, 4)
          : formatApart(distance_m[place], apartOf(swarm, place), swarm.head),
      numeric: true,
    },
  ];
  if (swarm.kind === 'recording') {
    const { conflicts, head } = swarm;
    const decimals = decimalsWithin(head.time.ends_s - head.time.begins_s);
    const days = head.time.ends_s - head.time.begins_s > kDay_s;
    const turned = (head.time.clock?.offsets.length ?? 0) > 1;
    columns.push(
      {
        label: 'At',
        rank: (place) => conflicts.closest_s[place],
        cell: (place) => {
          const within = conflicts.closest_s[place];
          const text = formatTime(head.time.begins_s + within, head.time, decimals);
          const shown = clockTime(head.time.begins_s + within, head.time, decimals);
          // Of a day the clock is enough, or the time since the beginning: the rest is in the time line.
          if (shown) return element('span', { title: text }, [days ? shown.day.slice(5) : '', shown.time, turned ? shown.zone : ''].filter(Boolean).join(' '));
          const long = Math.abs(head.time.begins_s) >= 1e5;
          return long ? element('span', { title: text }, `+${formatSeconds(within, decimals)}`) : text;
        },
        numeric: true,
      },
      {
        label: 'For',
        rank: (place) => conflicts.ends_s[place] - conflicts.begins_s[place],
        cell: (place) => {
          const text = formatDuration(conflicts.ends_s[place] - conflicts.begins_s[place], 2);
          return conflicts.certain[place] === 1 ? text : element('span', { title: 'Only possible' }, `${text} ?`);
        },
        numeric: true,
      },
    );
  }
  return columns;
}

function leftOut(shown: Shown): HTMLElement | null {
  const { swarm } = shown;
  const listed = pairsOf(swarm).first.length;
  const all = swarm.head.kind === 'snapshot' ? swarm.head.risk.pairs : swarm.head.risk.conflicts;
  if (all === listed) return null;
  const text = `The closest ${formatCount(listed)} of ${formatCount(all)}; the others are left out here and among the lines.`;
  return element('p', { class: 'left-out' }, text);
}

/** In metres and seconds, with every digit that the page has; times as dates, too, where they are known. */
function csvRows({ swarm }: Shown, places: Uint32Array): (string | number)[][] {
  const { first, second, distance_m, apart } = pairsOf(swarm);
  const names = (place: number): string[] => [first, second].map((bees) => nameIn(swarm, place, bees[place]));
  const both = (place: number): number[] => (apart ? [apart.horizontal_m[place], apart.height_m[place]] : []);
  const apartNames = apart ? ['horizontal_m', 'height_m'] : [];
  if (swarm.kind === 'snapshot') {
    return [['first', 'second', 'distance_m', ...apartNames], ...Array.from(places, (at) => [...names(at), distance_m[at], ...both(at)])];
  }
  const { conflicts, head } = swarm;
  const time = (within_s: number): number => Number((head.time.begins_s + within_s).toFixed(6));
  return [
    ['first', 'second', 'begins_s', 'closest_s', 'ends_s', 'closest_m', ...apartNames, 'certain', ...(tellsClock(head.time) ? ['begins', 'closest', 'ends'] : [])],
    ...Array.from(places, (at) => [
      ...names(at),
      time(conflicts.begins_s[at]),
      time(conflicts.closest_s[at]),
      time(conflicts.ends_s[at]),
      distance_m[at],
      ...both(at),
      conflicts.certain[at],
      ...(tellsClock(head.time) ? [conflicts.begins_s, conflicts.closest_s, conflicts.ends_s].map((times) => isoTime(head.time.begins_s + times[at], head.time)) : []),
    ]),
  ];
}

function tableOf(shown: Shown, choices: Choices, actions: Actions): HTMLElement {
  const { swarm, company, index } = shown;
  const { first, second } = pairsOf(swarm);
  const what = swarm.kind === 'snapshot' ? 'Pairs that are too close' : 'Conflicts';
  const table = new PagedTable(
    shown.label ? `${what}, ${shown.label.toLowerCase()}` : what,
    columnsOf(shown),
    first.length,
    { column: 2, descending: false },
    (place) => {
      const time = swarm.kind === 'recording' ? { time_s: swarm.conflicts.closest_s[place] } : {};
      actions.select({ swarm: index, bee: first[place], other: second[place], place }, { fly: true, ...time });
    },
    (place) => choices.selected.value?.swarm === index && choices.selected.value.place === place,
  );
  choices.selected.watch(() => table.refresh());
  choices.filter.watch(({ group }) => {
    table.filter(
      group && group.swarm === index ? (place) => company.groups.of[first[place]] === group.place : null,
    );
  });
  const save = button('Save as CSV', { class: 'quiet-button', title: 'The rows of this table, as they are sorted and filtered' }, () =>
    saveFile(fileName(swarm.head.title, 'csv'), new Blob([csvOf(csvRows(shown, table.places))], { type: 'text/csv' })),
  );
  table.box.lastElementChild?.prepend(save);
  return element('div', { class: 'table-of-one' }, shown.label ? element('h3', {}, shown.label) : null, leftOut(shown), table.box);
}

export function pairPanel(all: Shown[], choices: Choices, actions: Actions): HTMLElement {
  const heading = all.every(({ swarm }) => swarm.kind === 'snapshot') ? 'Pairs too close' : 'Conflicts';
  return panel('pairs', heading, ...all.map((shown) => tableOf(shown, choices, actions)));
}
