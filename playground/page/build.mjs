// Bundles the page: build.mjs WASM OUTPUT TOOLS. OUTPUT is a folder of static files for any web server; TOOLS gets what
// package.json lists.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));
const root = `${here}../../`;
const [wasm, output, tools] = process.argv.slice(2);
const { build } = installed();
const kCommon = { bundle: true, minify: true, format: 'iife', target: ['chrome109', 'firefox115', 'safari16.4'], legalComments: 'none', write: false };

/** The bundler, of the packages in TOOLS, which are installed again when the list has changed. */
function installed() {
  const lock = readFileSync(`${here}package-lock.json`);
  const known = `${tools}/package-lock.json`;
  if (!existsSync(`${tools}/node_modules`) || !existsSync(known) || !lock.equals(readFileSync(known))) {
    mkdirSync(tools, { recursive: true });
    rmSync(`${tools}/node_modules`, { recursive: true, force: true });
    for (const name of ['package.json', 'package-lock.json']) copyFileSync(here + name, `${tools}/${name}`);
    execFileSync('npm', ['ci', '--silent', '--no-audit', '--no-fund', '--ignore-scripts'], { cwd: tools, stdio: 'inherit' });
  }
  return createRequire(`${tools}/package.json`)('esbuild');
}

/** The text of a bundle. */
async function bundle(file, options = {}) {
  const { outputFiles } = await build({ ...kCommon, entryPoints: [`${here}src/${file}`], nodePaths: [`${tools}/node_modules`], ...options });
  return outputFiles[0].text;
}

/** What the tutorial changes in the file that decides, by language: the lines below a mark in docs/tutorial.md, in a fence. */
function changesOfTutorial() {
  const tutorial = readFileSync(`${root}docs/tutorial.md`, 'utf8');
  const changes = tutorial.matchAll(/<!-- change: (\w+) [^\n]* -->\n```\w+\n([^]*?)```\n/g);
  return JSON.stringify(Object.fromEntries(Array.from(changes, ([, language, text]) => [language, text])));
}

/** The files around a team in the project that the page saves, by language and path. */
function projectFiles() {
  const text = (path) => readFileSync(`${root}${path}`, 'utf8');
  const folder = (from, to, pattern) => Object.fromEntries(readdirSync(`${root}${from}`).filter((name) => pattern.test(name))
    .map((name) => [`${to}/${name}`, text(`${from}/${name}`)]));
  const all = {
    ...folder('proto', 'proto', /playmaker\.proto$/), ...folder('examples/project/tests', 'tests', /\.json$/),
    'cls.toml': text('examples/project/cls.toml'), '.gitignore': text('examples/project/gitignore'),
  };
  const own = (language, paths) => Object.fromEntries(paths.map((path) => [path, text(`examples/${language}/${path}`)]));
  return {
    javascript: { ...all, ...own('javascript', ['run', 'package.json', 'src/main.js', 'src/service.js']) },
    python: { ...all, ...own('python', ['run', 'playmaker.py']), ...folder('python/cls_playmaker', 'package/cls_playmaker', /^(?!.*_pb2).*\.py$/) },
  };
}

const sourceHash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** A replay page up to its match, as viewer/page/page.cpp writes it. */
async function replayStart(program) {
  const version = /^project\(cls VERSION ([0-9.]+)/m.exec(readFileSync(`${root}CMakeLists.txt`, 'utf8'))[1];
  const script = (await bundle(program)).replaceAll('</script', '<\\/script');
  const style = readFileSync(`${root}viewer/web/style.css`, 'utf8');
  const settings = JSON.stringify({ schema: 'cls.page/1', cls: version, at: null, players: [], live: null });
  const policy = `default-src 'none'; script-src ${sourceHash(script)}; style-src ${sourceHash(style)}; img-src data: blob:; base-uri 'none'; form-action 'none'`;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="cls ${version}">
<title>@TITLE@</title>
<style>${style}</style>
</head>
<body>
<noscript><p>This page shows a match with JavaScript, which is switched off.</p></noscript>
<div id="app"></div>
<script type="application/json" id="settings">${settings}</script>
<script>${script}</script>
`;
}

// Files as texts, the change of the tutorial, and bundles within bundles.
const texts = {
  name: 'texts',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /\?text$/ }, ({ path, resolveDir }) => ({ path: new URL(path.slice(0, -5), `file://${resolveDir}/`).pathname, namespace: 'text' }));
    onLoad({ filter: /./, namespace: 'text' }, ({ path }) => ({ contents: readFileSync(path, 'utf8'), loader: 'text' }));
    onResolve({ filter: /^tutorial:changes$/ }, ({ path }) => ({ path, namespace: 'tutorial' }));
    onLoad({ filter: /./, namespace: 'tutorial' }, () => ({ contents: changesOfTutorial(), loader: 'json' }));
    onResolve({ filter: /^bundled:/ }, ({ path }) => ({ path: path.slice(8), namespace: 'bundle' }));
    onLoad({ filter: /./, namespace: 'bundle' }, async ({ path }) => ({ contents: await bundle(path, { plugins: [texts] }), loader: 'text' }));
  },
};

rmSync(output, { recursive: true, force: true });
mkdirSync(output, { recursive: true });
const save = (name, text) => writeFileSync(`${output}/${name}`, text);

save('page.js', await bundle('main.js', { plugins: [texts] }));
save('field.js', await bundle('field.js'));
const sandbox = (await bundle('sandbox.js', { plugins: [texts] })).replaceAll('</script', '<\\/script');
save('sandbox.html', readFileSync(`${here}sandbox.html`, 'utf8').replace("'HASH'", sourceHash(sandbox)).replace('PROGRAM', () => sandbox));
save('project.json', JSON.stringify(projectFiles()));
save('replay.json', JSON.stringify({ viewer: await replayStart('replay.js'), debugger: await replayStart('replay_debugger.js') }));
for (const name of ['index.html', 'field.html', 'page.css', 'field-in-page.css']) copyFileSync(here + name, `${output}/${name}`);
copyFileSync(`${root}viewer/web/style.css`, `${output}/field.css`);
copyFileSync(wasm, `${output}/cls.wasm`);
for (const name of ['pyodide.mjs', 'pyodide.asm.mjs', 'pyodide.asm.wasm', 'python_stdlib.zip', 'pyodide-lock.json']) {
  copyFileSync(`${tools}/node_modules/pyodide/${name}`, `${output}/${name}`);
}
