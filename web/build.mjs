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

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

// Three.js brings the text of its own shaders, with tabs that no graphics card needs.
const untabbed = {
  name: 'untabbed',
  setup(to) {
    to.onLoad({ filter: /three\.module\.js$/ }, async ({ path }) => ({
      contents: (await readFile(path, 'utf8')).replaceAll('\\t', ''),
    }));
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
    legalComments: 'eof',
    logLevel: 'warning',
    plugins: [untabbed],
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

/** What the licences of others want to be said, out of the code: in the page it can be read. */
function withoutNotices(code) {
  const notices = [];
  const rest = code.replace(/\/\*! Bundled license information:[\s\S]*?\*\//g, (notice) => {
    notices.push(notice.replaceAll('--', '- -').replace(/^\/\*!\s*|\s*\*\/$/g, ''));
    return '';
  });
  if (notices.length !== 1) throw new Error('the notice of three.js is not where it was');
  return { code: rest.trim(), notices: notices.join('\n') };
}

const [template, guard, loader, main, style] = await Promise.all([
  readFile(here('src/page.html'), 'utf8'),
  bundle('src/guard.ts').then(inlineScript),
  bundle('src/loader.ts').then(inlineScript),
  bundle('src/main.ts').then(withoutNotices),
  bundle('src/style/page.css'),
]);

// Only these very scripts and this style may run or apply; nothing may be fetched.
const policy = [
  "default-src 'none'",
  `script-src ${[guard, loader, main.code].map(hash).join(' ')}`,
  `style-src ${hash(style)}`,
  'img-src data: blob:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

let page = place(template, '{{policy}}', policy);
page = place(page, '{{guard}}', guard);
page = place(page, '{{style}}', style);
page = place(page, '{{notices}}', `<!--\n${main.notices}\n-->`);
page = place(page, '{{code}}', deflateSync(main.code, { level: 9 }).toString('base64'));
page = place(page, '{{loader}}', loader);
if (page.split('\n').filter((line) => line === '<!-- beespace: data -->').length !== 1) {
  throw new Error('src/page.html must hold the line <!-- beespace: data --> exactly once');
}

const output = process.argv[2] ?? here('dist/page.html');
await mkdir(dirname(output), { recursive: true });
await writeFile(output, page);
console.log(`${basename(output)} ${Math.round(Buffer.byteLength(page) / 1000)} kB`);
