// The first contact: a match within seconds, with the bytes of cls match, in any window, for any visitor.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import os from 'node:os';
import test, { after, before } from 'node:test';
import { accessibilityViolations, kWidths } from '../../viewer/browser/browser.mjs';
import { hashOfCls, sha256 } from './cls_match.mjs';
import { fieldOf, resultMatches, startSite, viewerFrame, whenShown } from './site.mjs';

const FIRST_MS = 5000; // on a host that does nothing else

let site;
before(async () => {
  site = await startSite();
});
after(() => site?.close());

/** Time is longer where programs wait for each other. */
const slowness = () => Math.max(1, os.loadavg()[0] / os.cpus().length);

test('a match plays within five seconds, without errors, violations and foreign requests', async (t) => {
  const began = Date.now();
  const { page, problems, context } = await site.open();
  await whenShown(page);
  const took = Date.now() - began;
  t.diagnostic(`first picture after ${took} ms, load ${os.loadavg()[0].toFixed(1)}`);
  assert.ok(took < FIRST_MS * slowness(), `${took} ms`);

  const frame = () => viewerFrame(page).evaluate(() => window.clsViewer.viewer.frame);
  const before = await frame();
  await page.waitForTimeout(1500);
  assert.ok(await frame() > before, 'the match runs');
  assert.deepEqual(problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await context.close();
});

test('the match has the bytes of cls match, and its log is a file', async () => {
  const { page, context } = await site.open();
  await whenShown(page);
  await page.selectOption('[name=left]', 'mock:simple');
  await page.selectOption('#match-form [name=cycles]', '1000');
  await page.fill('[name=seed]', '21');
  await page.click('#play');
  assert.match(await resultMatches(page, /cycles at/, 400_000), /^simple_l \d+ : \d+ simple_r, 1000 cycles/);
  await page.waitForFunction(() => document.getElementById('result').dataset.hash);
  const hash = await page.locator('#result').getAttribute('data-hash');
  assert.equal(hash, hashOfCls(['mock:simple', 'mock:simple', '--seed', '21', '--cycles', '1000']));

  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-game-log')]);
  assert.equal(download.suggestedFilename(), 'match.rcg');
  assert.equal(sha256(readFileSync(await download.path())), hash);
  await context.close();
});

test('the page fits any window, in each step', async () => {
  const { page, context } = await site.open();
  await whenShown(page);
  const outside = [];
  for (const step of ['watch', 'learn', 'write', 'improve']) {
    await page.click(`.steps [data-step=${step}]`);
    for (const width of kWidths) {
      await page.setViewportSize({ width, height: width < 700 ? 800 : Math.round(width * 0.6) });
      await page.waitForTimeout(30);
      const scroll = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      if (scroll > 0) outside.push(`${step} at ${width}: ${scroll} pixels`);
    }
  }
  assert.deepEqual(outside, []);
  await context.close();
});

test('axe finds nothing, in each step, dark and light', async () => {
  for (const colorScheme of ['dark', 'light']) {
    const { page, context } = await site.open('', { colorScheme });
    await whenShown(page);
    for (const step of ['watch', 'learn', 'write', 'improve']) {
      await page.click(`.steps [data-step=${step}]`);
      assert.deepEqual(await accessibilityViolations(page, { exclude: ['iframe'] }), [], `${step}, ${colorScheme}`);
    }
    await context.close();
  }
});

test('the viewer in the page has its keys and its panel', async () => {
  const { page, context } = await site.open();
  await whenShown(page, 30);
  await fieldOf(page).locator('.stage').click();
  await page.keyboard.press('Space');
  await viewerFrame(page).waitForFunction(() => !window.clsViewer.viewer.clock.playing);
  await fieldOf(page).getByRole('tab', { name: 'Pitch' }).click();
  assert.ok(await fieldOf(page).locator('.pitch-table').first().isVisible());
  await context.close();
});
