// What exports must agree with: the answers of detect and replay, as make_files.sh leaves them.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** As names of pairs in KML and CZML have it. */
export const kBetween = ' \u2013 ';

/** The name of each export in a folder, with its answer. */
export function exportsIn(folder) {
  return readdirSync(folder)
    .filter((file) => file.endsWith('.geojson'))
    .map((file) => file.replace('.geojson', ''))
    .map((name) => ({ name, answer: JSON.parse(readFileSync(join(folder, `${name}.json`), 'utf8')) }));
}

/** Ids of pairs or conflicts as texts. */
export function pairsOf(answer) {
  return (answer.conflicts ?? answer.pairs).map((pair) => {
    const name = (id, label) => (label ? `${id} (${label})` : String(id));
    return { ...pair, names: [name(pair.first, pair.first_label), name(pair.second, pair.second_label)] };
  });
}
