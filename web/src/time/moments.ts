// Moments to write below a chart over time: round ones, as clocks and calendars have them.
import { clockTime, steadyStretches, tellsClock, type Calendar } from '../text/calendar';
import { niceAbove, niceTicks } from '../text/nice_steps';
import { decimalsFor, formatSeconds } from '../text/numbers';

export interface Moment {
  time_s: number;
  text: string;
}

const kDay_s = 86400;
const kClockSteps_s = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200, kDay_s];

/** So many seconds, minutes or hours as a clock shows at a glance; of longer times whole days. */
export function clockStep(atLeast_s: number): number {
  const step_s = kClockSteps_s.find((one) => one >= atLeast_s);
  if (step_s !== undefined) return step_s;
  const ten_s = kDay_s * 10 ** Math.floor(Math.log10(atLeast_s / kDay_s));
  return ten_s * ([1, 2, 5].find((days) => days * ten_s >= atLeast_s) ?? 10);
}

/** The same, and parts of a second below one. */
export function shortStep(atLeast_s: number): number {
  return atLeast_s < 1 ? niceAbove(atLeast_s) : clockStep(atLeast_s);
}

/** About as many as wanted, ascending; seconds of a recording's own zero are counted by tens, and those of a clock as it shows them. */
export function momentsWithin(begins_s: number, ends_s: number, calendar: Calendar, wanted: number): Moment[] {
  if (!tellsClock(calendar) || ends_s - begins_s < wanted) {
    const times = niceTicks(begins_s, ends_s, wanted);
    const decimals = times.length > 1 ? decimalsFor(times[1] - times[0]) : times.every(Number.isInteger) ? 0 : 1;
    return times.map((time_s) => ({ time_s, text: clockText(time_s, calendar, decimals, 0) }));
  }
  const step_s = clockStep((ends_s - begins_s) / wanted);
  return steadyStretches(calendar).flatMap(({ from_s, until_s, ahead_s }) => {
    const moments: Moment[] = [];
    const first_s = Math.ceil((Math.max(begins_s, from_s) + ahead_s) / step_s) * step_s - ahead_s;
    for (let time_s = first_s; time_s <= ends_s && time_s < until_s; time_s += step_s) {
      moments.push({ time_s, text: clockText(time_s, calendar, 0, step_s) });
    }
    return moments;
  });
}

/** Whole days are dates; whole minutes need no seconds. */
function clockText(time_s: number, calendar: Calendar, decimals: number, step_s: number): string {
  const shown = clockTime(time_s, calendar, decimals);
  if (!shown) return formatSeconds(time_s, decimals);
  if (step_s >= kDay_s && shown.day !== '') return shown.day;
  return step_s >= 60 ? shown.time.slice(0, 5) : shown.time;
}
