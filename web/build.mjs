//   node build.mjs [FILE]
//
// Makes FILE (dist/page.html without): the whole page in one file that needs nothing else, with one line
// `<!-- beespace: data -->` where `beespace report` puts the swarms.
import { createHash } from 'node:crypto';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { basename, dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateSync } from 'node:zlib';
import { build } from 'esbuild';
import { packedGround } from './ground.mjs';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

// The sources of three.js, of which only what is needed is taken; as one file it is taken nearly whole.
const three = {
  name: 'three',
  setup(to) {
    to.onResolve({ filter: /^three$/ }, () => ({ path: here('node_modules/three/src/Three.Core.js'), sideEffects: false }));
  },
};

async function bundle(entry) {
  const result = await build({
    entryPoints: [here(entry)],
    bundle: true,
    minify: true,
    write: false,
    outdir: here('dist'),
    format: 'iife',
    target: ['chrome90', 'firefox90', 'safari15'],
    charset: 'utf8',
    legalComments: 'none',
    logLevel: 'warning',
    plugins: [three],
  });
  return result.outputFiles[0].text.trim();
}

// What would end or change an inline element is written so that it means the same and does not.
function inlineScript(code) {
  return code.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');
}

function hash(text) {
  return `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;
}

function place(page, mark, text) {
  const parts = page.split(mark);
  if (parts.length !== 2) throw new Error(`src/page.html must hold ${mark} exactly once`);
  return parts[0] + text + parts[1];
}

const [template, ground, licence, guard, loader, main, style] = await Promise.all([
  readFile(here('src/page.html'), 'utf8'),
  packedGround(),
  readFile(here('node_modules/three/LICENSE'), 'utf8'),
  bundle('src/guard.ts').then(inlineScript),
  bundle('src/loader.ts').then(inlineScript),
  bundle('src/main.ts'),
  bundle('src/style/page.css'),
]);

// Only these very scripts and this style may run or apply; nothing may be fetched.
const policy = [
  "default-src 'none'",
  `script-src ${[guard, loader, main].map(hash).join(' ')}`,
  `style-src ${hash(style)}`,
  'img-src data: blob:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

let page = place(template, '{{policy}}', policy);
page = place(page, '{{guard}}', guard);
page = place(page, '{{style}}', style);
page = place(page, '{{notices}}', `<!--\nIn this page: parts of three.js.\n\n${licence.trim().replaceAll('--', '- -')}\n-->`);
page = place(page, '{{code}}', deflateSync(main, { level: 9 }).toString('base64'));
page = place(page, '{{ground}}', ground.base64);
page = place(page, '{{loader}}', loader);
if (page.split('\n').filter((line) => line === '<!-- beespace: data -->').length !== 1) {
  throw new Error('src/page.html must hold the line <!-- beespace: data --> exactly once');
}

const output = process.argv[2] ?? here('dist/page.html');
await mkdir(dirname(output), { recursive: true });
await writeFile(output, page);
const kB = (bytes) => `${Math.round(bytes / 1000)} kB`;
console.log(`${basename(output)} ${kB(Buffer.byteLength(page))}, of these ${kB(ground.base64.length)} are the ground of pages of wide areas`);
