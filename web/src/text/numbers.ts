// Numbers as they are read: three or four digits that matter, thousands apart, with their unit.

const kThin = '\u202f';
const kMinus = '\u2212';

export function formatCount(count: number): string {
  const text = String(Math.round(Math.abs(count))).replace(/\B(?=(\d{3})+$)/g, ',');
  return count < 0 ? kMinus + text : text;
}

function plain(value: number, decimals: number): string {
  const [whole, fraction] = Math.abs(value).toFixed(decimals).split('.');
  const text = whole.replace(/\B(?=(\d{3})+$)/g, ',') + (fraction ? `.${fraction}` : '');
  return value < 0 && /[1-9]/.test(text) ? kMinus + text : text;
}

/** With `digits` that matter, but no more than micrometres. */
export function formatDigits(value: number, digits: number): string {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  return plain(value, Math.min(6, Math.max(0, digits - 1 - exponent)));
}

/** Below this, millimetres are read more easily. */
export const kSmall_m = 0.1;

function inMillimetres(metres: number): boolean {
  return metres !== 0 && Math.abs(metres) < kSmall_m;
}

/** Below this, micrometres, as of cells. */
export const kTiny_m = 1e-4;

function inMicrometres(metres: number): boolean {
  return metres !== 0 && Math.abs(metres) < kTiny_m;
}

/** A distance: 6 µm, 9.12 mm, 12.34 m, 1,234 m, 12.34 km. */
export function formatMetres(metres: number, digits = 4): string {
  if (!Number.isFinite(metres)) return '–';
  if (metres !== 0 && Math.abs(metres) < 5e-7) return `<${kThin}1${kThin}µm`;
  if (Math.abs(metres) >= 20000) return `${formatDigits(metres / 1000, digits)}${kThin}km`;
  if (inMicrometres(metres)) return `${formatDigits(metres * 1e6, digits)}${kThin}µm`;
  if (inMillimetres(metres)) return `${formatDigits(metres * 1000, digits)}${kThin}mm`;
  return `${formatDigits(metres, digits)}${kThin}m`;
}

/** Below a limit by what says nothing: a rounding. It is told as in the summaries of the command. */
function isJustUnder(value: number, limit: number): boolean {
  const nothing = 1e-7; // of the limit
  return value < limit && value > limit - nothing * limit;
}

/** A number below a limit, with so many digits that it reads as one: 4.997, not 5.00. Others have the least digits. */
export function readsBelow(value: number, limit: number, least: number, format: (value: number, digits: number) => string): string {
  if (isJustUnder(value, limit)) return `just under ${format(limit, least)}`;
  const read = (text: string): number => parseFloat(text.replace(/,/g, ''));
  for (let digits = least; value < limit && digits < least + 12; ++digits) {
    const text = format(value, digits);
    if (read(text) < limit) return text;
  }
  return format(value, least);
}

/** A distance below a limit, with so many digits that it reads as one: 4.9997 m, not 5.000 m. */
export function formatBelow(metres: number, limit_m: number, digits = 4): string {
  if (!(metres < limit_m)) return formatMetres(metres, digits);
  if (isJustUnder(metres, limit_m)) return `just under ${formatExactly(limit_m)}`;
  // Beside metres what is less than a millimetre says nothing.
  if (limit_m >= 1 && metres > 0 && metres < 0.001) return `<${kThin}1${kThin}mm`;
  const read = (text: string): number => {
    const value = parseFloat(text.replace(/,/g, ''));
    return text.endsWith('km') ? value * 1000 : value / (text.endsWith('mm') ? 1000 : text.endsWith('µm') ? 1e6 : 1);
  };
  for (let more = digits; more < 16; ++more) {
    const text = formatMetres(metres, more);
    if (text.startsWith('<') || read(text) < limit_m) return text;
  }
  return `<${kThin}${formatExactly(limit_m)}`;
}

/** A setting as it was given: 5 m, 0.125 m, 3 mm, 10 µm. */
export function formatExactly(metres: number): string {
  const [unit, perMetre] = inMicrometres(metres) ? ['µm', 1e6] as const : inMillimetres(metres) ? ['mm', 1000] as const : ['m', 1] as const;
  const value = perMetre > 1 ? Number((metres * perMetre).toPrecision(15)) : metres;
  const [whole, ...fraction] = String(Math.abs(value)).split('.');
  const text = [/^\d+$/.test(whole) ? formatCount(Number(whole)) : whole, ...fraction].join('.');
  return `${metres < 0 ? kMinus : ''}${text}${kThin}${unit}`;
}

/** The same, for a scale: 500 m, 20 km. */
export function formatTick(metres: number): string {
  if (Math.abs(metres) < 20000) return formatExactly(metres);
  return formatExactly(metres / 1000).replace('m', 'km');
}

function decimalsOf(error: number): number {
  return Math.max(0, Math.ceil(-Math.log10(error)));
}

/** A coordinate, to where the error of the shown position begins. */
export function formatCoordinate(metres: number, error_m: number): string {
  return `${plain(metres, error_m > 0 ? Math.min(6, decimalsOf(error_m)) : 3)}${kThin}m`;
}

/** A latitude or longitude, to where the error of the shown position begins; with a plain minus, to copy. */
export function formatDegrees(degrees: number, error_m: number): string {
  const perDegree_m = 111_000;
  return `${degrees.toFixed(error_m > 0 ? Math.min(9, decimalsOf(error_m / perDegree_m)) : 8)}°`;
}

/** An error bound, never made smaller by rounding. */
export function formatError(metres: number): string {
  if (metres === 0) return `0${kThin}m`;
  if (metres < 1e-8) return `0.01${kThin}µm`;
  const unit = metres >= 1 ? ['m', 1] as const : metres >= 0.001 ? ['mm', 1000] as const : ['µm', 1e6] as const;
  const value = metres * unit[1];
  const step = 10 ** (Math.floor(Math.log10(value)) - 1);
  const up = Math.ceil(value / step - 1e-9) * step;
  return `${formatDigits(up, 2)}${kThin}${unit[0]}`;
}

export function formatShare(part: number, whole: number): string {
  if (whole === 0) return '–';
  const percent = (100 * part) / whole;
  if (part > 0 && percent < 0.1) return `<${kThin}0.1${kThin}%`;
  if (part < whole && percent > 99.9) return `>${kThin}99.9${kThin}%`;
  return `${percent.toFixed(1)}${kThin}%`;
}

/** How long: 3.20 s, 4 min 05 s, 2 h 03 min. */
export function formatDuration(seconds: number, digits = 3): string {
  if (seconds < 100) return `${formatDigits(seconds, digits)}${kThin}s`;
  const whole = Math.round(seconds);
  const two = (value: number): string => String(value).padStart(2, '0');
  if (whole < 3600) return `${Math.floor(whole / 60)}${kThin}min\u00a0${two(whole % 60)}${kThin}s`;
  const minutes = Math.round(seconds / 60);
  return `${formatCount(Math.floor(minutes / 60))}${kThin}h\u00a0${two(minutes % 60)}${kThin}min`;
}

/** A round length of time: 5 s, 30 min, 2 h, 3 d. */
export function formatStep(seconds: number): string {
  const [name, unit_s] = ([['d', 86400], ['h', 3600], ['min', 60]] as const).find(([, size_s]) => seconds >= 2 * size_s && seconds % size_s === 0) ?? ['s', 1];
  return `${Number((seconds / unit_s).toPrecision(6))}${kThin}${name}`;
}

/** 63.2 s: a time from a zero of the recording's own. */
export function formatSeconds(seconds: number, decimals = 1): string {
  return `${plain(seconds, decimals)}${kThin}s`;
}

/** How many decimals of a second say when something was within so long a time. */
export function decimalsWithin(duration_s: number): number {
  return Math.min(2, decimalsFor(duration_s / 1e5));
}

/** How many decimals tell moments this far apart from one another. */
export function decimalsFor(step: number): number {
  return step > 0 ? Math.min(3, Math.max(0, Math.ceil(-Math.log10(step)))) : 1;
}
