// The graphics card begins before the data are read: it takes as long to make its programs as the page to read them.
import { BufferAttribute, BufferGeometry, LineSegments, PerspectiveCamera, Points, Scene } from 'three';
import type { RawShaderMaterial } from 'three';
import type { EarlyHead } from '../data/page';
import { element } from '../text/element';
import { crowdMaterial, lineMaterial, riskMaterial, shapeMaterial } from './materials';
import { Painter } from './painter';

/** Of a line. */
const kEnds = 2;

/** Numbers of the kind that will be drawn: other kinds are other programs. */
function bare(names: string[], size: number, Kind: typeof Uint16Array | typeof Float32Array = Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const name of names) geometry.setAttribute(name, new BufferAttribute(name === 'near' ? new Uint16Array(kEnds) : new Kind(kEnds * size), size));
  // What has no end is not drawn.
  geometry.setDrawRange(0, kEnds);
  return geometry;
}

/** One that is set to draw a thing of each kind, of no size; null where the browser has no WebGL. */
export function earlyRenderer({ count, kind }: EarlyHead): Painter | null {
  try {
    const renderer = new Painter(element('canvas'), count <= 20000);
    renderer.setSize(1, 1);
    const numbers = kind === 'snapshot' ? Uint16Array : Float32Array;
    const scene = new Scene();
    const places = ['x', 'y', 'z'];
    const add = (thing: Points<BufferGeometry, RawShaderMaterial> | LineSegments<BufferGeometry, RawShaderMaterial>): void => {
      thing.frustumCulled = false;
      scene.add(thing);
    };
    add(new Points(bare([...places, 'near'], 1, numbers), crowdMaterial()));
    add(new Points(bare([...places, 'near'], 1, numbers), riskMaterial()));
    add(new LineSegments(bare(places, 1, numbers), lineMaterial()));
    add(new LineSegments(bare(['position'], 3), shapeMaterial(false, false)));
    renderer.warmUp(scene, new PerspectiveCamera());
    return renderer;
  } catch {
    return null;
  }
}
