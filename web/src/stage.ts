// The place of one swarm on the page: its view, below what its colours mean, or a word on why there is none.
import type { WebGLRenderer } from 'three';
import type { Swarm } from './data/swarm';
import type { Frame } from './scene/frame';
import { kPalettes } from './scene/palette';
import { View } from './scene/view';
import { quantileCode, type Nearest } from './data/nearest';
import { Crowding } from './scene/crowding';
import { legend } from './panels/legend';
import type { Choices } from './state/choices';
import { element } from './text/element';
import { nameElement } from './text/names';

export interface Stage {
  box: HTMLElement;
  view: View | null;
}

interface Colours {
  nearest: Nearest | null;
  /** Codes between which colours change. */
  range: [number, number];
  title: string;
}

function coloursOf(swarm: Swarm, crowding: Crowding | null): Colours {
  if (crowding) return { nearest: crowding.nearest, range: Crowding.range(crowding.nearest), title: 'Nearest bee, as shown' };
  if (swarm.kind !== 'snapshot' || !swarm.nearest) return { nearest: null, range: [0, 1], title: '' };
  // Where most bees are.
  const counts = swarm.nearest.countCodes();
  const near = quantileCode(counts, 0.02);
  const range: [number, number] = [near, Math.max(near + 1, quantileCode(counts, 0.98))];
  return { nearest: swarm.nearest, range, title: 'Nearest bee' };
}

export function makeStage(
  swarm: Swarm,
  label: string,
  frame: Frame,
  crowding: Crowding | null,
  choices: Choices,
  renderer: WebGLRenderer | null,
): Stage {
  const { head } = swarm;
  const box = element('section', { class: 'stage', 'aria-label': label ? `Swarm, ${label.toLowerCase()}` : 'Swarm' });
  const { nearest, range, title: colours } = coloursOf(swarm, crowding);
  const title = label ? element('p', { class: 'stage-title' }, element('strong', {}, label), ' ', nameElement(head.title)) : null;
  const words =
    swarm.kind === 'snapshot'
      ? { risk: 'at risk', line: 'too close to each other', colours, fleet: false }
      : { risk: 'in conflict now', line: 'in conflict with each other', colours, fleet: swarm.fleet !== null };
  const scene = element('div', { class: 'scene' });
  const subject = {
    label: label ? `The swarm ${label.toLowerCase()}` : 'The swarm',
    count: head.count,
    axes: head.axes,
    inFeet: head.heights?.in_feet ?? false,
    threshold_m: head.threshold_m,
    vertical_m: head.vertical_m ?? null,
    nearest,
    range,
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
  box.append(element('div', { class: 'stage-head' }, title, legend(nearest, range, words, choices.theme)), scene);
  const seen = view;
  choices.theme.watch((theme) => seen.colour(kPalettes[theme]));
  choices.lift.listen((times) => seen.lift(times));
  return { box, view };
}

/** A click, as against a drag, picks. */
export function onPick(view: View, pick: (bee: number | null) => void): void {
  let from: { x: number; y: number } | null = null;
  view.canvas.addEventListener('pointerdown', (event) => {
    from = event.isPrimary && event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
  });
  view.canvas.addEventListener('pointerup', (event) => {
    if (!from || Math.hypot(event.clientX - from.x, event.clientY - from.y) > 5) return;
    const { left, top } = view.canvas.getBoundingClientRect();
    pick(view.pick(event.clientX - left, event.clientY - top));
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
