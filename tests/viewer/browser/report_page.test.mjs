// Reports of a match and of a tournament in Chromium, from disk. They are played by the built cls: $CLS, or build/bin/cls.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {accessibilityViolations, launch, openPage} from './browser.mjs';

const kCls = process.env.CLS ?? fileURLToPath(new URL('../../../build/bin/cls', import.meta.url));
const kSkip = fs.existsSync(kCls) ? false : `no ${kCls}; build it or set CLS`;
const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-reports-'));
const kViews = [{colorScheme: 'light'}, {colorScheme: 'dark'}, {viewport: {width: 360, height: 800}}, {viewport: {width: 390, height: 844}},
  {viewport: {width: 1280, height: 800}}, {viewport: {width: 1920, height: 1080}}];

const kTournament = `[tournament]
name = "<b>cup</b>"
rounds = 3
[server]
half_time = 10
nr_normal_halfs = 1
[teams.A]
endpoint = "mock"
[teams.B]
endpoint = "mock:hold"
`;

let browser;

const cls = (...words) => execFileSync(kCls, words, {cwd: kFolder, stdio: ['ignore', 'ignore', 'inherit']});

before(async () => {
  if (kSkip) return;
  cls('match', 'mock', 'mock:hold', '--seed', '7', '--cycles', '400', '--quiet', '--dir', 'match');
  cls('report', 'match', '--out', 'match.html');
  fs.mkdirSync(path.join(kFolder, 'cup'));
  fs.writeFileSync(path.join(kFolder, 'cup/cls.toml'), kTournament);
  cls('tournament', 'run', 'cup', '--quiet');
  cls('tournament', 'report', 'cup', '--format', 'html', '--out', 'cup.html');
  browser = await launch();
});

after(async () => {
  await browser?.close();
  fs.rmSync(kFolder, {recursive: true, force: true});
});

const open = (file, options) => openPage(browser, pathToFileURL(path.join(kFolder, file)).href, /^(file|blob|data|about):/, options);

for (const file of ['match.html', 'cup.html']) {
  test(`${file} has no accessibility violations and loads nothing`, {skip: kSkip}, async () => {
    for (const options of kViews) {
      const {page, problems, context} = await open(file, options);
      assert.deepEqual(await accessibilityViolations(page, {iframes: false}), []);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      assert.ok(overflow <= 0, `${overflow} px wider than the window`);
      const smallest = await page.evaluate(() => Math.min(...[...document.querySelectorAll('svg text')].map((text) => Number.parseFloat(window.getComputedStyle(text).fontSize) * text.getScreenCTM().a)));
      assert.ok(smallest >= 9, `text of ${smallest.toFixed(1)} px in a chart`);
      const cut = await page.evaluate(() => (window.innerWidth < 600 ? 0 : [...document.querySelectorAll('.chart-box')].filter((box) => box.scrollWidth > box.clientWidth).length));
      assert.equal(cut, 0, `charts that are wider than their column, ${JSON.stringify(options)}`);
      assert.deepEqual(problems, []);
      await context.close();
    }
  });
}

/** In the page: mean errors of the player in play_on, of itself and of the ball when it was just seen. */
function shownErrors() {
  const {track, record} = window.clsViewer.viewer;
  const sums = {self: [], ball: []};
  for (let i = 0; i < track.decisions.count; ++i) {
    if (record.modeName(track.frames[i]) !== 'play_on') continue;
    sums.self.push(track.selfErrors[i]);
    if (track.ballRow(i).age === 0) sums.ball.push(track.ballErrors[i]);
  }
  const summary = (errors) => ({n: errors.length, mean: errors.reduce((sum, error) => sum + error, 0) / errors.length});
  return {self: summary(sums.self), ball: summary(sums.ball)};
}

test('the debugger shows the errors that cls check perception measures', {skip: kSkip}, async () => {
  const fixture = (name) => fileURLToPath(new URL(`../../../fixtures/perception/${name}`, import.meta.url));
  const words = ['check', 'perception', fixture('player_7.txt.gz'), '--truth', fixture('game.rcg.gz'), '--page', 'perception.html', '--json'];
  // The log of the fixture has no end, so cls warns.
  const measured = JSON.parse(spawnSync(kCls, words, {cwd: kFolder, encoding: 'utf8'}).stdout);
  const {page, problems, context} = await open('perception.html', {});
  await page.waitForFunction(() => window.clsViewer, null, {timeout: 60000});
  await page.keyboard.press('Shift+P');
  await page.waitForFunction(() => window.clsViewer.viewer.track);
  const shown = await page.evaluate(shownErrors);
  for (const what of ['self', 'ball']) {
    assert.equal(shown[what].n, measured[what].n, what);
    assert.ok(Math.abs(shown[what].mean - measured[what].mean) < 0.01, `${what}: ${shown[what].mean} m shown, ${measured[what].mean} m measured`);
  }
  // The panel shows the error of a moment, the field a ghost at the estimate.
  await page.evaluate(() => window.clsViewer.viewer.seek(window.clsViewer.viewer.track.frames[60]));
  await page.waitForTimeout(100);
  const row = await page.locator('.estimates tbody tr').nth(1).locator('td').allInnerTexts();
  const error = await page.evaluate(() => window.clsViewer.viewer.track.ballErrors[60]);
  assert.equal(row[2], Number.isNaN(error) ? '' : error.toFixed(2));
  assert.deepEqual(problems, []);
  await context.close();
});

test('cup.html charts goal differences, and shows names as text', {skip: kSkip}, async () => {
  const {page, context} = await open('cup.html', {});
  assert.equal(await page.getByRole('img', {name: 'Goals of A minus those of B', exact: true}).count(), 1);
  assert.equal(await page.locator('b').count(), 0);
  await context.close();
});
