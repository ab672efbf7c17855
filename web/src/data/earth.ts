// Where on the Earth (WGS84) a place is that the page has as metres east and north along the ground, and a height.
// The map is described in docs/page-format.md.
import type { Origin } from './page';

const kEquator_m = 6378137;
const kFlattening = 1 / 298.257223563;
const kOfEquator = kFlattening * (2 - kFlattening);
const kDegree = Math.PI / 180;

type Place = [number, number, number];

/** Radii of curvature at a latitude: across the meridian and along it. */
function radiiAt(sine: number): { east_m: number; north_m: number } {
  const flattened = 1 - kOfEquator * sine * sine;
  const east_m = kEquator_m / Math.sqrt(flattened);
  return { east_m, north_m: (east_m * (1 - kOfEquator)) / flattened };
}

export function geographicOf(origin: Origin, [east, north, height_m]: Place): Origin {
  const [sine, cosine] = [Math.sin(origin.latitude_deg * kDegree), Math.cos(origin.latitude_deg * kDegree)];
  const radii = radiiAt(sine);
  const [eastwards, northwards] = [east / radii.east_m, north / radii.north_m];
  const angle = Math.hypot(eastwards, northwards);
  const shrink = angle > 0 ? Math.sin(angle) / angle : 1;
  // The vertical of the place, by the axes at the origin; then by those of the Earth, with the origin on its meridian 0.
  const [e, n, u] = [shrink * eastwards, shrink * northwards, Math.cos(angle)];
  const outward = u * cosine - n * sine;
  const along = u * sine + n * cosine;
  const longitude_deg = origin.longitude_deg + Math.atan2(e, outward) / kDegree;
  return {
    longitude_deg: longitude_deg > 180 ? longitude_deg - 360 : longitude_deg < -180 ? longitude_deg + 360 : longitude_deg,
    latitude_deg: Math.atan2(along, Math.hypot(e, outward)) / kDegree,
    height_m,
  };
}

/** By axes from the middle of the Earth: to the meridian 0 on the equator, to 90° east, and to the north pole. */
export function cartesianOf({ longitude_deg, latitude_deg, height_m }: Origin): Place {
  const [sine, cosine] = [Math.sin(latitude_deg * kDegree), Math.cos(latitude_deg * kDegree)];
  const { east_m } = radiiAt(sine);
  const outward = (east_m + height_m) * cosine;
  const along = longitude_deg * kDegree;
  return [outward * Math.cos(along), outward * Math.sin(along), (east_m * (1 - kOfEquator) + height_m) * sine];
}

/** Where a place of the Earth is on the page's map: the way back of `geographicOf`. */
export function mapped(origin: Origin, place: Origin): Place {
  const [sine, cosine] = [Math.sin(place.latitude_deg * kDegree), Math.cos(place.latitude_deg * kDegree)];
  const turned = (place.longitude_deg - origin.longitude_deg) * kDegree;
  const [sin0, cos0] = [Math.sin(origin.latitude_deg * kDegree), Math.cos(origin.latitude_deg * kDegree)];
  // The vertical of the place by the axes at the origin.
  const e = cosine * Math.sin(turned);
  const n = sine * cos0 - cosine * Math.cos(turned) * sin0;
  const u = sine * sin0 + cosine * Math.cos(turned) * cos0;
  const flat = Math.hypot(e, n);
  const angle = Math.atan2(flat, u);
  const stretch = flat > 0 ? angle / flat : 1;
  const radii = radiiAt(sin0);
  return [radii.east_m * stretch * e, radii.north_m * stretch * n, place.height_m];
}
