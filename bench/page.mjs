#!/usr/bin/env node
// What the page that plays matches costs a visitor, in Chromium: bench/page.mjs [PAGE]. Sizes are those of a host that
// compresses with gzip; memory is the proportional share (PSS) of the processes that run the page, its frames and its
// workers, beside that of an empty page. Times depend on what else runs: the load is printed.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { loadavg } from 'node:os';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const root = fileURLToPath(new URL('..', import.meta.url));
const [page = `${root}build-playground/page`] = process.argv.slice(2);
const kRounds = 3;
const kLongMs = 600_000;
/** Loaded when the visitor saves something or plays a team in Python. */
const kOnDemand = /^(project|replay|pyodide|python)/;

function skip(why) {
  console.log(`page skipped: ${why}`);
  process.exit(0);
}

const chromium = process.env.CHROMIUM ?? ['chromium', 'chromium-browser', 'google-chrome'].map((name) => {
  try {
    return execFileSync('which', [name], { encoding: 'utf8' }).trim();
  } catch {
    return '';
  }
}).find(Boolean);
if (!existsSync(`${page}/index.html`)) skip(`no ${page} (make playground)`);
if (!chromium) skip('no Chromium (apt-get install chromium)');
if (!existsSync(`${root}tests/viewer/browser/node_modules/playwright-core`)) skip('no driver of browsers (make web-test installs it)');
const { serve, whenShown, resultMatches } = await import('../tests/playground/browser/site.mjs');
const driver = createRequire(`${root}tests/viewer/browser/package.json`)('playwright-core').chromium;

const args = process.getuid() === 0 ? ['--no-sandbox'] : [];
const server = await driver.launchServer({ executablePath: chromium, args });
const browser = await driver.connect(server.wsEndpoint());
const site = await serve(page);

/** The processes of the browser that run pages, and what they use, in MB. */
function memory() {
  const parents = new Map(readdirSync('/proc').filter((name) => /^\d+$/.test(name)).map((pid) => {
    try {
      return [Number(pid), Number(/^PPid:\s+(\d+)/m.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1])];
    } catch {
      return [Number(pid), 0]; // it has ended
    }
  }));
  const isOurs = (pid) => pid > 1 && (pid === server.process().pid || isOurs(parents.get(pid) ?? 0));
  let kilobytes = 0;
  for (const pid of parents.keys()) {
    if (!isOurs(pid)) continue;
    try {
      if (!readFileSync(`/proc/${pid}/cmdline`, 'utf8').includes('--type=renderer')) continue;
      kilobytes += Number(/^Pss:\s+(\d+)/m.exec(readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8'))[1]);
    } catch {
      // it has ended
    }
  }
  return kilobytes / 1024;
}

/** Seconds from the address to the first picture of a match. */
async function firstPicture(context) {
  const tab = await context.newPage();
  const began = performance.now();
  await tab.goto(site.url);
  await whenShown(tab, 1, kLongMs);
  const seconds = (performance.now() - began) / 1000;
  await tab.close();
  return seconds;
}

const best = (values) => Math.min(...values).toFixed(1);
const cold = [];
const warm = [];
for (let i = 0; i < kRounds; ++i) {
  const context = await browser.newContext();
  cold.push(await firstPicture(context));
  warm.push(await firstPicture(context));
  await context.close();
}

const context = await browser.newContext({ viewport: { width: 1366, height: 768 } });
const tab = await context.newPage();
await tab.goto('about:blank');
const empty = memory();
await tab.goto(site.url);
let most = 0;
const timer = setInterval(() => {
  most = Math.max(most, memory());
}, 500);
const result = await resultMatches(tab, /cycles at/, kLongMs);
clearInterval(timer);
most = Math.max(most, memory());

const sizes = Object.fromEntries(readdirSync(page).map((name) => [name, gzipSync(readFileSync(`${page}/${name}`), { level: 9 }).length]));
const sum = (names) => (names.reduce((bytes, name) => bytes + sizes[name], 0) / 1e6).toFixed(2);
console.log(`page: ${sum(Object.keys(sizes).filter((name) => !kOnDemand.test(name)))} MB with gzip, of them cls.wasm ${sum(['cls.wasm'])} MB, and ${sum(Object.keys(sizes).filter((name) => kOnDemand.test(name)))} MB on demand`);
console.log(`first picture of a match: ${best(cold)} s, again ${best(warm)} s (best of ${kRounds})`);
console.log(`a whole match: ${result}`);
console.log(`memory at most ${(most - empty).toFixed(0)} MB, beside ${empty.toFixed(0)} MB of an empty page; load ${loadavg()[0].toFixed(1)}`);
await browser.close();
await server.close();
site.close();
