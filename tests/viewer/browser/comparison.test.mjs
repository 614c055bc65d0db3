// Two matches side by side in Chromium, from disk.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';
import zlib from 'node:zlib';
import {kShownFrame, sampleDebugLog} from '../web/sample_drawings.mjs';
import {kGoalFrame, sampleStream} from '../web/sample_match.mjs';
import {accessibilityViolations, launch, openPage} from './browser.mjs';
import {kInjections} from './injections.mjs';
import {pageOf} from './page_writer.mjs';

const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-comparison-'));

let browser;

before(async () => {
  browser = await launch();
});

after(async () => {
  await browser?.close();
  fs.rmSync(kFolder, {recursive: true, force: true});
});

const kDifferences = {
  names: ['before', 'after'],
  first: {frame: 42, text: 'cycle 42 (frame 42): ball position'},
  events: [{match: 1, cycle: kGoalFrame, text: 'goal, left 9'}],
  columns: ['', 'left A', 'left B', 'B - A'],
  rows: [['goals', '1', '2', '+1']],
};

function write(differences) {
  const data = zlib.gzipSync(sampleStream({names: ['Crimson', 'Cobalt']})).toString('base64');
  const json = JSON.stringify(differences).replaceAll('<', '\\u003c');
  const shown = (lines) => zlib.gzipSync(lines).toString('base64');
  const drawings = {'drawings-left': shown(sampleDebugLog()), 'other-drawings-left': shown(sampleDebugLog('').replaceAll('#ff0000', '#0000ff'))};
  const elements = Object.entries(drawings).map(([id, text]) => `<script type="application/cls-drawings;base64" id="${id}" data-length="${text.length}">${text}</script>\n`).join('');
  const more = `${elements}<script type="application/cls-view;base64" id="other" data-length="${data.length}">${data}</script>
<script type="application/json" id="differences">${json}</script></body>`;
  const file = path.join(kFolder, 'compare.html');
  fs.writeFileSync(file, pageOf(sampleStream(), {compared: true}).replace('</body>', () => more));
  return file;
}

async function open(differences = kDifferences, options = {}) {
  const opened = await openPage(browser, pathToFileURL(write(differences)).href, /^(file|blob):/, {viewport: {width: 1280, height: 900}, ...options});
  await opened.page.waitForFunction(() => window.clsComparison || document.querySelector('[role=alert]'), null, {timeout: 120000});
  return opened;
}

const momentOf = (page) => page.evaluate(() => window.clsComparison.clock.frame);

test('shows both matches, their difference and jumps to it', async () => {
  const {page, problems, context} = await open();
  for (const name of ['Azure', 'Crimson', 'A: before', 'B: after', 'cycle 42 (frame 42): ball position']) {
    assert.ok((await page.getByText(name).count()) > 0, name);
  }
  await page.getByRole('button', {name: 'Show it'}).click();
  assert.equal(await momentOf(page), 42);
  await page.getByRole('button', {name: /goal, left 9/}).click();
  assert.equal(await momentOf(page), kGoalFrame);
  assert.deepEqual(await page.locator('.findings tbody td').allTextContents(), ['1', '2', '+1']);
  assert.deepEqual(problems, []);
  await context.close();
});

test('draws what the Playmakers of each match show', async () => {
  const {page, context} = await open();
  await page.waitForFunction(() => window.clsComparison.sides.every(({store}) => !store.empty));
  const colors = await page.evaluate((moment) => {
    window.clsComparison.seek(moment);
    window.clsComparison.draw();
    return window.clsComparison.sides.map(({canvas, renderer}) => [...canvas.getContext('2d').getImageData(Math.round(renderer.camera.screenX(13)), Math.round(renderer.camera.screenY(5)), 1, 1).data]);
  }, kShownFrame);
  assert.ok(colors[0][0] > 150 && colors[0][2] < 90, `${colors[0]}`);
  assert.ok(colors[1][2] > 150 && colors[1][0] < 90, `${colors[1]}`);
  await context.close();
});

test('has keys, and one clock for both', async () => {
  const {page, context} = await open();
  for (const [key, moment] of [['ArrowRight', 1], ['Shift+ArrowRight', 11], ['ArrowLeft', 10], ['End', 299], ['Home', 0]]) {
    await page.keyboard.press(key);
    assert.equal(await momentOf(page), moment, key);
  }
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.clsComparison.clock.frame > 2);
  await page.keyboard.press('Space');
  const clocks = await page.locator('.clock-cycle').allTextContents();
  assert.equal(clocks[0], clocks[1]);
  await context.close();
});

test('says that all frames are equal', async () => {
  const {page, context} = await open({...kDifferences, first: null, events: []});
  assert.ok(await page.getByText('All frames are equal').isVisible());
  assert.equal(await page.getByRole('button', {name: 'Show it'}).count(), 0);
  await context.close();
});

test('shows names as text', async () => {
  for (const name of kInjections.slice(0, 12)) {
    const {page, context} = await open({...kDifferences, names: [name, name], events: [{match: 0, cycle: 1, text: name}], rows: [[name, '1', '2', '3']]});
    assert.equal(await page.evaluate(() => document.querySelectorAll('#app img, #app script, #app iframe').length), 0, name);
    assert.equal(await page.evaluate(() => window.injected), undefined, name);
    await context.close();
  }
});

test('has no accessibility violations', async () => {
  for (const options of [{}, {colorScheme: 'light'}, {viewport: {width: 360, height: 800}}]) {
    const {page, context} = await open(kDifferences, options);
    assert.deepEqual(await accessibilityViolations(page), []);
    await context.close();
  }
});
