// Colours of the scene. The ramp is viridis, which colour-blind people can read, cut where it would
// vanish against the ground; bees at risk differ by shape, size and lightness too.
import type { Theme } from '../state/theme';

export type Rgb = [number, number, number];

export interface Palette {
  ground: string;
  /** From near to far. */
  ramp: string[];
  /** Where no distance is known. */
  plain: string;
  /** Of groups, in turn: as different as seven can be, for colour-blind people too. */
  groups: string[];
  risk: string;
  riskEdge: string;
  line: string;
  focus: string;
  /** Of what a planner says: where the selected bee shall be; and who keeps its contract no longer. */
  ghost: string;
  out: string;
  grid: string;
  box: string;
  /** Land, seen from far above: coasts and borders. */
  coast: string;
  /** What stands in the way. */
  obstacle: string;
}

export const kRampSteps = 8;

export const kPalettes: Record<Theme, Palette> = {
  dark: {
    ground: '#0d1216',
    ramp: ['#f4e52b', '#b5de2b', '#6ece58', '#35b779', '#1f9e89', '#26828e', '#31688e', '#3e5290'],
    plain: '#5fb0c9',
    groups: ['#e69f00', '#56b4e9', '#009e73', '#f0e442', '#4d7fd6', '#d55e00', '#cc79a7'],
    risk: '#ff5348',
    riskEdge: '#2a0503',
    line: '#ff8f80',
    focus: '#ffffff',
    ghost: '#d9a6ff',
    out: '#ffb52e',
    grid: '#26313a',
    box: '#3a4853',
    coast: '#56707f',
    obstacle: '#c9a26b',
  },
  light: {
    ground: '#f4f6f8',
    ramp: ['#2b0b4f', '#45217a', '#424086', '#33608d', '#287d8e', '#209b88', '#3fae72', '#7cc15a'],
    plain: '#2f7f9b',
    groups: ['#b87700', '#2b8fca', '#00795a', '#8d8400', '#2c4fa3', '#b54a00', '#a5487d'],
    risk: '#c8102e',
    riskEdge: '#ffffff',
    line: '#c8102e',
    focus: '#111820',
    ghost: '#7a1fc0',
    out: '#a85b00',
    grid: '#dce2e7',
    box: '#b4bfc8',
    coast: '#8296a5',
    obstacle: '#8a5a1c',
  },
};

export function rgb(colour: string): Rgb {
  const number = parseInt(colour.slice(1), 16);
  return [(number >> 16) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
}
