// The live page of a tournament in Chromium: matches arrive without a reload, and nothing moves. Played by the built cls: $CLS, or
// build/bin/cls. CLS_SCREENSHOTS names a folder for pictures.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {fileURLToPath} from 'node:url';
import {accessibilityViolations, launch, openPage} from './browser.mjs';

const kCls = process.env.CLS ?? fileURLToPath(new URL('../../../build/bin/cls', import.meta.url));
const kSkip = fs.existsSync(kCls) ? false : `no ${kCls}; build it or set CLS`;
const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-cup-'));
const kMatches = 6;
const kConfig = `[tournament]
name = "<b>cup</b>"
rounds = 1
[server]
half_time = 120
nr_normal_halfs = 1
[teams."A"]
endpoint = "mock"
[teams."B"]
endpoint = "mock:hold"
[teams."C"]
endpoint = "mock:hold"
`;

let browser;
const processes = [];

function start(...words) {
  const process = spawn(kCls, words, {cwd: kFolder, stdio: ['ignore', 'pipe', 'inherit']});
  processes.push(process);
  return process;
}

/** The first line that a process prints. */
function firstLine(process) {
  return new Promise((resolve, reject) => {
    let text = '';
    process.stdout.on('data', (data) => {
      text += data;
      if (text.includes('\n')) resolve(text.slice(0, text.indexOf('\n')));
    });
    process.on('exit', (code) => reject(new Error(`cls ended with ${code}: ${text}`)));
  });
}

async function exists(file) {
  while (!fs.existsSync(file)) await new Promise((resolve) => setTimeout(resolve, 20));
}

before(async () => {
  if (kSkip) return;
  fs.mkdirSync(path.join(kFolder, 'cup'));
  fs.writeFileSync(path.join(kFolder, 'cup/cls.toml'), kConfig);
  browser = await launch();
});

after(async () => {
  await browser?.close();
  for (const process of processes) process.kill('SIGTERM');
  fs.rmSync(kFolder, {recursive: true, force: true});
});

test('matches arrive without a reload, and nothing moves', {skip: kSkip}, async (t) => {
  const run = start('tournament', 'run', 'cup', '--quiet', '--no-preflight', '--concurrency', '1');
  run.stdout.resume();
  await exists(path.join(kFolder, 'cup/plan.toml'));
  const url = await firstLine(start('watch', 'cup', '--no-open', '--linger', '120'));
  const {page, problems, context} = await openPage(browser, url, /^http:\/\/127\.0\.0\.1:/);
  await page.evaluate(() => {
    window.sameDocument = true;
    window.shifts = 0;
    new PerformanceObserver((list) => list.getEntries().forEach((entry) => (window.shifts += entry.value))).observe({type: 'layout-shift', buffered: true});
  });
  assert.equal(await page.locator('b').count(), 0);
  assert.equal(await page.locator('h1').innerText(), '<b>cup</b>');
  const seen = new Set();
  const scores = page.locator('table').last().locator('td.score');
  const isOver = async () => (await page.locator('#status').innerText()).startsWith(`${kMatches} of ${kMatches} matches done`);
  while (!(await isOver())) {
    (await page.locator('td.state').allInnerTexts()).forEach((text) => seen.add(text.replace(/\d+/, 'N').trim()));
    if (process.env.CLS_SCREENSHOTS && (await page.locator('td.state svg').count()) > 0) {
      await page.screenshot({path: path.join(process.env.CLS_SCREENSHOTS, 'tournament.png')});
    }
    await page.waitForTimeout(50);
  }
  for (const score of await scores.allInnerTexts()) assert.match(score, /^\d+ : \d+$/);
  assert.ok(seen.has('cycle N') && seen.has('planned'), [...seen].join(', '));
  assert.ok([...seen].every((text) => text !== ''), [...seen].join(', '));
  assert.deepEqual([...new Set(await page.locator('td.state').allInnerTexts())], ['finished']);
  const glance = await page.getByRole('table', {name: 'at a glance'}).innerText();
  for (const fact of ['winner\tA', `matches done\t${kMatches} of ${kMatches}`, 'played now\t0', 'still to play\t0', 'goals a match\t']) assert.ok(glance.includes(fact), glance);
  const standings = await page.locator('.standings table').innerText();
  assert.match(standings, /A/);
  const [same, shifts] = await page.evaluate(() => [window.sameDocument, window.shifts]);
  assert.equal(same, true);
  t.diagnostic(`layout shift ${shifts.toFixed(4)}`);
  assert.ok(shifts < 0.01, `layout shift ${shifts}`);
  for (const colorScheme of ['dark', 'light']) {
    await page.emulateMedia({colorScheme});
    assert.deepEqual(await accessibilityViolations(page), []);
  }
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  // A finished match opens as a replay.
  await page.getByRole('link', {name: 'replay of match 1', exact: true}).click();
  await page.waitForFunction(() => window.clsViewer, null, {timeout: 60000});
  assert.deepEqual(problems, []);
  await context.close();
});
