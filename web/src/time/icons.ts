// Signs of the time line, drawn, as fonts do not all have them.
import { drawing } from '../text/element';

const kPaths = {
  play: 'M4.5 2.5v11l9-5.5z',
  pause: 'M4 2.5h3v11H4zM9 2.5h3v11H9z',
  back: 'M10.5 3v10L4 8z',
  on: 'M5.5 3v10L12 8z',
  conflictBefore: 'M3 3h1.8v10H3zM13 3v10L6 8z',
  nextConflict: 'M11.2 3H13v10h-1.8zM3 3v10l7-5z',
} as const;

export type Icon = keyof typeof kPaths;

export function icon(name: Icon): SVGElement {
  return drawing('svg', { viewBox: '0 0 16 16', class: 'icon', 'aria-hidden': 'true' }, drawing('path', { d: kPaths[name] }));
}
