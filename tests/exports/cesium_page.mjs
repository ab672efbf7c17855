// What runs in the browser: loads an export with Cesium, and says what Cesium made of it.
import { Cartographic, CzmlDataSource, Ellipsoid, JulianDate, KmlDataSource } from '@cesium/engine';

const kGraphics = ['point', 'billboard', 'label', 'polyline', 'path', 'polygon', 'cylinder', 'ellipsoid'];

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

function placeOf([id, time_s]) {
  const date = instant(time_s);
  const entity = source.entities.getById(id);
  if (!entity || !entity.isAvailable(date)) return null;
  const at = entity.position?.getValue(date);
  if (!at) return null;
  const { longitude, latitude, height } = Cartographic.fromCartesian(at);
  const below = Cartographic.toCartesian(new Cartographic(longitude, latitude, 0));
  return { at: [at.x, at.y, at.z], below: [below.x, below.y, below.z], height };
}

/** Where entities are at moments, also on the ground below; null where one is nowhere. */
export const placesOf = (asked) => asked.map(placeOf);

function lengthOf([id, time_s]) {
  const line = source.entities.getById(id)?.polyline?.positions?.getValue(instant(time_s));
  if (!line || line.length !== 2 || !line[0] || !line[1]) return null;
  return Math.hypot(line[0].x - line[1].x, line[0].y - line[1].y, line[0].z - line[1].z);
}

/** How long lines with two ends are at moments. */
export const lengthsOf = (asked) => asked.map(lengthOf);

function heightOf(id) {
  const entity = source.entities.getById(id);
  const now = JulianDate.now();
  if (entity.polygon) return [entity.polygon.height.getValue(now), entity.polygon.extrudedHeight.getValue(now)];
  const middle = Cartographic.fromCartesian(entity.position.getValue(now)).height;
  const half = entity.cylinder ? entity.cylinder.length.getValue(now) / 2 : entity.ellipsoid.radii.getValue(now).z;
  return [middle - half, middle + half];
}

/** From how low to how high obstacles are in CZML. */
export const heightsOf = (ids) => ids.map(heightOf);
