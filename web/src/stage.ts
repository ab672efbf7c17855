// The place of one swarm on the page: its view, below what its colours mean, or a word on why there is none.
import type { Swarm } from './data/swarm';
import type { Frame } from './scene/frame';
import { kPalettes } from './scene/palette';
import type { Painter } from './scene/painter';
import { View } from './scene/view';
import type { Colours } from './scene/colouring';
import { legend } from './panels/legend';
import type { Choices } from './state/choices';
import { lengthUnits } from './text/apart';
import { element } from './text/element';
import { nameElement } from './text/names';
import { nounOf } from './text/noun';

export interface Stage {
  box: HTMLElement;
  view: View | null;
}

export function makeStage(
  swarm: Swarm,
  label: string,
  frame: Frame,
  colours: Colours,
  choices: Choices,
  renderer: Painter | null,
): Stage {
  const { head } = swarm;
  const box = element('section', { class: 'stage', 'aria-label': label ? `Swarm, ${label.toLowerCase()}` : 'Swarm' });
  const title = label ? element('p', { class: 'stage-title' }, element('strong', {}, label), ' ', nameElement(head.title)) : null;
  const words =
    swarm.kind === 'snapshot'
      ? { risk: 'at risk', line: 'too close to each other', fleet: false, noun: nounOf(head) }
      : { risk: 'in conflict now', line: 'in conflict with each other', fleet: swarm.fleet !== null, noun: nounOf(head) };
  const scene = element('div', { class: 'scene' });
  const subject = {
    several: nounOf(head).several,
    label: label ? `The swarm ${label.toLowerCase()}` : 'The swarm',
    count: head.count,
    axes: frame.flat ? head.axes.slice(0, 2) : head.axes,
    units: lengthUnits(head),
    threshold_m: head.threshold_m,
    vertical_m: head.vertical_m ?? null,
    obstacles: head.obstacles ?? [],
  };
  const view = renderer && new View(scene, frame, subject, renderer);
  if (!view) {
    // The panels do without.
    box.append(
      element(
        'p',
        { class: 'message' },
        'This browser cannot draw in three dimensions: WebGL is missing or switched off. All numbers and tables are here nevertheless.',
      ),
    );
    return { box, view };
  }
  box.append(element('div', { class: 'stage-head' }, title, legend(colours, words, choices)), scene);
  const seen = view;
  choices.theme.watch((theme) => seen.colour(kPalettes[theme]));
  seen.colourBy(colours.of(choices.colourBy.value));
  choices.lift.listen((times) => seen.lift(times));
  return { box, view };
}

/** A click, as against a drag, picks. */
export function onPick(view: View, pick: (bee: number | null, x: number, y: number) => void): void {
  let from: { x: number; y: number } | null = null;
  view.canvas.addEventListener('pointerdown', (event) => {
    from = event.isPrimary && event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
  });
  view.canvas.addEventListener('pointerup', (event) => {
    if (!from || Math.hypot(event.clientX - from.x, event.clientY - from.y) > 5) return;
    const { left, top } = view.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - left, event.clientY - top];
    pick(view.pick(x, y), x, y);
  });
}

/** Views that look from the same place. */
export function linkViews(views: View[]): void {
  let following = false;
  for (const view of views) {
    view.orbit.onChange(() => {
      if (following) return;
      following = true;
      for (const other of views) if (other !== view) other.orbit.follow(view.orbit.pose);
      following = false;
    });
  }
}
