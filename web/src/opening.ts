// What a page shows when it opens, and keeps in its address: what the address says, and otherwise the worst pair.
import { pairsOf, placeOfPair, type Swarm } from './data/swarm';
import type { View } from './scene/view';
import { addressNow, copyText, keepAddress, readAddress, type Seen } from './state/address';
import type { Choices, Selected } from './state/choices';
import { showWorstMoment, type LinkedTimes } from './time/linked_times';

export interface Opening {
  swarms: Swarm[];
  views: (View | null)[];
  choices: Choices;
  times: LinkedTimes;
}

function worstPair(swarms: Swarm[]): Selected | null {
  const swarm = swarms.findIndex((one) => pairsOf(one).first.length > 0);
  if (swarm < 0) return null;
  const { first, second } = pairsOf(swarms[swarm]);
  return { swarm, bee: first[0], other: second[0], place: 0 };
}

function selectedBy(swarmAt: number, [bee, other = null]: (number | null)[], { swarms, times }: Opening): Selected | null {
  const swarm = swarms[swarmAt];
  if (!swarm || bee === null || bee === undefined || bee >= swarm.head.count || (other ?? 0) >= swarm.head.count) return null;
  const place = other === null ? -1 : placeOfPair(swarm, bee, other, times.within({ swarm }));
  return { swarm: swarmAt, bee, other: other === bee ? null : other, place: place < 0 ? null : place };
}

/** Of few it is seen at once where each came from; of many the trails would hide them. */
const kFew = 20;

function showsTrails({ swarms }: Pick<Opening, 'swarms'>): boolean {
  return swarms.every(({ kind, head }) => kind === 'recording' && head.count <= kFew);
}

/** Sets the time, the filter and the camera; returns who is to be selected once names are known. */
export function open(opening: Opening, usualLift: number): Selected | null {
  const { swarms, choices, times } = opening;
  const address = readAddress(location.hash);
  choices.lift.set(address.lift ?? usualLift);
  choices.filter.set({ atRiskOnly: address.atRiskOnly, group: address.group });
  choices.trails.set(address.trails ?? showsTrails(opening));
  choices.vectors.set(address.vectors);
  choices.colourBy.set(address.colourBy);
  if (address.time_s !== null) times.clock.go(address.time_s);
  else showWorstMoment(swarms, times);
  const told = address.bees.length > 0 || address.time_s !== null || address.camera !== null;
  return told ? selectedBy(address.swarm, address.bees, opening) : worstPair(swarms);
}

/** Once bees are placed. */
export function aim({ views }: Opening, selected: Selected | null): void {
  const { camera } = readAddress(location.hash);
  // Linked views follow.
  for (const one of views) one?.measure();
  const view = views[selected?.swarm ?? 0] ?? views[0];
  if (!view) return;
  if (camera) view.sight.camera = camera;
  else if (selected) view.flyTo([selected.bee, selected.other].filter((bee) => bee !== null), true);
  else return;
  // Views that are compared look from the same place.
  for (const other of views) if (other && other !== view) other.orbit.goTo(view.orbit.pose);
}

export interface Link {
  copy: () => Promise<boolean>;
  keep: () => void;
}

/** Views may come later. */
export function linkTo({ swarms, views, choices, times }: Opening, usualLift: number): Link {
  const moving = swarms.some(({ kind }) => kind === 'recording');
  const seen: Seen = {
    choices,
    time: moving ? times.clock.time : null,
    playing: moving ? times.clock.playing : null,
    camera: () => views[0]?.sight.camera ?? null,
    usualTrails: showsTrails({ swarms }),
    usualLift,
  };
  return {
    copy: async () => {
      const hash = addressNow(seen);
      const copied = await copyText(location.href.replace(/#.*$/, '') + hash);
      if (!copied) location.hash = hash;
      return copied;
    },
    keep: () => keepAddress(seen, (listener) => views[0]?.orbit.onChange(listener)),
  };
}
