// Makes a folder of pages to test with: the built page with made-up swarms in it.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Head } from '../../src/data/page';
import { fewBees, oneMoment } from './edges';
import { Elements } from './encode';
import { recordingHead } from './recordings';
import { snapshotHead } from './snapshots';

export const kHostileNames = [
  '<img src=x onerror="window.__pwned = 1">',
  '</script><script>window.__pwned = 1</script>',
  '"><svg onload=window.__pwned=1>',
  '\u202Eevil\u202D right to left \u05D0\u05D1\u05D2',
  '\u{1F41D}\u{1F41D}\u200D\u{1F469} & <b>bold</b>',
  '{{constructor}}${7*7}',
  "'; window.__pwned = 1; //",
  '\u0000\u0007\n\ttabs and lines',
  '',
  'x'.repeat(10000),
];

function write(folder: string, template: string, name: string, make: (elements: Elements) => Head[]): void {
  const elements = new Elements();
  const swarms = make(elements);
  const data = elements.html({ format: 1, beespace: '0.1.0', swarms });
  writeFileSync(join(folder, `${name}.html`), template.replace('<!-- beespace: data -->', () => data));
}

export function makePages(folder: string, builtPage: string): void {
  mkdirSync(folder, { recursive: true });
  const template = readFileSync(builtPage, 'utf8');
  const page = (name: string, make: (elements: Elements) => Head[]): void => write(folder, template, name, make);

  const small = { count: 1000, size_m: 1000, threshold_m: 20, seed: 7, geographic: true };
  const calls = Array.from({ length: 1000 }, (_, i) => `N${String((i * 7919) % 100000).padStart(5, '0')}`);
  page('snapshot', (e) => [snapshotHead(e, { ...small, names: calls, notes: ['2 records were left out: they hold no position.'] })]);
  page('calm', (e) => [snapshotHead(e, { ...small, noRisk: true })]);
  page('cylinder', (e) => [snapshotHead(e, { ...small, vertical_m: 8 })]);
  page('hundred-thousand', (e) => [snapshotHead(e, { count: 100000, size_m: 5000, threshold_m: 12, seed: 3 })]);
  page('million', (e) => [
    snapshotHead(e, { count: 1000000, size_m: 10000, threshold_m: 12, seed: 5, mostPairs: 200000 }),
  ]);
  page('compared-snapshots', (e) => [snapshotHead(e, small), snapshotHead(e, { ...small, seed: 8, title: 'after.csv', threshold_m: 12 })]);
  const names = Array.from({ length: 1000 }, (_, i) => `${kHostileNames[i % kHostileNames.length]}${i < 10 ? '' : ` ${i}`}`);
  page('hostile', (e) => [
    snapshotHead(e, { ...small, names, title: kHostileNames[1], notes: kHostileNames }),
  ]);
  const flight = { bees: 200, fixes: 240, seconds: 120, threshold_m: 8, seed: 11, title: 'flight.csv' };
  page('recording', (e) => [recordingHead(e, { ...flight, since1970: true })]);
  page('compared-recordings', (e) => [
    recordingHead(e, { ...flight, title: 'before.csv' }),
    recordingHead(e, { ...flight, title: 'after.csv', care: 1.5 }),
  ]);
  page('nobody', (e) => [fewBees(e, 0, 5)]);
  page('one-bee', (e) => [fewBees(e, 1, 5)]);
  page('same-place', (e) => [fewBees(e, 3, 5)]);
  page('no-threshold', (e) => [fewBees(e, 2, 0)]);
  page('one-moment', (e) => [oneMoment(e)]);
  page('moment-beside-swarm', (e) => [fewBees(e, 2, 5), oneMoment(e)]);
  page('long-recording', (e) => [
    recordingHead(e, { ...flight, bees: 1000, fixes: 5000, seconds: 2500, looks: 100, title: 'long.csv' }),
  ]);
}
