// Bundles each test file of a folder and runs it with Node's own runner: node tests/run.mjs unit, or browser with
// a part of a name. As many files at once as there are cores, but for the one that tells how fast pages are, which
// comes last and by itself.
import { spawn } from 'node:child_process';
import { mkdirSync, readdirSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const [kind, ...parts] = process.argv.slice(2);
const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const names = readdirSync(here(`${kind}/`)).filter((name) => name.endsWith('.test.ts'));
const wanted = parts.length > 0 ? names.filter((name) => parts.some((part) => name.includes(part))) : names;
if (wanted.length === 0) throw new Error(`no test file has ${parts.join(' or ')} in its name`);

mkdirSync(here('artefacts/'), { recursive: true });
await build({
  entryPoints: wanted.map((name) => here(`${kind}/${name}`)),
  outdir: here(`artefacts/${kind}/`),
  outExtension: { '.js': '.mjs' },
  bundle: true,
  format: 'esm',
  platform: 'node',
  target: 'node18',
  packages: 'external',
  logLevel: 'warning',
});

/** What it says is shown once it has ended, so that files do not speak at the same time. */
function run(name) {
  const bundle = here(`artefacts/${kind}/${name.replace(/\.ts$/, '.mjs')}`);
  const child = spawn(process.execPath, ['--test', '--test-reporter=spec', bundle], { cwd: here('..') });
  const said = [];
  child.stdout.on('data', (data) => said.push(data));
  child.stderr.on('data', (data) => said.push(data));
  return new Promise((ended) => {
    child.on('close', (status) => {
      console.log(`---- ${kind}/${name}${status === 0 ? '' : ': FAILED'}`);
      process.stdout.write(Buffer.concat(said));
      ended(status === 0 ? [] : [name]);
    });
  });
}

const alone = wanted.filter((name) => name.startsWith('speed.'));
const waiting = wanted.filter((name) => !alone.includes(name));
async function lane() {
  const failed = [];
  for (let name = waiting.shift(); name; name = waiting.shift()) failed.push(...(await run(name)));
  return failed;
}
const failed = (await Promise.all(Array.from({ length: availableParallelism() }, lane))).flat();
for (const name of alone) failed.push(...(await run(name)));
if (failed.length > 0) console.log(`FAILED: ${failed.join(', ')}`);
process.exitCode = failed.length > 0 ? 1 : 0;
