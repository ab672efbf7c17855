// Shaders. They take raw u16 numbers as they are kept and make metres of them on the graphics card.
import { DoubleSide, GLSL3, RawShaderMaterial, Vector3 } from 'three';
import { kRampSteps, rgb } from './palette';

const kPlace = `
precision highp float;
in float x; in float y; in float z;
uniform vec3 start; uniform vec3 stride;
uniform mat4 modelViewMatrix; uniform mat4 projectionMatrix;
vec4 place() { return modelViewMatrix * vec4(start + stride * vec3(x, y, z), 1.0); }
`;

const kSize = `
uniform float reach; uniform vec2 sizes;
float size(float depth) { return clamp(reach / max(depth, 1e-6), sizes.x, sizes.y); }
`;

export function vectorOf(colour: string): Vector3 {
  return new Vector3(...rgb(colour));
}

/** The colour of a bee: of its number between two others on a scale of colours. Without a number it is 0. */
const kColour = `
in float near;
uniform vec3 ramp[${kRampSteps}]; uniform vec2 range;
vec3 rampColour() {
  float t = clamp((near - range.x) * range.y, 0.0, 1.0) * ${(kRampSteps - 1).toFixed(1)};
  int low = min(int(t), ${kRampSteps - 2});
  return mix(ramp[low], ramp[low + 1], t - float(low));
}
`;

function colourUniforms(): Record<'ramp' | 'range', { value: unknown }> {
  return { ramp: { value: Array.from({ length: kRampSteps }, () => new Vector3()) }, range: { value: [0, 1] } };
}

/** All bees. */
export function crowdMaterial(): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    uniforms: {
      start: { value: new Vector3() },
      stride: { value: new Vector3(1, 1, 1) },
      reach: { value: 1 },
      sizes: { value: [1, 2] },
      ...colourUniforms(),
    },
    vertexShader: `${kPlace}${kSize}${kColour}
      flat out vec3 colour;
      void main() {
        vec4 at = place();
        gl_Position = projectionMatrix * at;
        gl_PointSize = size(-at.z);
        colour = rampColour();
      }`,
    fragmentShader: `precision mediump float;
      flat in vec3 colour; out vec4 fragment;
      void main() {
        vec2 d = gl_PointCoord - 0.5;
        if (dot(d, d) > 0.26) discard;
        fragment = vec4(colour, 1.0);
      }`,
  });
}

/** Bees at risk: diamonds with an edge, over everything else. */
export function riskMaterial(): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    depthTest: false,
    depthWrite: false,
    transparent: true,
    uniforms: {
      start: { value: new Vector3() },
      stride: { value: new Vector3(1, 1, 1) },
      reach: { value: 1 },
      sizes: { value: [3, 12] },
      fill: { value: new Vector3() },
      opacity: { value: 1 },
      edge: { value: new Vector3() },
      ...colourUniforms(),
      ramped: { value: 0 },
    },
    vertexShader: `${kPlace}${kSize}${kColour}
      uniform float opacity; uniform float ramped; uniform vec3 fill;
      flat out float edgeFrom; flat out float cover; flat out vec3 colour;
      void main() {
        vec4 at = place();
        gl_Position = projectionMatrix * at;
        gl_PointSize = size(-at.z);
        colour = ramped > 0.5 ? rampColour() : fill;
        // A pixel of edge where there is room for one.
        // Large ones are few on the screen.
        cover = gl_PointSize < 5.0 ? opacity : 1.0;
        edgeFrom = gl_PointSize < 7.0 ? 2.0 : 1.0 - 2.6 / gl_PointSize;
      }`,
    fragmentShader: `precision mediump float;
      uniform vec3 edge;
      flat in float edgeFrom; flat in float cover; flat in vec3 colour; out vec4 fragment;
      void main() {
        vec2 d = abs(gl_PointCoord * 2.0 - 1.0);
        float far = d.x + d.y;
        if (far > 1.0 && edgeFrom < 1.5) discard;
        fragment = vec4(far > edgeFrom ? edge : colour, cover);
      }`,
  });
}

/** Lines between bees, from the same raw numbers. */
export function lineMaterial(): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    depthTest: false,
    depthWrite: false,
    transparent: true,
    uniforms: {
      start: { value: new Vector3() },
      stride: { value: new Vector3(1, 1, 1) },
      colour: { value: new Vector3() },
      opacity: { value: 1 },
    },
    vertexShader: `${kPlace} void main() { gl_Position = projectionMatrix * place(); }`,
    fragmentShader: `precision mediump float;
      uniform vec3 colour; uniform float opacity; out vec4 fragment;
      void main() { fragment = vec4(colour, opacity); }`,
  });
}

/** Rings of so many pixels around places in metres of the scene, over everything else. */
export function ringMaterial(pixels: number): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    depthTest: false,
    depthWrite: false,
    transparent: true,
    uniforms: { colour: { value: new Vector3() }, ratio: { value: 1 } },
    vertexShader: `precision highp float;
      in vec3 position; uniform float ratio;
      uniform mat4 modelViewMatrix; uniform mat4 projectionMatrix;
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        gl_PointSize = ${pixels.toFixed(1)} * ratio;
      }`,
    fragmentShader: `precision mediump float;
      uniform vec3 colour; out vec4 fragment;
      void main() {
        float far = 2.0 * length(gl_PointCoord - 0.5);
        if (far > 1.0 || far < ${(1 - 4 / pixels).toFixed(3)}) discard;
        fragment = vec4(colour, 1.0);
      }`,
  });
}

/** Lines and faces in metres of the scene; `fade` fades them by the vertex. */
export function shapeMaterial(fade: boolean, onTop: boolean): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    depthTest: !onTop,
    depthWrite: false,
    transparent: true,
    side: DoubleSide,
    uniforms: { colour: { value: new Vector3() }, opacity: { value: 1 } },
    vertexShader: `precision highp float;
      in vec3 position; ${fade ? 'in float strength;' : ''} out float share;
      uniform mat4 modelViewMatrix; uniform mat4 projectionMatrix;
      void main() {
        share = ${fade ? 'strength' : '1.0'};
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `precision mediump float;
      uniform vec3 colour; uniform float opacity; in float share; out vec4 fragment;
      void main() { fragment = vec4(colour, opacity * share); }`,
  });
}
