// Keeps the views at what the reader chose: the time, the filter, trails, the selected bees.
import type { Fleet } from '../data/fleet';
import { counterpart, type Company, type Swarm } from '../data/swarm';
import type { Choices } from '../state/choices';
import type { LinkedTimes } from '../time/linked_times';
import type { Colours } from './colouring';
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
  colours: Colours[];
}

function guidedAt(fleet: Fleet, bee: number, time_s: number): Guided | null {
  const ghost = fleet.ghost(bee, time_s);
  const told = fleet.told(bee, time_s);
  return ghost && told && { ghost, tube_m: told.tube_m, claim: fleet.claim(bee, time_s) };
}

/** Places now and whenever something changes. */
export function followPlaces(placing: Placing): void {
  const { swarms, stages, times, choices, placers, colours } = placing;
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
      swarm.kind === 'snapshot' ? placeSnapshot(swarm, company, wanted) : (placer as RecordingPlacer).at(within, company, wanted, everyOf(view), watchedIn(i));
    colours[i].follow(colours[i].of(choices.colourBy.value), placement, within);
    view.place(placement);
    if (swarm.kind === 'recording') {
      const { clock } = times;
      view.trails(swarm.fixes, within, choices.trails.value ? Math.max(5 * clock.step_s, clock.ends_s / 25) : null);
      view.vectors(swarm.fixes, within, choices.vectors.value ? view.aheadOf(swarm.fixes) : null);
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
  /** While time goes on, as many of a large crowd as this machine draws in time. */
  const everyOf = (view: View): number => {
    const every = times.clock.playing.value && choices.filter.value.group === null ? view.pace.every : 1;
    view.tellShare(every);
    return every;
  };
  const watchedIn = (i: number): number[] => {
    const selected = choices.selected.value;
    if (!selected) return [];
    return [selected.bee, selected.other].flatMap((bee) => (bee === null ? [] : (counterpart(swarms[selected.swarm], bee, swarms[i]) ?? [])));
  };
  let before_ms = 0;
  const timeFrames = (): void => {
    const now_ms = performance.now();
    if (times.clock.playing.value && before_ms > 0) for (const { view } of stages) view?.pace.took(now_ms - before_ms);
    before_ms = times.clock.playing.value ? now_ms : 0;
  };
  const placeAll = (): void => swarms.forEach((_, i) => placeOne(i));
  const placeMoving = (): void => swarms.forEach((swarm, i) => swarm.kind === 'recording' && placeOne(i));
  placeAll();
  choices.filter.listen(placeAll);
  choices.trails.listen(placeMoving);
  choices.vectors.listen(placeMoving);
  choices.colourBy.listen(() => {
    stages.forEach(({ view }, i) => view?.colourBy(colours[i].of(choices.colourBy.value)));
    placeMoving();
  });
  times.clock.time.listen(() => {
    timeFrames();
    placeMoving();
  });
  // At rest all are shown.
  times.clock.playing.listen((playing) => {
    if (!playing) placeMoving();
  });
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
