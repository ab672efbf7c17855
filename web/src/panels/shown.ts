// A swarm as the page shows it: what was read, what was found in it, and its view, if there is one.
import type { Company, Swarm } from '../data/swarm';
import type { View } from '../scene/view';
import type { Selected } from '../state/choices';

export interface Shown {
  index: number;
  swarm: Swarm;
  company: Company;
  view: View | null;
  /** Before or After; empty for a swarm alone. */
  label: string;
}

/** What panels ask the page to do. */
export interface Actions {
  /** Selects; with `fly` also goes there, and with `time_s` to this moment of the recording first. */
  select: (selected: Selected | null, options?: { fly?: boolean; time_s?: number }) => void;
}
