// What runs in the browser: loads an export with Cesium, and says what Cesium made of it.
import {
  Cartographic,
  CesiumWidget,
  Color,
  CzmlDataSource,
  DataSourceCollection,
  DataSourceDisplay,
  Ellipsoid,
  HeadingPitchRange,
  JulianDate,
  KmlDataSource,
  BoundingSphere,
} from '@cesium/engine';

const kGraphics = ['point', 'billboard', 'label', 'polyline', 'path', 'polygon', 'cylinder', 'ellipsoid'];

let widget;
let display;
let source;

const secondsOf = (date) => JulianDate.toDate(date).getTime() / 1000;
const instant = (time_s) => JulianDate.fromDate(new Date(time_s * 1000));

function describe(entity) {
  const availability = entity.availability;
  const intervals = [];
  for (let i = 0; i < (availability?.length ?? 0); ++i) {
    const { start, stop } = availability.get(i);
    intervals.push([secondsOf(start), secondsOf(stop)]);
  }
  return {
    id: entity.id,
    name: entity.name ?? '',
    parent: entity.parent?.name ?? '',
    intervals,
    has: kGraphics.filter((kind) => entity[kind] !== undefined),
    label: entity.label?.text?.getValue?.(JulianDate.now()) ?? null,
    children: entity._children?.length ?? 0,
  };
}

/** Loads it; returns what is in it. */
export async function load(name, text) {
  if (name.endsWith('.kml')) {
    const xml = new DOMParser().parseFromString(text, 'application/xml');
    source = await KmlDataSource.load(xml, { canvas: document.createElement('canvas'), ellipsoid: Ellipsoid.WGS84 });
  } else {
    source = await CzmlDataSource.load(JSON.parse(text));
  }
  const clock = source.clock;
  return {
    name: source.name,
    clock: clock && {
      begins_s: secondsOf(clock.startTime),
      ends_s: secondsOf(clock.stopTime),
      current_s: secondsOf(clock.currentTime),
      multiplier: clock.multiplier,
    },
    entities: source.entities.values.map(describe),
  };
}

function cartesianOf(entity, date) {
  return entity.position?.getValue(date);
}

/** Where an entity is, also on the ground below; null where it is nowhere. */
export function placeOf(id, time_s) {
  const date = instant(time_s);
  const entity = source.entities.getById(id);
  if (!entity || !entity.isAvailable(date)) return null;
  const at = cartesianOf(entity, date);
  if (!at) return null;
  const { longitude, latitude, height } = Cartographic.fromCartesian(at);
  const below = Cartographic.toCartesian(new Cartographic(longitude, latitude, 0));
  return { at: [at.x, at.y, at.z], below: [below.x, below.y, below.z], height };
}

/** How long a line is, of a polyline with two ends. */
export function lengthOf(id, time_s) {
  const line = source.entities.getById(id)?.polyline?.positions?.getValue(instant(time_s));
  if (!line || line.length !== 2 || !line[0] || !line[1]) return null;
  return Math.hypot(line[0].x - line[1].x, line[0].y - line[1].y, line[0].z - line[1].z);
}

/** Heights of an obstacle in CZML. */
export function heightsOf(id) {
  const entity = source.entities.getById(id);
  const now = JulianDate.now();
  if (entity.polygon) return [entity.polygon.height.getValue(now), entity.polygon.extrudedHeight.getValue(now)];
  const middle = Cartographic.fromCartesian(entity.position.getValue(now)).height;
  const half = entity.cylinder ? entity.cylinder.length.getValue(now) / 2 : entity.ellipsoid.radii.getValue(now).z;
  return [middle - half, middle + half];
}

/** Draws it at a moment; the camera sees all of it. */
export async function show(time_s) {
  if (!widget) {
    widget = new CesiumWidget('globe', { baseLayer: false, skyBox: false, skyAtmosphere: false, contextOptions: { webgl: { preserveDrawingBuffer: true } } });
    widget.scene.globe.baseColor = Color.fromCssColorString('#26303a');
    widget.scene.globe.depthTestAgainstTerrain = false;
    const sources = new DataSourceCollection();
    display = new DataSourceDisplay({ scene: widget.scene, dataSourceCollection: sources });
  }
  const sources = display.dataSources;
  sources.removeAll();
  await sources.add(source);
  const date = time_s === null ? JulianDate.now() : instant(time_s);
  widget.clock.shouldAnimate = false;
  widget.clock.currentTime = date;
  const draw = async (frames) => {
    for (let i = 0; i < frames; ++i) {
      display.update(date);
      widget.render();
      await new Promise((done) => setTimeout(done, 20));
    }
  };
  await draw(100);
  const spheres = [];
  for (const entity of source.entities.values) {
    const sphere = new BoundingSphere();
    if (display.getBoundingSphere(entity, true, sphere) === 0) spheres.push(BoundingSphere.clone(sphere));
  }
  if (spheres.length > 0) {
    const all = BoundingSphere.fromBoundingSpheres(spheres);
    widget.camera.viewBoundingSphere(all, new HeadingPitchRange(0.4, -0.6, Math.max(60, 2.6 * all.radius)));
  }
  await draw(60);
  return spheres.length;
}
