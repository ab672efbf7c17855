// Reads what the page holds, shows the swarms as soon as they can be seen, then the panels.
import { headsOf, readPage, type Page } from './data/page';
import { readGround } from './data/ground';
import { boxWith } from './data/obstacles';
import { boxOfBoth } from './data/positions';
import { completeSwarm, readSwarm, type Company, type Swarm } from './data/swarm';
import { fail, layout, progress } from './layout';
import { aim, linkTo, open, type Opening } from './opening';
import { helpDialog } from './panels/help';
import type { Shown } from './panels/shown';
import { preparePrinting } from './printing';
import { frameAround, liftFor, type Frame } from './scene/frame';
import { Colours } from './scene/colouring';
import { earlyRenderer } from './scene/early';
import type { Painter } from './scene/painter';
import { linkViews, makeStage } from './stage';
import { followPlaces, type Placing } from './scene/following';
import { RecordingPlacer } from './scene/placement';
import type { Choices, ColourBy, Filter, Selected } from './state/choices';
import { Signal } from './state/signal';
import { followTheme } from './state/theme';
import { counted, nounOf, nounOfAll } from './text/noun';
import { linkTimes } from './time/linked_times';
import { offerTestHook } from './test_hook';
import { wirePanels } from './wiring';

/** Of more bees it is said what the page is at; with fewer, saying it would take longer than doing it. */
const kMany = 250000;

/** Two swarms that are compared have the same axes with the same zero. */
function frameOf([one, other = one]: Swarm[]): Frame {
  const both = boxOfBoth(one.box, other.box);
  const box = boxWith(both, one.head.obstacles ?? [], one.head.threshold_m);
  const frame = frameAround(box, Math.max(one.head.threshold_m, other.head.threshold_m));
  frame.flat = [one, other].every(({ head }) => head.flat);
  frame.up = [one, other].every(({ head }) => head.y_down) ? -1 : 1;
  // Metres of no place on the Earth are drawn as they are, unless the reader wants it otherwise.
  if (one.head.origin && !frame.flat) frame.lift = liftFor(box, one.head.threshold_m, one.head.vertical_m);
  return frame;
}

async function show(page: Page, renderers: (Painter | null)[]): Promise<void> {
  const choices: Choices = {
    selected: new Signal<Selected | null>(null),
    filter: new Signal<Filter>({ atRiskOnly: false, group: null }),
    theme: followTheme(),
    trails: new Signal<boolean>(false),
    vectors: new Signal<boolean>(false),
    measuring: new Signal<boolean>(false),
    colourBy: new Signal<ColourBy>('nearest'),
    lift: new Signal<number>(1),
  };

  const swarms: Swarm[] = [];
  for (const head of page.swarms) {
    if (head.count > kMany) await progress(`Reading ${counted(head.count, nounOf(head))} …`);
    swarms.push(await undamaged(() => readSwarm(head)));
  }
  if (swarms.some(({ head }) => head.count > kMany)) await progress('Drawing …');

  const moving = swarms.some(({ kind }) => kind === 'recording');
  const fleet = swarms.some((swarm) => swarm.kind === 'recording' && swarm.fleet !== null);
  const help = helpDialog({ moving, fleet, flat: swarms.every(({ head }) => head.flat), noun: nounOfAll(swarms.map((swarm) => ({ swarm }))) });
  const frame = frameOf(swarms);
  const times = linkTimes(swarms);
  const opening: Opening = { swarms, views: [], choices, times };
  const link = linkTo(opening, frame.lift);
  const room = layout(page, choices, () => help.showModal(), () => link.copy());
  document.body.append(help);
  const labels = swarms.length === 2 ? ['Before', 'After'] : [''];
  const placers = swarms.map((swarm) => (swarm.kind === 'recording' ? new RecordingPlacer(swarm) : null));
  const colours = swarms.map((swarm, i) => new Colours(swarm, placers[i]?.crowding ?? null));
  const stages = swarms.map((swarm, i) => makeStage(swarm, labels[i], frame, colours[i], choices, renderers[i]));
  room.stages.append(...stages.map(({ box }) => box));

  opening.views.push(...stages.map(({ view }) => view));
  const selected = open(opening, frame.lift);
  const placing: Placing = { swarms, stages, companies: null, times, choices, placers, colours };
  followPlaces(placing);
  aim(opening, selected);
  for (const { view } of stages) view?.drawAndWait();
  performance.mark('beespace: first frame');
  tell('drawn');
  await progress('Reading names …');

  const companies: Company[] = [];
  for (const swarm of swarms) companies.push(await undamaged(() => completeSwarm(swarm)));
  const { origin } = swarms[0].head;
  if (page.ground && origin) {
    const ground = await undamaged(() => readGround(origin, frame.box));
    for (const { view } of stages) view?.ground.show(ground);
  }
  placing.companies = companies;
  companies.forEach((company, i) => (colours[i].company = company));
  if (choices.colourBy.value === 'group') {
    choices.colourBy.set('none');
    choices.colourBy.set('group');
  }
  choices.selected.set(selected);
  const shown: Shown[] = swarms.map((swarm, index) => ({
    index,
    swarm,
    company: companies[index],
    view: stages[index].view,
    label: labels[index],
  }));
  const views = stages.flatMap(({ view }) => view ?? []);
  linkViews(views);
  const notes = times.note === null ? [] : [times.note];
  if (page.ground) notes.push('Coasts and borders on the floor: Natural Earth (public domain), simplified, to within about 3 km.');
  wirePanels({ shown, choices, times, room, help, version: page.beespace, notes });
  preparePrinting(views, choices.theme);
  offerTestHook(shown);
  link.keep();
  addEventListener('hashchange', () => {
    const named = open(opening, frame.lift);
    choices.selected.set(named);
    aim(opening, named);
  });
  await progress(null);
  tell('ready');
}

/** How far the page is; one that its guard has called damaged stays so. */
function tell(state: 'drawn' | 'ready'): void {
  const { dataset } = document.documentElement;
  if (dataset.beespace !== 'failed') dataset.beespace = state;
}

/** What cannot be read was changed on its way. */
async function undamaged<T>(read: () => T | Promise<T>): Promise<T> {
  try {
    return await read();
  } catch (error) {
    throw new DamagedPage(error instanceof Error ? error.message : String(error));
  }
}

class DamagedPage extends Error {}

/**
 * The program is there before the data are. The guard has spoken once the document's parts are there: the document is
 * "interactive" a little before that.
 */
function whole(): Promise<void> {
  const [navigation] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
  if (document.readyState === 'complete' || (navigation?.domContentLoadedEventEnd ?? 0) > 0) return Promise.resolve();
  return new Promise((resolve) => {
    addEventListener('DOMContentLoaded', () => resolve());
    addEventListener('load', () => resolve());
  });
}

async function start(): Promise<void> {
  // The graphics card begins while the browser still reads the columns.
  const early = await headsOf();
  const made = early?.map((head) => earlyRenderer(head));
  await whole();
  if (document.documentElement.dataset.beespace === 'failed') return;
  const page = await undamaged(readPage);
  if (!page) {
    followTheme();
    fail('This page holds no swarm yet. The command `beespace report` puts one in.');
    return;
  }
  document.title = `${page.swarms.map(({ title }) => title.slice(0, 80)).join(' → ')} – beespace`;
  await show(page, made ?? page.swarms.map((head) => earlyRenderer(head)));
}

document.documentElement.dataset.program = 'runs';
start().catch((error: unknown) => {
  document.documentElement.dataset.beespace = 'failed';
  const why = error instanceof Error ? error.message : String(error);
  fail(
    error instanceof DamagedPage
      ? `This page is damaged: ${why}. Copy it again, or make it anew with \`beespace report\`.`
      : `This page cannot be shown: ${why}.`,
  );
  throw error;
});
