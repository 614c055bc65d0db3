// The page for spectators in Chromium: while a tournament in stages is played, on a projector, a laptop and a telephone. Played by the
// built cls: $CLS, or build/bin/cls. CLS_SCREENSHOTS names a folder for pictures.
import assert from 'node:assert/strict';
import {spawn, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {fileURLToPath} from 'node:url';
import {accessibilityViolations, launch, openPage} from './browser.mjs';

const kCls = process.env.CLS ?? fileURLToPath(new URL('../../../build/bin/cls', import.meta.url));
const kSkip = fs.existsSync(kCls) ? false : `no ${kCls}; build it or set CLS`;
const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-spectators-'));
const kSizes = {projector: [1920, 1080], laptop: [1366, 768], telephone: [390, 844]};
const kName = '<b>Fußball & サッカー</b>';

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

/** Teams whose names are as wide as a team may be called. */
function teams(count) {
  const names = ['WWWWWWWWWWWWWWW', 'Grossroehrsdorf', 'A'];
  return Array.from({length: count}, (_, i) => `[teams."${names[i] ?? `TEAM${i + 1}`}"]\nendpoint = "mock${i % 3 ? ':hold' : ''}"\n`).join('');
}

function writeCup(folder, count) {
  const made = spawnSync(kCls, ['init', folder, '--preset', 'robocup'], {cwd: kFolder});
  assert.equal(made.status, 0, String(made.stderr));
  const file = path.join(kFolder, folder, 'cls.toml');
  const text = fs.readFileSync(file, 'utf8').replace(/\[teams[^]*/, '').replace('format = "stages"', `name = "${kName}"\nformat = "stages"`);
  fs.writeFileSync(file, text.replace('divisions = [4, 4]', `divisions = [${Array(count / 4).fill(4).join(', ')}]`) + teams(count));
}

const run = (folder, mode, ...more) => start('tournament', 'run', folder, '--quiet', '--no-preflight', '--concurrency', '2', '--mode', mode, ...more);

/** Names of running matches that stand on more than one line, if all are 15 usual letters long and the scores have two digits. */
function brokenNames(page) {
  return page.evaluate(() => {
    const names = [...document.querySelectorAll('.card .name')].map((each) => each.lastChild);
    const scores = [...document.querySelectorAll('.card .score')];
    const before = [...names, ...scores].map((each) => each.textContent);
    for (const name of names) name.textContent = 'Grossroehrsdorf';
    for (const score of scores) score.textContent = '10 : 12';
    const broken = names.filter((each) => {
      const range = document.createRange();
      range.selectNodeContents(each);
      return new Set([...range.getClientRects()].map((rect) => Math.round(rect.top))).size > 1;
    });
    const shown = broken.map((each) => `${each.textContent} in ${each.parentElement.parentElement.clientWidth} px`);
    [...names, ...scores].forEach((each, i) => { each.textContent = before[i]; });
    return shown;
  });
}

/** Opens the page at each size in both themes: nothing is wider than the window, and axe finds nothing. */
async function checkSizes(url, name) {
  for (const [size, [width, height]] of Object.entries(kSizes)) {
    for (const colorScheme of ['light', 'dark']) {
      const {page, problems, context} = await openPage(browser, url, /^http:\/\/127\.0\.0\.1:/, {viewport: {width, height}, colorScheme});
      await page.waitForTimeout(1500);
      assert.deepEqual(await brokenNames(page), [], `${name}, ${size}: names broken inside`);
      const [wide, cut] = await page.evaluate(() => {
        const {scrollWidth, clientWidth} = document.documentElement;
        const cut = [...document.querySelectorAll('.name, h1, h2, .score')].filter((each) => each.scrollWidth > each.clientWidth + 1 && each.clientWidth > 0);
        return [scrollWidth - clientWidth, cut.map((each) => each.textContent)];
      });
      assert.ok(wide <= 0, `${name}, ${size}: ${wide} pixels too wide`);
      assert.deepEqual(cut, [], `${name}, ${size}: cut texts`);
      assert.deepEqual(await accessibilityViolations(page), [], `${name}, ${size}, ${colorScheme}`);
      assert.deepEqual(await page.evaluate(() => window.violations), []);
      assert.deepEqual(problems, []);
      if (process.env.CLS_SCREENSHOTS) {
        await page.screenshot({path: path.join(process.env.CLS_SCREENSHOTS, `spectators-${name}-${size}-${colorScheme}.png`)});
      }
      await context.close();
    }
  }
}

before(async () => {
  if (!kSkip) browser = await launch();
});

after(async () => {
  await browser?.close();
  for (const process of processes) process.kill('SIGTERM');
  await new Promise((resolve) => setTimeout(resolve, 1000));
  fs.rmSync(kFolder, {recursive: true, force: true});
});

/** A cup of which two matches are played now, and the page of it. `halfTime`: seconds. */
async function runningCup(folder, count, halfTime = 20) {
  writeCup(folder, count);
  const played = run(folder, 'lockstep', '--set', `server::half_time=${halfTime}`);
  played.stdout.resume();
  const ended = new Promise((resolve) => played.on('exit', resolve));
  const url = await (async () => {
    while (!fs.existsSync(path.join(kFolder, folder, 'plan.toml'))) await new Promise((resolve) => setTimeout(resolve, 20));
    return firstLine(start('tournament', 'watch', folder, '--port', '0'));
  })();
  return {url, ended, played};
}

for (const count of [8, 24]) {
  test(`${count} teams fit on a projector, a laptop and a telephone`, {skip: kSkip}, async () => {
    const {url, played} = await runningCup(`cup${count}`, count);
    const {page, problems, context} = await openPage(browser, url, /^http:\/\/127\.0\.0\.1:/);
    await page.evaluate(() => (window.sameDocument = true));
    await page.waitForFunction(() => document.querySelectorAll('.card .pitch circle').length >= 23 && document.querySelectorAll('#results .matches li').length >= 3, null, {timeout: 60000});
    assert.equal(await page.evaluate(() => window.sameDocument), true);
    assert.equal(await page.locator('h1').innerText(), kName);
    assert.equal(await page.locator('b').count(), 0);
    // A list that the reader has closed stays closed, although results arrive.
    await page.locator('#results summary').first().click();
    const played_ = () => page.locator('#status').innerText();
    const before_ = await played_();
    await page.waitForFunction((text) => document.getElementById('status').textContent !== text, before_, {timeout: 60000});
    assert.equal(await page.locator('#results details[open]').count(), 0);
    assert.deepEqual(problems, []);
    await context.close();
    await checkSizes(url, `${count}-teams`);
    played.kill('SIGTERM');
  });
}

test('a running match opens live, a played one as a replay, and both lead back', {skip: kSkip}, async () => {
  const {url, played} = await runningCup('live', 8);
  const {page, problems, context} = await openPage(browser, url, /^http:\/\/127\.0\.0\.1:/);
  await page.locator('a.card').first().waitFor();
  const live = await page.locator('a.card').first().getAttribute('href');
  await page.goto(new URL(live, url).href);
  await page.waitForFunction(() => window.clsViewer?.viewer.record.frames > 0, null, {timeout: 60000});
  await page.getByRole('link', {name: 'All matches'}).click();
  await page.locator('#results .matches a').first().click();
  await page.waitForFunction(() => window.clsViewer, null, {timeout: 60000});
  await page.getByRole('link', {name: 'All matches'}).click();
  assert.equal(page.url(), url);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  assert.deepEqual(problems, []);
  await context.close();
  played.kill('SIGTERM');
});

test('a tournament that is over shows its bracket and its winner', {skip: kSkip}, async () => {
  const {url, ended} = await runningCup('over', 4, 2);
  await ended;
  await new Promise((resolve) => setTimeout(resolve, 2500));
  const {page, context} = await openPage(browser, url, /^http:\/\/127\.0\.0\.1:/);
  assert.match(await page.locator('#status').innerText(), /^(\d+) of \1 matches played$/);
  assert.equal(await page.locator('#bracket .won').count() > 0, true);
  assert.match(await page.locator('#statistics').innerText(), /goals a match/);
  await context.close();
  await checkSizes(url, 'over');
});
