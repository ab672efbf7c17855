// Obstacles as lines between places, in metres of the axes.
import type { Obstacle } from './page';
import type { Box, Triple } from './positions';

/** So many corners stand for a circle. */
const kRound = 48;

/** As messages of the command call it. */
export function obstacleName(obstacle: Obstacle, place: number): string {
  const kind = { sphere: 'a sphere', box: 'a box', ground: 'the ground', cylinder: 'a cylinder', prism: 'a prism' }[obstacle.kind];
  return `obstacles[${place}], ${kind}`;
}

function ring(at: (angle: number) => Triple): Triple[] {
  const corners = Array.from({ length: kRound }, (_, i) => at((2 * Math.PI * i) / kRound));
  return corners.flatMap((corner, i) => [corner, corners[(i + 1) % kRound]]);
}

/** An outline at the bottom and at the top, and what joins them at some of its corners. */
function upright(outline: [number, number][], low: number, high: number, every: number): Triple[] {
  return outline.flatMap(([x, y], i) => {
    const [nextX, nextY] = outline[(i + 1) % outline.length];
    const around: Triple[] = [low, high].flatMap((z): Triple[] => [[x, y, z], [nextX, nextY, z]]);
    return i % every === 0 ? [...around, [x, y, low] as Triple, [x, y, high] as Triple] : around;
  });
}

/** What has no end in height ends with the swarm. */
function heightsOf({ low_m, high_m }: { low_m?: number; high_m?: number }, { least, most }: Box): [number, number] {
  const low = low_m ?? Math.min(least[2], high_m ?? Infinity);
  return [low, high_m ?? Math.max(most[2], low)];
}

/**
 * What is seen of the swarm and of what stands in its way: what lies farther out than the swarm is wide is
 * seen by turning to it, so that a fence around a town does not make the swarm a dot.
 */
export function boxWith(box: Box, obstacles: Obstacle[], least_m: number): Box {
  const reach = Math.max(least_m, ...[0, 1, 2].map((axis) => box.most[axis] - box.least[axis]));
  const [least, most]: [Triple, Triple] = [[...box.least], [...box.most]];
  for (const place of obstacles.flatMap((obstacle) => linesOf(obstacle, box))) {
    for (const axis of [0, 1, 2]) {
      least[axis] = Math.min(least[axis], Math.max(place[axis], box.least[axis] - reach));
      most[axis] = Math.max(most[axis], Math.min(place[axis], box.most[axis] + reach));
    }
  }
  return { least, most };
}

/** Places in twos, a line each. */
export function linesOf(obstacle: Obstacle, box: Box): Triple[] {
  const { least, most } = box;
  switch (obstacle.kind) {
    case 'sphere': {
      const { center: [x, y, z], radius_m: r } = obstacle;
      return [
        ...ring((a) => [x + r * Math.cos(a), y + r * Math.sin(a), z]),
        ...ring((a) => [x + r * Math.cos(a), y, z + r * Math.sin(a)]),
        ...ring((a) => [x, y + r * Math.cos(a), z + r * Math.sin(a)]),
      ];
    }
    case 'box': {
      const { low, high } = obstacle;
      return upright([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]], low[2], high[2], 1);
    }
    case 'ground': {
      const z = obstacle.height_m;
      const corners: Triple[] = [[least[0], least[1], z], [most[0], least[1], z], [most[0], most[1], z], [least[0], most[1], z]];
      return [...corners.flatMap((corner, i) => [corner, corners[(i + 1) % 4]]), corners[0], corners[2], corners[1], corners[3]];
    }
    case 'cylinder': {
      const { center: [x, y], radius_m: r } = obstacle;
      const outline = Array.from({ length: kRound }, (_, i): [number, number] => {
        const angle = (2 * Math.PI * i) / kRound;
        return [x + r * Math.cos(angle), y + r * Math.sin(angle)];
      });
      return upright(outline, ...heightsOf(obstacle, box), kRound / 4);
    }
    case 'prism':
      return upright(obstacle.outline, ...heightsOf(obstacle, box), 1);
  }
}
