// The page of a running match in Chromium: it follows, goes back, returns, and survives its server. CLS_LIVE_URL names
// the page of a match that `cls` serves, to look at as well; CLS_SCREENSHOTS a folder for pictures.
import assert from 'node:assert/strict';
import http from 'node:http';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {kFrames, kGoalFrame, liveSamplePieces} from '../web/sample_match.mjs';
import {accessibilityViolations, launch, openPage, toolbarLayout} from './browser.mjs';
import {pageOf} from './page_writer.mjs';

const kPieceFrames = 10;

let browser;

before(async () => {
  browser = await launch();
});

after(() => browser?.close());

/** Serves a page and its stream as cls does; the test decides when bytes come. */
class Match {
  constructor(early = false) {
    this.bytes = Buffer.alloc(0);
    this.pieces = liveSamplePieces(kPieceFrames, early);
    this.readers = new Set();
    this.requests = [];
  }

  async listen(port = 0) {
    this.server = http.createServer((request, response) => this.#answer(request, response));
    await new Promise((resolve) => this.server.listen(port, '127.0.0.1', resolve));
    this.port = this.server.address().port;
    this.url = `http://127.0.0.1:${this.port}/token/`;
  }

  #answer(request, response) {
    this.requests.push(request.url);
    const from = /^\/token\/live\?from=(\d+)$/.exec(request.url);
    if (request.url === '/token/') return response.setHeader('Content-Type', 'text/html; charset=utf-8').end(pageOf(null, {live: 'live'}));
    if (!from) return response.writeHead(404).end();
    response.write(this.bytes.subarray(Number(from[1])));
    this.readers.add(response);
    if (this.pieces.length === 0) response.end();
  }

  /** The next frames are played. */
  play(pieces = 1) {
    for (const piece of this.pieces.splice(0, pieces)) {
      this.bytes = Buffer.concat([this.bytes, piece]);
      for (const reader of this.readers) reader.write(piece);
    }
    if (this.pieces.length === 0) for (const reader of this.readers) reader.end();
  }

  async stop() {
    this.server.closeAllConnections();
    this.readers.clear();
    await new Promise((resolve) => this.server.close(resolve));
  }
}

const open = (url, options = {}) => openPage(browser, url, /./, options);

const frameOf = (page) => page.evaluate(() => window.clsViewer?.viewer.frame ?? -1);
const shows = (page, frame) => page.waitForFunction((wanted) => window.clsViewer?.viewer.frame === wanted, frame);
const live = (page) => page.getByRole('button', {name: /^Live/});

/** A match of which `pieces` are played, and a page that follows it. */
async function following(pieces, early = false) {
  const match = new Match(early);
  await match.listen();
  match.play(pieces);
  const opened = await open(match.url);
  await shows(opened.page, pieces * kPieceFrames - 1);
  return {match, ...opened};
}

test('waits for the first frame, then shows each as it comes', async () => {
  const match = new Match();
  await match.listen();
  const {page, problems, context} = await open(match.url);
  await page.getByText('Waiting for the kick-off').waitFor();
  assert.equal(await page.getByRole('heading', {level: 1}).textContent(), await page.title());
  for (const pieces of [1, 2, 3]) {
    match.play(1);
    await shows(page, pieces * kPieceFrames - 1);
  }
  assert.equal(await live(page).getAttribute('aria-pressed'), 'true');
  assert.deepEqual(problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await context.close();
  await match.stop();
});

test('goes back while the match continues, and returns to it', async () => {
  const {match, page, problems, context} = await following(5);
  await page.keyboard.press('ArrowLeft');
  const before = await frameOf(page);
  assert.equal(before, 48);
  match.play(2);
  await page.waitForFunction(() => window.clsViewer.viewer.record.frames === 70);
  assert.equal(await frameOf(page), before);
  assert.equal(await live(page).getAttribute('aria-pressed'), 'false');
  await live(page).click();
  await shows(page, 69);
  await page.keyboard.press('Home');
  assert.equal(await frameOf(page), 0);
  await page.keyboard.press('Shift+N');
  await shows(page, 69);
  match.play(1);
  await shows(page, 79);
  assert.deepEqual(problems, []);
  await context.close();
  await match.stop();
});

test('the button LIVE leaves the toolbar in one row', async () => {
  const {match, page, context} = await following(3);
  const {outside, rows} = await toolbarLayout(page, [320, 390, 1280, 1366, 1440, 1920]);
  assert.deepEqual(outside, []);
  for (const width of [1280, 1366, 1440, 1920]) assert.equal(rows[width], 1, `${rows[width]} rows at ${width}`);
  await context.close();
  await match.stop();
});

test('a replay that reaches the present follows the match', async () => {
  const {match, page, context} = await following(3);
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.clsViewer.viewer.clock.following);
  match.play(1);
  await shows(page, 39);
  await context.close();
  await match.stop();
});

test('the time axis has room for the rest of the match', async () => {
  const {match, page, context} = await following(5);
  const box = await page.locator('.timeline').boundingBox();
  const x = await page.evaluate(() => window.clsViewer.page.timeline.xOf(49));
  assert.ok(x < box.width * 0.02, `${x}`);
  await page.mouse.click(box.x + box.width * 0.5, box.y + 30);
  assert.equal(await frameOf(page), 49);
  await context.close();
  await match.stop();
});

test('counts goals as they fall, and has statistics at the end', async () => {
  const {match, page, problems, context} = await following(9);
  await page.getByRole('tab', {name: 'Events'}).click();
  await page.getByText('No goals, shots, cards or missed decisions.').waitFor();
  match.play(2);
  await page.getByRole('button', {name: /Goal: Azure/}).waitFor();
  match.play(kFrames / kPieceFrames + 1);
  await shows(page, kFrames - 1);
  await live(page).waitFor({state: 'hidden'});
  await page.getByRole('button', {name: /Goal: Azure 10/}).click();
  assert.equal(await frameOf(page), kGoalFrame);
  await page.getByRole('tab', {name: 'Match'}).click();
  await page.getByText('Expected goals').waitFor();
  assert.equal(await page.evaluate(() => window.clsViewer.viewer.clock.playing), false);
  assert.deepEqual(problems, []);
  await context.close();
  await match.stop();
});

test('has statistics while the match is played, and goals that came after them', async () => {
  const {match, page, problems, context} = await following(2, true);
  await page.getByRole('columnheader', {name: 'So far'}).waitFor();
  match.play(9);
  await shows(page, 109);
  await page.getByRole('tab', {name: 'Events'}).click();
  await page.getByRole('button', {name: /Goal: Azure/}).waitFor();
  match.play(kFrames / kPieceFrames + 1);
  await page.getByRole('button', {name: /Goal: Azure 10/}).waitFor();
  assert.equal(await page.getByRole('button', {name: /Goal:/}).count(), 1);
  await page.getByRole('tab', {name: 'Match'}).click();
  await page.getByRole('columnheader', {name: 'Whole match'}).waitFor();
  assert.deepEqual(problems, []);
  await context.close();
  await match.stop();
});

test('says that the server is gone, stays usable, and continues where it was', async () => {
  const {match, page, context} = await following(4);
  const before = match.bytes.length;
  await match.stop();
  await page.locator('.notice').waitFor();
  assert.equal(await page.locator('.notice').textContent(), 'No connection to cls; trying again');
  await page.keyboard.press('Home');
  assert.equal(await frameOf(page), 0);
  await match.listen(match.port);
  match.requests = [];
  match.play(1);
  await page.waitForFunction(() => window.clsViewer.viewer.record.frames === 50);
  await page.locator('.notice').waitFor({state: 'hidden'});
  assert.deepEqual(match.requests, [`/token/live?from=${before}`]);
  await context.close();
  await match.stop();
});

test('a reload follows again, a link goes to its moment', async () => {
  const {match, page, context} = await following(4);
  await page.waitForTimeout(600);
  assert.equal(await page.evaluate(() => window.location.hash), '');
  await page.goto(`${match.url}#t=12`);
  await page.reload();
  await shows(page, 12);
  await context.close();
  await match.stop();
});

test('a late reader gets the whole match', async () => {
  const match = new Match();
  await match.listen();
  match.play(kFrames / kPieceFrames + 1);
  const {page, problems, context} = await open(match.url);
  await page.waitForFunction((frames) => window.clsViewer?.viewer.record.frames === frames, kFrames);
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.clsViewer.viewer.frame > 0);
  assert.deepEqual(problems, []);
  await context.close();
  await match.stop();
});

test('names a corrupt stream', async () => {
  const match = new Match();
  match.pieces[0][0] = 'F'.charCodeAt(0);
  await match.listen();
  match.play(2);
  const {page, context} = await open(match.url);
  await page.getByText('the data starts without a header').waitFor();
  await context.close();
  await match.stop();
});

test('axe finds no accessibility violations while the page follows', async () => {
  const {match, page, context} = await following(12);
  for (const colorScheme of ['dark', 'light']) {
    await page.emulateMedia({colorScheme});
    assert.deepEqual(await accessibilityViolations(page), []);
  }
  if (process.env.CLS_SCREENSHOTS) await page.screenshot({path: path.join(process.env.CLS_SCREENSHOTS, 'live.png')});
  await context.close();
  await match.stop();
});

test('a match that cls plays advances', {skip: process.env.CLS_LIVE_URL ? false : 'CLS_LIVE_URL names no page'}, async () => {
  const {page, problems, context} = await open(process.env.CLS_LIVE_URL);
  await page.waitForFunction(() => window.clsViewer?.viewer.clock.following);
  const before = await frameOf(page);
  await page.waitForFunction((frame) => window.clsViewer.viewer.frame > frame + 20, before);
  if (process.env.CLS_SCREENSHOTS) await page.screenshot({path: path.join(process.env.CLS_SCREENSHOTS, 'live-cls.png')});
  assert.deepEqual(problems, []);
  await context.close();
});
