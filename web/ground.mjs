// Coasts and borders of the Earth, simplified and packed for the page: from Natural Earth (public domain) at 1:50,000,000, as
// `world-atlas` has it.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { deflateSync } from 'node:zlib';

/** Lines stray so far from those of the atlas, in steps of a hundredth of a degree; smaller islands are left out. */
const kTolerance = 2;
const kPerDegree = 100;

/** Arcs of TopoJSON in whole steps: [longitude, latitude]. */
function arcsOf({ arcs, transform: { scale, translate } }) {
  return arcs.map((arc) => {
    let [x, y] = [0, 0];
    return arc.map(([dx, dy]) => {
      [x, y] = [x + dx, y + dy];
      return [(x * scale[0] + translate[0]) * kPerDegree, (y * scale[1] + translate[1]) * kPerDegree];
    });
  });
}

/** In how many outlines of countries each arc is: one that is in two is a border. */
function usesOf({ arcs, objects }) {
  const uses = new Array(arcs.length).fill(0);
  const walk = (part) => (Array.isArray(part) ? part.forEach(walk) : uses[part < 0 ? ~part : part]++);
  for (const { arcs: outlines = [] } of objects.countries.geometries) walk(outlines);
  return uses;
}

/** Douglas and Peucker; degrees of longitude are as long as they are at that latitude. */
function simplified(line) {
  const keep = new Uint8Array(line.length);
  keep[0] = keep[line.length - 1] = 1;
  const parts = [[0, line.length - 1]];
  while (parts.length > 0) {
    const [from, to] = parts.pop();
    const [[ax, ay], [bx, by]] = [line[from], line[to]];
    const narrow = Math.max(0.05, Math.cos((((ay + by) / 2 / kPerDegree) * Math.PI) / 180));
    let [farthest, place] = [kTolerance, -1];
    for (let i = from + 1; i < to; ++i) {
      const [dx, dy, px, py] = [(bx - ax) * narrow, by - ay, (line[i][0] - ax) * narrow, line[i][1] - ay];
      const length = dx * dx + dy * dy;
      const along = length > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / length)) : 0;
      const off = Math.hypot(px - along * dx, py - along * dy);
      if (off > farthest) [farthest, place] = [off, i];
    }
    if (place < 0) continue;
    keep[place] = 1;
    parts.push([from, place], [place, to]);
  }
  return line.filter((_, i) => keep[i]).map(([x, y]) => [Math.round(x), Math.round(y)]);
}

function put(bytes, number) {
  let rest = number >= 0 ? 2 * number : -2 * number - 1;
  while (rest > 127) {
    bytes.push((rest & 127) | 128);
    rest >>= 7;
  }
  bytes.push(rest);
}

/**
 * A zlib stream in base64 of whole numbers, each in groups of seven bits, the lowest first, and 2n or −2n − 1 (zigzag): for each
 * line 2 × (its points) + (1 for a border), and its points as differences of hundredths of a degree of longitude and latitude, the
 * first one from the last point of the line before.
 */
export async function packedGround() {
  const atlas = JSON.parse(await readFile(createRequire(import.meta.url).resolve('world-atlas/countries-50m.json'), 'utf8'));
  const uses = usesOf(atlas);
  const bytes = [];
  let [x, y] = [0, 0];
  let [lines, points] = [0, 0];
  arcsOf(atlas).forEach((arc, i) => {
    const line = simplified(arc);
    const [low, high] = [0, 1].map((axis) => line.map((point) => point[axis])).map((list) => [Math.min(...list), Math.max(...list)]);
    const closed = line[0][0] === line.at(-1)[0] && line[0][1] === line.at(-1)[1];
    if (uses[i] === 0 || (closed && low[1] - low[0] < 2 * kTolerance && high[1] - high[0] < 2 * kTolerance) || line.length < 2) return;
    // The edge of the map is no coast.
    if (line.every(([longitude]) => Math.abs(longitude) > 179.99 * kPerDegree)) return;
    put(bytes, 2 * line.length + (uses[i] > 1 ? 1 : 0));
    for (const [px, py] of line) {
      put(bytes, px - x);
      put(bytes, py - y);
      [x, y] = [px, py];
    }
    lines += 1;
    points += line.length;
  });
  return { base64: deflateSync(Buffer.from(bytes), { level: 9 }).toString('base64'), lines, points };
}
