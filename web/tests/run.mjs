// Bundles the tests of a folder into one file and runs it with Node's own runner, one test after the
// other, so that what is timed is not disturbed: node tests/run.mjs unit, or browser with a part of a name.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const [kind, ...parts] = process.argv.slice(2);
const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const names = readdirSync(here(`${kind}/`)).filter((name) => name.endsWith('.test.ts'));
const wanted = parts.length > 0 ? names.filter((name) => parts.some((part) => name.includes(part))) : names;
if (wanted.length === 0) throw new Error(`no test file has ${parts.join(' or ')} in its name`);
const bundle = here(`artefacts/${kind}.test.mjs`);

mkdirSync(here('artefacts/'), { recursive: true });
await build({
  stdin: {
    contents: wanted.sort().map((name) => `import './${name}';`).join('\n'),
    resolveDir: here(`${kind}/`),
  },
  outfile: bundle,
  bundle: true,
  format: 'esm',
  platform: 'node',
  target: 'node18',
  packages: 'external',
  logLevel: 'warning',
});
const run = spawnSync(process.execPath, ['--test', '--test-reporter=spec', bundle], {
  stdio: 'inherit',
  cwd: here('..'),
});
process.exit(run.status ?? 1);
