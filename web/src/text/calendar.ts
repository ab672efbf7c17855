// When something is, as text: seconds from a zero of the recording's own, or what a clock shows then, in UTC, in the zone that was
// named, or as it stands in the file, where it names none.
import type { ClockHead, RecordingTime } from '../data/page';
import { decimalsWithin, formatSeconds } from './numbers';

/** How the numbers of a recording are told; turns of its clock count from `begins_s`. */
export type Calendar = Pick<RecordingTime, 'begins_s' | 'since_1970' | 'clock'>;

/** No clock: seconds. */
export const kSeconds: Calendar = { begins_s: 0, since_1970: false };

export interface ClockTime {
  /** 2024-05-01; empty where it is not known. */
  day: string;
  time: string;
  /** UTC, +02:00; empty where the input names no zone. */
  zone: string;
}

/** Stretches in which the clock is not turned: until when, as the recording counts, and how far it is ahead. */
export function steadyStretches({ begins_s, clock }: Calendar): { from_s: number; until_s: number; ahead_s: number }[] {
  const offsets = clock?.offsets ?? [{ from_s: 0, ahead_s: 0 }];
  return offsets.map(({ from_s, ahead_s }, i) => ({
    from_s: i === 0 ? -Infinity : begins_s + from_s,
    until_s: i + 1 < offsets.length ? begins_s + offsets[i + 1].from_s : Infinity,
    ahead_s,
  }));
}

export function tellsClock({ since_1970, clock }: Calendar): boolean {
  return since_1970 || clock !== undefined;
}

/** +02:00, as far as clocks of zones go; to the second before there were zones. */
export function offsetText(ahead_s: number): string {
  const two = (value: number): string => String(value).padStart(2, '0');
  const size = Math.abs(ahead_s);
  const seconds = size % 60 === 0 ? '' : `:${two(size % 60)}`;
  return `${ahead_s < 0 ? '-' : '+'}${two(Math.floor(size / 3600))}:${two(Math.floor(size / 60) % 60)}${seconds}`;
}

/** Null where times are seconds, or beyond all dates. */
export function clockTime(seconds: number, calendar: Calendar, decimals: number): ClockTime | null {
  if (!tellsClock(calendar)) return null;
  const { clock, since_1970 } = calendar;
  const ahead_s = steadyStretches(calendar).find(({ until_s }) => seconds < until_s)?.ahead_s ?? 0;
  const shown_ms = Math.round((seconds + ahead_s) * 1000);
  if (!(Math.abs(shown_ms) < 8e15)) return null;
  const [day, time] = new Date(shown_ms).toISOString().split('T');
  return {
    day: clock?.dated === false ? '' : day,
    time: time.slice(0, decimals > 0 ? 9 + Math.min(3, decimals) : 8),
    zone: clock ? (since_1970 ? offsetText(ahead_s) : '') : 'UTC',
  };
}

/** 2024-05-01 12:00:00.25 UTC, 2024-05-01 14:00:00.25 +02:00, 12:00:00.25; or 63.2 s. */
export function formatTime(seconds: number, calendar: Calendar, decimals = 1): string {
  const shown = clockTime(seconds, calendar, decimals);
  return shown ? [shown.day, shown.time, shown.zone].filter(Boolean).join(' ') : formatSeconds(seconds, decimals);
}

/** So many seconds from the beginning of a recording. */
export function formatMoment(within_s: number, time: RecordingTime): string {
  return formatTime(time.begins_s + within_s, time, decimalsWithin(time.ends_s - time.begins_s));
}

/** For tables to copy: 2024-05-01T12:00:00.250Z, 2024-05-01T14:00:00.250+02:00; without a zone 2024-05-01 12:00:00.250. */
export function isoTime(seconds: number, calendar: Calendar): string {
  const shown = clockTime(seconds, calendar, 3);
  if (!shown) return '';
  if (shown.zone === '') return [shown.day, shown.time].filter(Boolean).join(' ');
  return `${shown.day}T${shown.time}${shown.zone === 'UTC' || shown.zone === '+00:00' ? 'Z' : shown.zone}`;
}

/** UTC, +02:00; "local" where the clock is turned in between. */
export function zoneWord(calendar: Calendar): string {
  const { since_1970, clock } = calendar;
  if (!since_1970) return 'time';
  if (!clock) return 'UTC';
  return clock.offsets.length === 1 ? offsetText(clock.offsets[0].ahead_s) : 'local';
}

/** Of two recordings with clocks of one kind: how both are told, in the numbers of the first. */
export function joined(one: Calendar, other: Calendar): Calendar {
  if (!one.since_1970 || !one.clock || !other.clock) return one;
  const begins_s = Math.min(one.begins_s, other.begins_s);
  const all = [one, other].flatMap(({ begins_s: own_s, clock }) => (clock?.offsets ?? []).map(({ from_s, ahead_s }) => ({ from_s: own_s + from_s - begins_s, ahead_s })));
  all.sort((a, b) => a.from_s - b.from_s);
  const offsets = all.filter(({ ahead_s }, i) => i === 0 || ahead_s !== all[i - 1].ahead_s);
  return { begins_s, since_1970: true, clock: { ...one.clock, offsets } };
}

/** Whether both have the same kind of clock, so that their times can be laid beside each other. */
export function areAlike(one: Calendar, other: Calendar): boolean {
  const kindOf = (clock: ClockHead | undefined): string => (clock ? `${clock.dated} ${clock.zone ?? ''}` : '');
  return one.since_1970 === other.since_1970 && kindOf(one.clock) === kindOf(other.clock);
}

/** What a clock without a zone shows at 0, so that two of them can be compared. */
export function zeroOf({ since_1970, clock }: Calendar): number {
  return since_1970 ? 0 : (clock?.offsets[0]?.ahead_s ?? 0);
}
