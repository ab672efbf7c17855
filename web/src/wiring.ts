// Puts the panels into the page and makes keys, clicks and buttons work.
import { pairsOf } from './data/swarm';
import { listenToKeys } from './keys';
import { toggleTheme, type Layout } from './layout';
import { contractPanel } from './panels/contracts';
import { filterControls } from './panels/filter';
import { histogramPanel } from './panels/histogram';
import { liftControl } from './panels/lift';
import { limitsPanel } from './panels/limits';
import { measuringOn } from './panels/measuring';
import { notesPanel } from './panels/notes';
import { pairPanelOf } from './panels/pair';
import { pairPanel } from './panels/pair_table';
import { searchBox } from './panels/search';
import { selectionPanel, type Now } from './panels/selection';
import type { Actions, Shown } from './panels/shown';
import { summaryPanel } from './panels/summary';
import { fileName, pictureOf, saveFile } from './save';
import { nameUnderCursor } from './scene/hover';
import { onPick } from './stage';
import type { Choices, ColourBy } from './state/choices';
import { button, element } from './text/element';
import { formatHeight } from './text/heights';
import { nounOfAll } from './text/noun';
import type { LinkedTimes } from './time/linked_times';
import { timeline, type Timeline } from './time/timeline';

export interface Parts {
  shown: Shown[];
  choices: Choices;
  times: LinkedTimes;
  room: Layout;
  help: HTMLDialogElement;
  version: string;
  notes: string[];
}

export function wirePanels({ shown, choices, times, room, help, version, notes }: Parts): void {
  const actions: Actions = {
    select: (selected, { fly, time_s } = {}) => {
      if (selected && time_s !== undefined) times.seek(shown[selected.swarm], time_s);
      choices.selected.set(selected);
      if (!selected || !fly) return;
      const bees = selected.other === null ? [selected.bee] : [selected.bee, selected.other];
      const { view } = shown[selected.swarm];
      view?.flyTo(bees);
      // On a phone the swarm may be out of sight; nowhere else does anything scroll.
      if (matchMedia('(max-width: 760px)').matches) view?.canvas.scrollIntoView({ block: 'nearest' });
    },
  };
  const now: Now = { time_s: times.clock.time, within: times.within, seek: times.seek };
  for (const { view, index } of shown) {
    if (view) nameUnderCursor(view, (bee) => hoverText(shown[index], bee, now.within(shown[index])));
    if (!view) continue;
    const measuring = measuringOn({ ...shown[index], view }, choices);
    onPick(view, (bee, x, y) => {
      if (choices.measuring.value) measuring.take(bee, x, y);
      else actions.select(bee === null ? null : { swarm: index, bee, other: null, place: null });
    });
  }

  const moving = shown.some(({ swarm }) => swarm.kind === 'recording');
  const line = moving ? timeline(shown, times, choices) : null;
  if (line) room.column.append(line.box);
  const histogram = histogramPanel(shown);
  const contracts = contractPanel(shown, actions);
  const limits = limitsPanel(shown, actions, times.seek);
  room.panels.append(
    summaryPanel(shown, actions),
    pairPanelOf(shown, choices, times),
    ...(limits ? [limits] : []),
    selectionPanel(shown, choices, now, actions),
    ...(contracts ? [contracts] : []),
    pairPanel(shown, choices, actions),
    ...(histogram ? [histogram] : []),
    notesPanel(shown, version, notes),
  );
  room.toolbar.append(searchBox(shown, choices, actions), filterControls(shown, choices), viewButtons(shown, choices));
  wireKeys(shown, choices, times, line, actions, help);
  choices.filter.listen(({ group }) => {
    if (!group) return;
    const { view, company } = shown[group.swarm];
    view?.flyTo(Array.from(company.groups.list[group.place]?.bees ?? []));
  });
}

/** What is said of the bee under the cursor: whether it is at risk, and how high it is. */
function hoverText({ swarm, view }: Shown, bee: number, within_s: number): { name: string; more: string } {
  const place = swarm.kind === 'recording' ? swarm.spans.bees.indexOf(bee) : -1;
  const risky = swarm.kind === 'snapshot' ? swarm.isAtRisk(bee) : place >= 0 && swarm.spans.covers(place, within_s);
  const state = risky ? (swarm.kind === 'snapshot' ? 'at risk' : 'in conflict') : '';
  const height_m = swarm.head.origin && !swarm.head.flat ? view?.placeOf(bee)?.[2] : undefined;
  const height = height_m === undefined ? '' : formatHeight(height_m, swarm.head.position_error_m, swarm.head.heights);
  return { name: swarm.names.of(bee), more: [state, height].filter((text) => text !== '').join(', ') };
}

function viewButtons(shown: Shown[], choices: Choices): HTMLElement {
  // Linked views follow the first one.
  const orbit = shown[0].view?.orbit;
  const box = element('div', { class: 'view-buttons', role: 'group', 'aria-label': 'View' });
  if (!orbit) return box;
  const reset = button('Reset view', { title: 'All of the swarm again (r)' }, () => orbit.home());
  const inSpace = [
    button('Top', { title: 'From the top (t)' }, () => orbit.lookFromAbove()),
    button('Side', { title: 'From the side (s)' }, () => orbit.lookFromSide()),
  ];
  const { flat } = orbit.frame;
  box.append(
    ...(flat ? [] : [liftControl(choices)]),
    reset,
    ...(flat ? [] : inSpace),
    measureButton(shown, choices),
    button('PNG', { title: 'Save what is seen as a picture', 'aria-label': 'PNG: save as a picture' }, () => void savePictures(shown)),
  );
  return box;
}

function measureButton(shown: Shown[], choices: Choices): HTMLButtonElement {
  const made = button('Measure', { title: `How far apart two ${nounOfAll(shown).several} or places are (m)` }, () => choices.measuring.set(!choices.measuring.value));
  choices.measuring.watch((on) => made.setAttribute('aria-pressed', String(on)));
  return made;
}

async function savePictures(shown: Shown[]): Promise<void> {
  for (const { view, swarm } of shown) if (view) saveFile(fileName(swarm.head.title, 'png'), await pictureOf(view));
}

function wireKeys(
  shown: Shown[],
  choices: Choices,
  times: LinkedTimes,
  line: Timeline | null,
  actions: Actions,
  help: HTMLDialogElement,
): void {
  const orbit = shown[0].view?.orbit;
  const { clock } = times;
  const showPair = (swarm: number, place: number): void => {
    const one = shown[swarm].swarm;
    const { first, second } = pairsOf(one);
    if (place < 0 || place >= first.length) return;
    const time = one.kind === 'recording' ? { time_s: one.conflicts.closest_s[place] } : {};
    actions.select({ swarm, bee: first[place], other: second[place], place }, { fly: true, ...time });
  };
  const setFilter = (change: Partial<typeof choices.filter.value>): void =>
    choices.filter.set({ ...choices.filter.value, ...change });

  listenToKeys({
    search: () => document.getElementById('search')?.focus(),
    pair: (place) => showPair(choices.selected.value?.swarm ?? 0, place),
    nextPair: (direction) => showPair(choices.selected.value?.swarm ?? 0, (choices.selected.value?.place ?? -1) + direction),
    turn: (aside, up) => orbit?.turn(aside, up),
    shift: (right, up) => orbit?.shift(right, up),
    zoom: (factor) => orbit?.zoom(factor),
    home: () => orbit?.home(),
    fromAbove: () => orbit?.lookFromAbove(),
    fromSide: () => orbit?.lookFromSide(),
    flyToSelected: () => actions.select(choices.selected.value, { fly: true }),
    toggleAtRiskOnly: () => setFilter({ atRiskOnly: !choices.filter.value.atRiskOnly }),
    toggleGroup: () => {
      const selected = choices.selected.value;
      const place = selected ? shown[selected.swarm].company.groups.of[selected.bee] : -1;
      const group = selected && place >= 0 && !choices.filter.value.group ? { swarm: selected.swarm, place } : null;
      setFilter({ group });
    },
    toggleTheme: () => toggleTheme(choices),
    measure: () => choices.measuring.set(!choices.measuring.value),
    nextColours: () => {
      const select = document.querySelector<HTMLSelectElement>('.legend select');
      if (!select) return;
      const { options } = select;
      choices.colourBy.set(options[(select.selectedIndex + 1) % options.length].value as ColourBy);
    },
    clear: () => {
      if (choices.measuring.value) return choices.measuring.set(false);
      actions.select(null);
      setFilter({ group: null });
    },
    help: () => help.showModal(),
    time: line && {
      toggle: () => clock.toggle(),
      step: (steps) => clock.step(steps),
      conflict: (direction) => line.goToConflict(direction),
      speed: (places) => clock.changeSpeed(places),
      begin: () => clock.go(clock.begins_s),
      end: () => clock.go(clock.ends_s),
      trails: () => choices.trails.set(!choices.trails.value),
      vectors: () => choices.vectors.set(!choices.vectors.value),
    },
  });
}
