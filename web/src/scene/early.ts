// The graphics card begins before the data are read: it takes as long to make its programs as the page to read them.
import { BufferAttribute, BufferGeometry, LineSegments, PerspectiveCamera, Points, Scene, WebGLRenderer } from 'three';
import type { RawShaderMaterial } from 'three';
import { element } from '../text/element';
import { crowdMaterial, lineMaterial, riskMaterial, shapeMaterial } from './materials';

function bare(names: string[], size: number): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const name of names) geometry.setAttribute(name, new BufferAttribute(new Float32Array(2 * size), size));
  return geometry;
}

/** One that has drawn a thing of each kind, of no size; null where the browser has no WebGL. */
export function earlyRenderer(count: number, coloured: boolean): WebGLRenderer | null {
  try {
    const renderer = new WebGLRenderer({
      canvas: element('canvas'),
      antialias: count <= 20000,
      alpha: false,
      stencil: false,
      powerPreference: 'high-performance',
    });
    renderer.setSize(1, 1, false);
    const scene = new Scene();
    const places = ['x', 'y', 'z'];
    const add = (thing: Points<BufferGeometry, RawShaderMaterial> | LineSegments<BufferGeometry, RawShaderMaterial>): void => {
      thing.frustumCulled = false;
      scene.add(thing);
    };
    add(new Points(bare(coloured ? [...places, 'near'] : places, 1), crowdMaterial(coloured)));
    add(new Points(bare(places, 1), riskMaterial()));
    add(new LineSegments(bare(places, 1), lineMaterial()));
    add(new LineSegments(bare(['position'], 3), shapeMaterial(false, false)));
    renderer.render(scene, new PerspectiveCamera());
    return renderer;
  } catch {
    return null;
  }
}
