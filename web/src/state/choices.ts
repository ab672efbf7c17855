// What the reader of the page has chosen. Panels and views change it, and follow it.
import { Signal } from './signal';
import type { Theme } from './theme';

/** What the colours of bees tell; in words of the address. */
export const kColourings = ['nearest', 'height', 'speed', 'group', 'none'] as const;
export type ColourBy = (typeof kColourings)[number];

/** A bee of one of the swarms, and with a pair the other one. */
export interface Selected {
  swarm: number;
  bee: number;
  other: number | null;
  /** The place of the pair in the list of its swarm: a pair may be in conflict more than once. */
  place: number | null;
}

export interface Filter {
  atRiskOnly: boolean;
  /** Only this conflict group of this swarm. */
  group: { swarm: number; place: number } | null;
}

export interface Choices {
  selected: Signal<Selected | null>;
  filter: Signal<Filter>;
  theme: Signal<Theme>;
  trails: Signal<boolean>;
  /** Lines that lead to where moving bees would be after a while. */
  vectors: Signal<boolean>;
  /** Whether a click measures instead of selecting. */
  measuring: Signal<boolean>;
  colourBy: Signal<ColourBy>;
  /** How many times larger than they are heights are drawn. */
  lift: Signal<number>;
}
