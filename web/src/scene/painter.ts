// Draws a scene of three.js by WebGL 2: points, lines and faces whose materials are shaders of our own. The renderer of
// three.js does so too, and much that no page needs: it is most of that library, and longest to start.
import type { BufferAttribute, BufferGeometry, Camera, Object3D, RawShaderMaterial } from 'three';
import { Matrix4, Vector3 } from 'three';

type Drawable = Object3D & { geometry: BufferGeometry; material: RawShaderMaterial; isPoints?: true; isLineSegments?: true; isMesh?: true };

interface Program {
  program: WebGLProgram;
  /** Vertex and fragment shader. */
  text: string;
  attributes: string[];
  /** Asked for when it draws for the first time: asking waits until the graphics card has made the program. */
  uniforms: Map<string, WebGLUniformLocation> | null;
}

const kNamed = /\b(in|uniform)\s+(?:(?:highp|mediump|lowp)\s+)?(?:float|vec\d|mat\d)\s+(\w+)/g;

interface Kept {
  buffer: WebGLBuffer;
  version: number;
  bytes: number;
}

/** What stays on the graphics card; gone with it. */
interface Card {
  programs: Map<string, Program>;
  buffers: WeakMap<BufferAttribute, Kept>;
}

function freshCard(): Card {
  return { programs: new Map(), buffers: new WeakMap() };
}

export class Painter {
  readonly #gl: WebGL2RenderingContext;
  #card = freshCard();
  #ratio = 1;
  #warming = false;
  readonly #place = new Matrix4();

  /** Throws where the browser has no WebGL 2. */
  constructor(
    readonly domElement: HTMLCanvasElement,
    antialias: boolean,
  ) {
    const gl = domElement.getContext('webgl2', { antialias, alpha: false, stencil: false, powerPreference: 'high-performance' });
    if (!gl) throw new Error('no WebGL 2');
    this.#gl = gl;
    domElement.addEventListener('webglcontextrestored', () => (this.#card = freshCard()));
  }

  getContext(): WebGL2RenderingContext {
    return this.#gl;
  }

  getPixelRatio(): number {
    return this.#ratio;
  }

  setPixelRatio(ratio: number): void {
    this.#ratio = ratio;
  }

  setSize(width: number, height: number): void {
    this.domElement.width = Math.floor(width * this.#ratio);
    this.domElement.height = Math.floor(height * this.#ratio);
  }

  setClearColor(red: number, green: number, blue: number): void {
    this.#gl.clearColor(red, green, blue, 1);
  }

  /** Has the graphics card make what it needs to draw such things, without waiting for it; nothing is seen of them. */
  warmUp(scene: Object3D, camera: Camera): void {
    this.#warming = true;
    this.render(scene, camera);
    this.#gl.flush();
    this.#warming = false;
  }

  /** All that is visible: first what hides what is behind it, then the others by their order. */
  render(scene: Object3D, camera: Camera): void {
    const gl = this.#gl;
    scene.updateMatrixWorld();
    if (camera.parent === null) camera.updateMatrixWorld();
    const things: Drawable[] = [];
    const collect = (one: Object3D): void => {
      if (!one.visible) return;
      if ('geometry' in one && 'material' in one) things.push(one as Drawable);
      one.children.forEach(collect);
    };
    collect(scene);
    const rank = ({ material, renderOrder }: Drawable): number => (material.transparent ? 1e6 : 0) + renderOrder;
    things.sort((a, b) => rank(a) - rank(b));
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.colorMask(true, true, true, true);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const thing of things) this.#draw(thing, camera);
  }

  #draw({ geometry, material, matrixWorld, isPoints, isLineSegments }: Drawable, camera: Camera): void {
    const gl = this.#gl;
    const index = geometry.getIndex();
    const { start, count } = geometry.drawRange;
    const all = index?.count ?? geometry.getAttribute('position')?.count ?? count;
    const drawn = Math.min(count, all - start);
    if (!(drawn > 0) || !Number.isFinite(drawn)) return;
    const program = this.#programOf(material);
    gl.useProgram(program.program);
    this.#setState(material);
    if (!this.#warming) {
      const uniforms = (program.uniforms ??= this.#uniformsOf(program));
      gl.uniformMatrix4fv(uniforms.get('modelViewMatrix') ?? null, false, this.#place.multiplyMatrices(camera.matrixWorldInverse, matrixWorld).elements);
      gl.uniformMatrix4fv(uniforms.get('projectionMatrix') ?? null, false, camera.projectionMatrix.elements);
      for (const [name, { value }] of Object.entries(material.uniforms)) this.#setUniform(uniforms.get(name), value);
    }
    program.attributes.forEach((name, at) => this.#bind(geometry.getAttribute(name) as BufferAttribute | undefined, at));
    const mode = isPoints ? gl.POINTS : isLineSegments ? gl.LINES : gl.TRIANGLES;
    if (index) {
      this.#upload(index, gl.ELEMENT_ARRAY_BUFFER);
      const { BYTES_PER_ELEMENT: bytes } = index.array;
      gl.drawElements(mode, drawn, bytes === 4 ? gl.UNSIGNED_INT : gl.UNSIGNED_SHORT, bytes * start);
    } else {
      gl.drawArrays(mode, start, drawn);
    }
  }

  #setState({ transparent, depthTest, depthWrite, colorWrite }: RawShaderMaterial): void {
    const gl = this.#gl;
    const set = (what: number, on: boolean): void => (on ? gl.enable(what) : gl.disable(what));
    set(gl.DEPTH_TEST, depthTest);
    set(gl.BLEND, transparent);
    gl.depthFunc(gl.LEQUAL);
    gl.depthMask(depthWrite);
    gl.colorMask(colorWrite, colorWrite, colorWrite, colorWrite);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  #setUniform(at: WebGLUniformLocation | undefined, value: unknown): void {
    const gl = this.#gl;
    if (at === undefined) return;
    if (typeof value === 'number') gl.uniform1f(at, value);
    else if (value instanceof Vector3) gl.uniform3f(at, value.x, value.y, value.z);
    else if (Array.isArray(value) && value[0] instanceof Vector3) gl.uniform3fv(at, (value as Vector3[]).flatMap((one) => one.toArray()));
    else gl.uniform2fv(at, value as [number, number]);
  }

  /** A number of each vertex, or 0 for all. */
  #bind(attribute: BufferAttribute | undefined, at: number): void {
    const gl = this.#gl;
    if (!attribute) {
      gl.disableVertexAttribArray(at);
      gl.vertexAttrib1f(at, 0);
      return;
    }
    this.#upload(attribute, gl.ARRAY_BUFFER);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, attribute.itemSize, attribute.array instanceof Uint16Array ? gl.UNSIGNED_SHORT : gl.FLOAT, false, 0, 0);
  }

  /** Binds the numbers, and brings to the graphics card what has changed of them. */
  #upload(attribute: BufferAttribute, target: number): void {
    const gl = this.#gl;
    const { array, version, updateRanges } = attribute;
    const kept = this.#card.buffers.get(attribute);
    if (!kept || kept.bytes !== array.byteLength) {
      const buffer = kept?.buffer ?? gl.createBuffer();
      gl.bindBuffer(target, buffer);
      gl.bufferData(target, array as Float32Array<ArrayBuffer>, attribute.usage);
      this.#card.buffers.set(attribute, { buffer, version, bytes: array.byteLength });
      return;
    }
    gl.bindBuffer(target, kept.buffer);
    if (kept.version === version) return;
    kept.version = version;
    if (updateRanges.length === 0) gl.bufferSubData(target, 0, array as Float32Array<ArrayBuffer>);
    for (const { start, count } of updateRanges) {
      gl.bufferSubData(target, start * array.BYTES_PER_ELEMENT, array as Float32Array<ArrayBuffer>, start, count);
    }
  }

  #programOf({ vertexShader, fragmentShader }: RawShaderMaterial): Program {
    const key = vertexShader + fragmentShader;
    const known = this.#card.programs.get(key);
    if (known) return known;
    const made = this.#makeProgram(vertexShader, fragmentShader);
    this.#card.programs.set(key, made);
    return made;
  }

  #makeProgram(vertex: string, fragment: string): Program {
    const gl = this.#gl;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
      const shader = gl.createShader(kind);
      // Null where the card is gone: then nothing is drawn until it is back.
      if (!shader) continue;
      gl.shaderSource(shader, `#version 300 es\n${text.trim()}`);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    const attributes = Array.from(vertex.matchAll(kNamed)).flatMap(([, kind, name]) => (kind === 'in' ? [name] : []));
    attributes.forEach((name, at) => gl.bindAttribLocation(program, at, name));
    gl.linkProgram(program);
    return { program, text: vertex + fragment, attributes, uniforms: null };
  }

  #uniformsOf({ program, text }: Program): Map<string, WebGLUniformLocation> {
    const uniforms = new Map<string, WebGLUniformLocation>();
    for (const [, kind, name] of text.matchAll(kNamed)) {
      const at = kind === 'uniform' ? this.#gl.getUniformLocation(program, name) : null;
      if (at) uniforms.set(name, at);
    }
    return uniforms;
  }
}
