// Keeps the views at what the reader chose: the time, the filter, trails, the selected bees.
import type { Fleet } from '../data/fleet';
import { counterpart, type Company, type Swarm } from '../data/swarm';
import type { Choices } from '../state/choices';
import type { LinkedTimes } from '../time/linked_times';
import type { Guided } from './guidance';
import { placeSnapshot, type Placement, type RecordingPlacer, type Wanted } from './placement';
import type { View } from './view';

export interface Placing {
  swarms: Swarm[];
  stages: { view: View | null }[];
  /** Not there until the first frame is. */
  companies: Company[] | null;
  times: LinkedTimes;
  choices: Choices;
  /** Of the recordings among the swarms. */
  placers: (RecordingPlacer | null)[];
}

function guidedAt(fleet: Fleet, bee: number, time_s: number): Guided | null {
  const ghost = fleet.ghost(bee, time_s);
  const told = fleet.told(bee, time_s);
  return ghost && told && { ghost, tube_m: told.tube_m, claim: fleet.claim(bee, time_s) };
}

/** Places now and whenever something changes. */
export function followPlaces(placing: Placing): void {
  const { swarms, stages, times, choices, placers } = placing;
  const placeOne = (i: number): void => {
    const { view } = stages[i];
    if (!view) return;
    const swarm = swarms[i];
    const { atRiskOnly, group } = choices.filter.value;
    const wanted: Wanted = { atRiskOnly, group: group && group.swarm === i ? group.place : null };
    const company = placing.companies?.[i] ?? null;
    const within = times.within({ swarm });
    const placer = placers[i];
    const placement: Placement =
      swarm.kind === 'snapshot' ? placeSnapshot(swarm, company, wanted) : (placer as RecordingPlacer).at(within, company, wanted);
    view.place(placement);
    if (swarm.kind === 'recording') {
      const { clock } = times;
      if (choices.trails.value) view.trail(swarm.fixes, within, Math.max(5 * clock.step_s, clock.ends_s / 25));
      else view.hideTrails();
      guideOne(i);
    }
  };
  /** What the planner of the fleet says of the selected bee, and who is out of its contract. */
  const guideOne = (i: number): void => {
    const swarm = swarms[i];
    const { view } = stages[i];
    if (!view || swarm.kind !== 'recording' || !swarm.fleet) return;
    const { fleet } = swarm;
    const within = times.within({ swarm });
    const selected = choices.selected.value;
    const bee = selected && counterpart(swarms[selected.swarm], selected.bee, swarm);
    view.guide(bee === null ? null : guidedAt(fleet, bee, within));
    view.castOut(fleet.outcasts.flatMap((one) => (fleet.contractAt(one.bee, within) === 'out' ? [one.bee] : [])));
  };
  const placeAll = (): void => swarms.forEach((_, i) => placeOne(i));
  const placeMoving = (): void => swarms.forEach((swarm, i) => swarm.kind === 'recording' && placeOne(i));
  placeAll();
  choices.filter.listen(placeAll);
  choices.trails.listen(placeMoving);
  times.clock.time.listen(placeMoving);
  choices.selected.listen((selected) => {
    stages.forEach(({ view }, i) => {
      if (!view) return;
      guideOne(i);
      if (!selected) {
        view.mark([], []);
        return;
      }
      const home = swarms[selected.swarm];
      const bees = [selected.bee, selected.other]
        .flatMap((bee) => (bee === null ? [] : (counterpart(home, bee, swarms[i]) ?? [])));
      view.mark(bees, bees.map((bee) => swarms[i].names.of(bee)));
    });
  });
}
