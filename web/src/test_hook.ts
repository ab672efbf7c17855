// For tests in a browser: where a bee is on the screen, and how long a frame takes.
import type { Shown } from './panels/shown';

export interface TestHook {
  /** Where a bee is seen, in pixels of the page. */
  project: (swarm: number, bee: number) => { x: number; y: number } | null;
  /** Frames per second while the view turns. */
  framesPerSecond: (frames: number) => number;
  /** Waits until the graphics card has drawn. */
  settle: () => void;
}

export function offerTestHook(all: Shown[]): void {
  const hook: TestHook = {
    project: (swarm, bee) => {
      const view = all[swarm].view;
      const at = view?.project(bee);
      if (!view || !at) return null;
      const { left, top } = view.canvas.getBoundingClientRect();
      return { x: left + at.x, y: top + at.y };
    },
    framesPerSecond: (frames) => {
      const begins = performance.now();
      for (let i = 0; i < frames; ++i) {
        for (const { view } of all) {
          view?.orbit.turn(0.02, 0);
          view?.drawAndWait();
        }
      }
      return (1000 * frames) / (performance.now() - begins);
    },
    settle: () => all.forEach(({ view }) => view?.drawAndWait()),
  };
  Object.assign(window, { beespace: hook });
}
