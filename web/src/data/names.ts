// What bees are called. A name is the text of a stranger: it is shown, never interpreted.
import { readCounts, readMeasures, readTexts } from './column';
import type { Head } from './page';

/** Columns of one length, in ascending order of bee and time. */
export interface Called {
  bees: Uint32Array;
  since_s: Float64Array;
  texts: readonly string[];
}

export class Names {
  readonly #texts: readonly string[] | null;
  readonly #places: Map<number, number> | null;
  #bees: Map<string, number> | null = null;

  /** By bee, of those that have several names one after the other: since when it is called each. */
  readonly #called = new Map<number, { since_s: number; text: string }[]>();

  /** Without `texts` a bee's id is its number; with `bees`, only these have a text. */
  constructor(texts: readonly string[] | null, bees: Uint32Array | null, called: Called | null = null) {
    this.#texts = texts;
    called?.bees.forEach((bee, place) => {
      const all = this.#called.get(bee) ?? [];
      all.push({ since_s: called.since_s[place], text: called.texts[place] });
      this.#called.set(bee, all);
    });
    this.#places = bees ? new Map(Array.from(bees, (bee, place) => [bee, place])) : null;
  }

  get areNumbers(): boolean {
    return this.#texts === null;
  }

  of(bee: number): string {
    if (!this.#texts) return String(bee);
    const place = this.#places ? this.#places.get(bee) : bee;
    return place === undefined ? String(bee) : (this.#texts[place] ?? String(bee));
  }

  /** What it is called at that time of the recording, as an aircraft is after its flight. */
  at(time_s: number, bee: number): string {
    const all = this.#called.get(bee);
    if (!all) return this.of(bee);
    return (all.filter(({ since_s }) => since_s <= time_s).at(-1) ?? all[0]).text;
  }

  /** Bees whose name is the text, then those whose name holds it; `limit` at most. */
  find(text: string, count: number, limit: number): number[] {
    const wanted = text.trim().toLowerCase();
    if (wanted === '') return [];
    const exact: number[] = [];
    const holding: number[] = [];
    const offer = (bee: number, name: string): boolean => {
      const lower = name.toLowerCase();
      if (lower === wanted) exact.push(bee);
      else if (holding.length < limit && lower.includes(wanted)) holding.push(bee);
      return exact.length < limit;
    };
    if (this.#texts && this.#places) {
      for (const [bee, place] of this.#places) if (!offer(bee, this.#texts[place])) break;
      const number = Number(wanted);
      if (Number.isInteger(number) && number >= 0 && number < count && !this.#places.has(number)) exact.push(number);
    } else if (this.#texts) {
      for (let bee = 0; bee < this.#texts.length; ++bee) if (!offer(bee, this.#texts[bee])) break;
    } else {
      findNumbers(wanted, count, limit, exact, holding);
    }
    return [...exact, ...holding].slice(0, limit);
  }

  /** The bee of exactly this name; of several the first. */
  bee(name: string, count: number): number | null {
    if (!this.#texts) {
      const bee = Number(name);
      return Number.isInteger(bee) && bee >= 0 && bee < count && String(bee) === name ? bee : null;
    }
    if (!this.#bees) {
      this.#bees = new Map();
      for (let bee = count - 1; bee >= 0; --bee) this.#bees.set(this.of(bee), bee);
    }
    return this.#bees.get(name) ?? null;
  }
}

// Numbers that begin with the digits asked for: 12 → 12, 120 … 129, 1200 …
function findNumbers(digits: string, count: number, limit: number, exact: number[], more: number[]): void {
  if (!/^\d{1,15}$/.test(digits)) return;
  const number = Number(digits);
  if (number < count) exact.push(number);
  if (number === 0) return;
  for (let ten = 10; number * ten < count && more.length < limit; ten *= 10) {
    const end = Math.min(number * ten + ten, count);
    for (let bee = number * ten; bee < end && more.length < limit; ++bee) more.push(bee);
  }
}

export async function readNames(head: Head): Promise<Names> {
  if (!head.names) return new Names(null, null);
  const { texts, bees, called } = head.names;
  const several = called && {
    bees: await readCounts(called.bees),
    since_s: await readMeasures(called.since_s),
    texts: await readTexts(called.texts),
  };
  return new Names(await readTexts(texts), bees ? await readCounts(bees) : null, several);
}
