// What is out of sight is not drawn; what is in sight always is.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PerspectiveCamera, Vector3 } from 'three';
import { Frame } from '../../src/scene/frame';
import { InSight } from '../../src/scene/in_sight';
import type { Placement } from '../../src/scene/placement';
import { randomFrom } from './random';

const kBees = 4000;

function swarmOf(random: () => number): Placement {
  const axis = (): Uint16Array => Uint16Array.from({ length: kBees }, () => 65535 * random());
  return { x: axis(), y: axis(), z: axis(), start: [100, -50, 7], step: [0.01, 0.02, 0.005], shown: null, atRisk: new Uint32Array(0), lines: new Uint32Array(0) };
}

for (const seed of [1, 2, 3, 4]) {
  test(`a camera sees no bee and no line that is left out, ${seed}`, () => {
    const random = randomFrom(seed);
    const placement = swarmOf(random);
    const frame = new Frame({ least: [100, -50, 7], most: [755, 1260, 335] }, 1);
    const camera = new PerspectiveCamera(40, 1.5, 0.1, 10000);
    camera.up.set(0, 0, 1);
    camera.position.set(500 * (random() - 0.5), 900 * (random() - 0.5), 200 * (random() - 0.5));
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    const toScreen = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse);
    const inSight = new InSight(kBees);
    inSight.look(placement, frame, toScreen);
    const seen = new Set(inSight.of(null));
    const placeOf = (bee: number): Vector3 =>
      new Vector3(...frame.toScene([0, 1, 2].map((axis) => placement.start[axis] + placement.step[axis] * placement[(['x', 'y', 'z'] as const)[axis]][bee]) as [number, number, number]));
    const isSeen = (place: Vector3): boolean => {
      const { x, y, z } = place.clone().project(camera);
      return Math.abs(x) <= 1 && Math.abs(y) <= 1 && z >= -1 && z <= 1;
    };
    let inView = 0;
    for (let bee = 0; bee < kBees; ++bee) {
      if (!isSeen(placeOf(bee))) continue;
      ++inView;
      assert.ok(seen.has(bee), `bee ${bee} is in sight`);
    }
    assert.ok(seen.size < kBees && seen.size >= inView && inView > 10);
    const ends = Uint32Array.from({ length: 2000 }, () => kBees * random());
    const kept = inSight.ofLines(ends);
    assert.ok(kept.length < ends.length && kept.length % 2 === 0);
    const keptLines = new Set(Array.from({ length: kept.length / 2 }, (_, i) => `${kept[2 * i]} ${kept[2 * i + 1]}`));
    for (let i = 0; i < ends.length; i += 2) {
      const [from, to] = [placeOf(ends[i]), placeOf(ends[i + 1])];
      for (let share = 0; share <= 1; share += 1 / 64) {
        if (isSeen(from.clone().lerp(to, share))) assert.ok(keptLines.has(`${ends[i]} ${ends[i + 1]}`), `a line from ${ends[i]} crosses the view`);
      }
    }
  });
}

test('of some bees only those are in sight that were asked for', () => {
  const placement = { ...swarmOf(randomFrom(9)), shown: Uint32Array.of(5, 7, 9) };
  const frame = new Frame({ least: [100, -50, 7], most: [755, 1260, 335] }, 1);
  const camera = new PerspectiveCamera(40, 1, 0.1, 100000);
  camera.up.set(0, 0, 1);
  camera.position.set(0, -9000, 0);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const inSight = new InSight(kBees);
  inSight.look(placement, frame, camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse));
  assert.deepEqual(Array.from(inSight.of(placement.shown)), [5, 7, 9]);
});
