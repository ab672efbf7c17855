// How a drone show keeps the limits that it declares, and its cues.
import type { LimitName, LimitsKept, RecordingHead } from '../data/page';
import { formatMoment } from '../text/calendar';
import { button, element, panel } from '../text/element';
import { isolate, nameElement } from '../text/names';
import { formatCount, formatDigits } from '../text/numbers';
import type { Actions, Shown } from './shown';

const kListed = 20;

export const kLimits: Record<LimitName, { name: string; unit: string }> = {
  horizontal: { name: 'Horizontal speed', unit: 'm/s' },
  climb: { name: 'Climb', unit: 'm/s' },
  descent: { name: 'Descent', unit: 'm/s' },
  height: { name: 'Height', unit: 'm' },
  acceleration: { name: 'Acceleration', unit: 'm/s²' },
  horizontal_acceleration: { name: 'Horizontal acceleration', unit: 'm/s²' },
  vertical_acceleration: { name: 'Vertical acceleration', unit: 'm/s²' },
};

/** Never a number that looks kept where it is not. */
export function formatLimited(value: number, most: number, unit: string): string {
  for (let digits = 4; digits < 15; ++digits) {
    const told = Number(value.toPrecision(digits));
    if ((told > most) === (value > most)) return `${digits === 4 ? formatDigits(value, 4) : told}\u202f${unit}`;
  }
  return `${value}\u202f${unit}`;
}

function beeButton(shown: Shown, bee: number, time_s: number, what: string, actions: Actions): HTMLElement {
  const name = shown.swarm.names.of(bee);
  const made = button('', { class: 'link', 'aria-label': `Show ${isolate(name)}, ${what}` }, () =>
    actions.select({ swarm: shown.index, bee, other: null, place: null }, { fly: true, time_s }),
  );
  made.append(nameElement(name));
  return made;
}

function greatestTable(shown: Shown, head: RecordingHead, actions: Actions): HTMLElement | null {
  const kept = head.limits_kept ?? { count: 0, greatest: [], excesses: [] };
  if (kept.greatest.length === 0) return null;
  const rows = kept.greatest.map(({ limit, most, value, bee, time_s }, place) => {
    const { name, unit } = kLimits[limit];
    const broken = kept.excesses.some((excess) => excess.limit === place);
    const who = beeButton(shown, bee, time_s, `at its greatest: ${name.toLowerCase()}`, actions);
    return element(
      'tr',
      {},
      element('th', { scope: 'row' }, name),
      element('td', {}, `${most}\u202f${unit}`),
      element('td', { class: broken ? 'risky' : '' }, formatLimited(value, most, unit)),
      element('td', {}, who, ` at ${formatMoment(time_s, head.time)}`),
    );
  });
  const heads = ['', 'Limit', 'Greatest', 'Of whom'].map((text) => (text ? element('th', { scope: 'col' }, text) : element('td')));
  return element('table', { class: 'beside facts-beside limits-kept' }, element('thead', {}, element('tr', {}, ...heads)), element('tbody', {}, ...rows));
}

function excessList(shown: Shown, head: RecordingHead, actions: Actions): HTMLElement | null {
  const { count, greatest, excesses } = head.limits_kept ?? { count: 0, greatest: [], excesses: [] };
  if (excesses.length === 0) return null;
  const items = excesses.slice(0, kListed).map(({ limit, bee, value, time_s }) => {
    const { name, unit } = kLimits[greatest[limit].limit];
    return element(
      'li',
      {},
      beeButton(shown, bee, time_s, `beyond the limit of ${name.toLowerCase()}`, actions),
      element('span', { class: 'figure' }, formatLimited(value, greatest[limit].most, unit)),
      element('span', { class: 'when' }, ` ${name.toLowerCase()} at ${formatMoment(time_s, head.time)}`),
    );
  });
  if (count > kListed) items.push(element('li', { class: 'more' }, `and ${formatCount(count - kListed)} more`));
  return element('ul', { class: 'neighbours' }, ...items);
}

/** Distances are told elsewhere. */
export function headlineOf({ count, greatest, not_looked_at = [] }: Pick<LimitsKept, 'count' | 'greatest' | 'not_looked_at'>): { text: string; risky: boolean } {
  const kept = greatest.length > 0 ? ['Greatest speeds, accelerations and height that the show declares: kept.'] : [];
  const told = count === 0 ? kept : [`Beyond what the show declares: ${formatCount(count)} ${count === 1 ? 'stretch' : 'stretches'}.`];
  if (not_looked_at.length > 0) told.push(`Declared, but not looked at: ${not_looked_at.join(', ')}.`);
  return { text: told.join(' '), risky: count > 0 || not_looked_at.length > 0 };
}

function headline({ limits_kept }: RecordingHead): HTMLElement {
  const { text, risky } = headlineOf(limits_kept ?? { count: 0, greatest: [] });
  return element('p', { class: risky ? 'rule risky' : 'rule' }, text);
}

function cueList(head: RecordingHead, shown: Shown, toTime: (shown: Shown, time_s: number) => void): HTMLElement | null {
  const { cues } = head;
  if (!cues || cues.length === 0) return null;
  const items = cues.map(({ time_s, name }) =>
    element(
      'li',
      {},
      button(formatMoment(time_s, head.time), { class: 'link' }, () => toTime(shown, time_s)),
      nameElement(name),
    ),
  );
  return element('div', {}, element('h3', {}, `Cues (${formatCount(cues.length)})`), element('ul', { class: 'neighbours cues' }, ...items));
}

/** Nothing where no show says anything of itself. */
export function limitsPanel(all: Shown[], actions: Actions, toTime: (shown: Shown, time_s: number) => void): HTMLElement | null {
  const parts = all.flatMap((shown) => {
    const { head } = shown.swarm;
    if (head.kind !== 'recording' || (!head.limits_kept && !head.cues?.length)) return [];
    const label = shown.label ? element('h3', {}, shown.label) : null;
    const limits = head.limits_kept ? [headline(head), greatestTable(shown, head, actions), excessList(shown, head, actions)] : [];
    return [element('div', {}, label, ...limits, cueList(head, shown, toTime))];
  });
  return parts.length === 0 ? null : panel('show', 'The show', ...parts);
}
