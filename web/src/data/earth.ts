// Where on the Earth (WGS84) a place is that the page has as metres east, north and up of an origin.
import type { Origin } from './page';

const kEquator_m = 6378137;
const kFlattening = 1 / 298.257223563;
const kPole_m = kEquator_m * (1 - kFlattening);
const kOfEquator = kFlattening * (2 - kFlattening);
const kOfPole = kOfEquator / (1 - kOfEquator);
const kDegree = Math.PI / 180;

type Place = [number, number, number];

interface Sky {
  longitude: { cosine: number; sine: number };
  latitude: { cosine: number; sine: number };
}

function skyAt({ longitude_deg, latitude_deg }: Origin): Sky {
  const direction = (degrees: number) => ({ cosine: Math.cos(degrees * kDegree), sine: Math.sin(degrees * kDegree) });
  return { longitude: direction(longitude_deg), latitude: direction(latitude_deg) };
}

/** From the axis to the surface, along the vertical. */
function normalAt(sine: number): number {
  return kEquator_m / Math.sqrt(1 - kOfEquator * sine * sine);
}

function toEarthCentred(origin: Origin, [east, north, up]: Place): Place {
  const { longitude, latitude } = skyAt(origin);
  const normal = normalAt(latitude.sine);
  const fromAxis = (normal + origin.height_m + up) * latitude.cosine - north * latitude.sine;
  const along = ((1 - kOfEquator) * normal + origin.height_m + up) * latitude.sine + north * latitude.cosine;
  return [
    fromAxis * longitude.cosine - east * longitude.sine,
    fromAxis * longitude.sine + east * longitude.cosine,
    along,
  ];
}

/** Bowring, Survey Review 23 (1976): one step, right far below a millimetre wherever bees fly. */
export function geographicOf(origin: Origin, place: Place): Origin {
  const [x, y, z] = toEarthCentred(origin, place);
  const fromAxis = Math.hypot(x, y);
  const reduced = Math.atan2(z * kEquator_m, fromAxis * kPole_m);
  const latitude = Math.atan2(
    z + kOfPole * kPole_m * Math.sin(reduced) ** 3,
    fromAxis - kOfEquator * kEquator_m * Math.cos(reduced) ** 3,
  );
  const [sine, cosine] = [Math.sin(latitude), Math.cos(latitude)];
  const surface = kEquator_m * Math.sqrt(1 - kOfEquator * sine * sine);
  return {
    longitude_deg: Math.atan2(y, x) / kDegree,
    latitude_deg: latitude / kDegree,
    height_m: fromAxis * cosine + z * sine - surface,
  };
}
