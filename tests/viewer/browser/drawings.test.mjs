// Texts and drawings of Playmakers in Chromium, without recorded decisions: in a replay, in a running match, and where there are none.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';
import {kShownFrame, sampleDebugLog} from '../web/sample_drawings.mjs';
import {liveSamplePieces, sampleStream} from '../web/sample_match.mjs';
import {accessibilityViolations, launch, openPage} from './browser.mjs';
import {kInjections} from './injections.mjs';
import {pageOf} from './page_writer.mjs';

const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-drawings-'));

let browser;

before(async () => {
  browser = await launch();
});

after(async () => {
  await browser?.close();
  fs.rmSync(kFolder, {recursive: true, force: true});
});

async function open({hash = '', drawings = {left: sampleDebugLog()}, ...options} = {}) {
  const file = path.join(kFolder, 'page.html');
  fs.writeFileSync(file, pageOf(sampleStream(), {}, {}, drawings));
  const opened = await openPage(browser, pathToFileURL(file).href + hash, /^(file|blob):/, options);
  await opened.page.waitForFunction(() => window.clsViewer, null, {timeout: 120000});
  if (Object.keys(drawings).length > 0) await opened.page.waitForFunction(() => !window.clsViewer.viewer.teamDrawings.empty);
  return opened;
}

/** Whether the field is red inside the circle of player 7. */
const red = (page) => page.evaluate(() => {
  const {viewer, page} = window.clsViewer;
  page.draw();
  const data = page.canvas.getContext('2d').getImageData(Math.round(viewer.camera.screenX(13)), Math.round(viewer.camera.screenY(5)), 1, 1).data;
  return data[0] > 200 && data[1] < 90 && data[2] < 90;
});

test('shows what all players or the selected ones drew, on the field and as a list', async () => {
  const {page, problems, context} = await open({hash: `#t=${kShownFrame}`});
  assert.equal(await red(page), true);
  await page.getByRole('tab', {name: 'Drawings'}).click();
  const list = page.locator('.drawings li');
  assert.deepEqual(await list.evaluateAll((rows) => rows.map((row) => [...row.children].map((part) => part.textContent).join('|'))),
    ['l7|team|pass to 9', 'l7|shoot|filled circle, #ff0000', 'l9|action chain|run here']);
  await page.getByLabel('Filter texts and drawings').fill('run');
  assert.equal(await list.count(), 1);
  assert.equal(await red(page), false);
  await page.getByLabel('Filter texts and drawings').fill('');
  assert.equal(await red(page), true);
  await page.locator('.field').focus().catch(() => {});
  await page.evaluate(() => window.clsViewer.viewer.select(8));
  assert.equal(await red(page), false);
  await page.getByRole('tab', {name: 'Drawings'}).click();
  assert.equal(await list.count(), 1);
  await page.evaluate(() => window.clsViewer.viewer.select(-1));
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('Shift+A');
  assert.equal(await red(page), false);
  await page.getByRole('button', {name: 'Later'}).click();
  assert.equal(await page.evaluate(() => window.clsViewer.viewer.frame), 107);
  await page.getByText('12 more were left out').waitFor();
  assert.deepEqual(problems.filter((each) => !each.includes('willReadFrequently')), []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await context.close();
});

test('says what is missing, where everyone sees it', async () => {
  const {page, problems, context} = await open({drawings: {}});
  await page.getByRole('tab', {name: 'Drawings'}).click();
  await page.getByText('This page has no texts or drawings').waitFor();
  await page.getByText('cls explain log').waitFor();
  for (const [key, text] of [['Shift+A', 'no texts or drawings'], ['Shift+P', '--record-world-models'], ['Shift+M', 'No later event'], ['Shift+N', 'The match is over']]) {
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press(key);
    assert.match(await page.locator('.brief').innerText(), new RegExp(text));
    assert.match(await page.locator('p[role=status]').innerText(), new RegExp(text));
  }
  assert.deepEqual(problems, []);
  await context.close();
});

test('follows those of a running match', async () => {
  const pieces = liveSamplePieces(10);
  const log = Buffer.from(sampleDebugLog());
  let there = 0;
  const server = http.createServer((request, response) => {
    const drawings = /^\/drawings-(left|right)\?from=(\d+)$/.exec(request.url);
    if (request.url === '/') return response.setHeader('Content-Type', 'text/html; charset=utf-8').end(pageOf(null, {live: 'live', drawings: 'drawings'}));
    if (request.url === '/live?from=0') return response.write(Buffer.concat(pieces.slice(0, 7)));
    if (drawings) return response.end(drawings[1] === 'left' ? log.subarray(Number(drawings[2]), there) : '');
    return response.writeHead(404).end();
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const {page, problems, context} = await openPage(browser, `http://127.0.0.1:${server.address().port}/#t=${kShownFrame}`, /./);
  await page.waitForFunction(() => window.clsViewer?.viewer.record.frames === 70);
  assert.equal(await red(page), false);
  there = 200;
  await page.waitForFunction(() => !window.clsViewer.viewer.teamDrawings.empty);
  there = log.length;
  await page.waitForFunction(() => window.clsViewer.viewer.teamDrawings.moments.size === 3);
  assert.equal(await red(page), true);
  assert.deepEqual(problems.filter((each) => !each.includes('willReadFrequently')), []);
  await context.close();
  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
});

test('makes no markup out of them, and is accessible', async () => {
  const texts = kInjections.filter((each) => each.length < 2000);
  const {page, problems, context} = await open({hash: `#t=${kShownFrame}`, drawings: {left: texts.map((text) => sampleDebugLog(text)).join('')}});
  await page.getByRole('tab', {name: 'Drawings'}).click();
  assert.equal(await page.locator('.drawings li').count(), 3 * texts.length);
  assert.equal(await page.evaluate(() => document.querySelectorAll('.drawings script, .drawings img, .drawings iframe, .drawings svg').length), 0);
  assert.equal(await page.evaluate(() => window.injected), undefined);
  assert.deepEqual(problems, []);
  await context.close();
  for (const options of [{}, {colorScheme: 'light'}, {viewport: {width: 320, height: 800}}]) {
    const narrow = await open({hash: `#t=${kShownFrame}`, ...options});
    await narrow.page.getByRole('tab', {name: 'Drawings'}).click();
    assert.deepEqual(await accessibilityViolations(narrow.page), []);
    const overflow = await narrow.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    await narrow.context.close();
  }
});
