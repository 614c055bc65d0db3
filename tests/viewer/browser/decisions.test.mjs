// The decision debugger in Chromium: estimates on the field, the panel, keys and links, texts that try to be markup.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';
import {kDrawnFrame, kMissedFrame, kPolicyFrame, kWorstFrame, sampleDecisionStream} from '../web/sample_decisions.mjs';
import {sampleStream} from '../web/sample_match.mjs';
import {accessibilityViolations, launch, openPage} from './browser.mjs';
import {kInjections} from './injections.mjs';
import {pageOf} from './page_writer.mjs';

const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-decisions-'));

let browser;

before(async () => {
  browser = await launch();
});

after(async () => {
  await browser?.close();
  fs.rmSync(kFolder, {recursive: true, force: true});
});

/** Opens a page with decisions of the left team; `problems` collects messages, errors and requests. */
async function open({hash = '', text, sides, decisions = {left: sampleDecisionStream(text)}, ...options} = {}) {
  const file = path.join(kFolder, `${Object.keys(decisions).length}-${text ? 'text' : 'plain'}${sides ? '-sides' : ''}.html`);
  fs.writeFileSync(file, pageOf(sampleStream(), sides ? {sides} : {}, decisions));
  const opened = await openPage(browser, pathToFileURL(file).href + hash, /^(file|blob):/, {viewport: {width: 1280, height: 900}, ...options});
  await opened.page.waitForFunction(() => window.clsViewer, null, {timeout: 120000});
  return opened;
}

const loaded = (page) => page.waitForFunction(() => window.clsViewer.viewer.track !== null && !document.querySelector('.decision > div').hidden);

test('shows what the selected player estimated, received and sent', async () => {
  const {page, problems, context} = await open({hash: `#t=${kWorstFrame}&p=l7`});
  await page.keyboard.press('Shift+P');
  await loaded(page);
  assert.equal(await page.getByRole('tab', {name: 'Decision'}).getAttribute('aria-selected'), 'true');
  const text = await page.locator('.decision').innerText();
  for (const part of ['Azure 7, cycle 40', 'Reply after 1.54 ms', 'body_smart_kick target_point=(1, 2)', 'not possible', '(dash 100)(turn_neck 40)',
    'pass 9 (12, -4) 45.2', 'a teammate never', 'an opponent 12']) {
    assert.ok(text.includes(part), part);
  }
  const ball = await page.locator('.estimates tbody tr').nth(1).innerText();
  assert.match(ball, /^ball\s.*\s9\.00\s+0$/s);
  await page.keyboard.press('Shift+P');
  assert.equal(await page.getByRole('tab', {name: 'Player', exact: true}).getAttribute('aria-selected'), 'true');
  assert.deepEqual(problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await context.close();
});

test('draws the estimates where the decision has them', async () => {
  const {page, context} = await open({hash: `#t=${kWorstFrame}&p=l7&d=1`});
  await loaded(page);
  const found = await page.evaluate(() => {
    const {viewer, page} = window.clsViewer;
    const pixels = (debugging) => {
      page.renderer.draw(viewer.clock, {theme: viewer.theme, layers: viewer.settings.layers, selected: viewer.selected, smooth: false, track: debugging ? viewer.track : null});
      return page.canvas.getContext('2d').getImageData(0, 0, page.canvas.width, page.canvas.height).data;
    };
    const without = pixels(false);
    const withEstimates = pixels(true);
    const changes = (x, y, radius) => {
      let count = 0;
      for (let dx = -radius; dx <= radius; ++dx) {
        for (let dy = -radius; dy <= radius; ++dy) {
          const at = 4 * ((Math.round(y) + dy) * page.canvas.width + Math.round(x) + dx);
          if ([0, 1, 2].some((i) => without[at + i] !== withEstimates[at + i])) ++count;
        }
      }
      return count;
    };
    const {camera, track} = viewer;
    const at = ([x, y]) => [camera.screenX(x), camera.screenY(y)];
    const ball = track.ballRow(viewer.track.at(viewer.frame));
    const [bx, by] = at(ball.estimated);
    const [ax, ay] = at(ball.actual);
    return {ghost: changes(bx, by, 8), line: changes((ax + bx) / 2, (ay + by) / 2, 3), nothing: changes(camera.screenX(0), camera.screenY(33), 3)};
  });
  assert.ok(found.ghost > 20, `ball: ${found.ghost} pixels`);
  assert.ok(found.line > 3, `line: ${found.line} pixels`);
  assert.equal(found.nothing, 0);
  await context.close();
});

test('shows and draws the options of a policy', async () => {
  const {page, problems, context} = await open({hash: `#t=${kPolicyFrame}&p=l7&d=1`});
  await loaded(page);
  const text = await page.locator('.decision').innerText();
  for (const part of ['Options of the policy, most likely first', 'dribble -45 deg (20, -20) 60% room 4.5', 'decided by its policy', '2 more']) assert.ok(text.includes(part), part);
  assert.equal(await page.locator('.plan').first().locator('li').count(), 8);
  assert.equal(await page.locator('.plan li[aria-current]').innerText(), 'dribble -45 deg (20, -20) 60% room 4.5');
  await page.getByText('2 more').click();
  assert.ok(await page.getByText('pass ahead 6 (0, 5) 1%').isVisible());
  assert.deepEqual(problems, []);
  const changed = await page.evaluate(() => {
    const {viewer, page} = window.clsViewer;
    const pixels = (track) => {
      page.renderer.draw(viewer.clock, {theme: viewer.theme, layers: viewer.settings.layers, selected: viewer.selected, smooth: false, track});
      return page.canvas.getContext('2d').getImageData(0, 0, page.canvas.width, page.canvas.height).data;
    };
    const [without, drawn] = [pixels(null), pixels(viewer.track)];
    return [[20, -20], [30, 20], [20, 20]].map(([x, y]) => {
      const at = 4 * (Math.round(viewer.camera.screenY(y)) * page.canvas.width + Math.round(viewer.camera.screenX(x)));
      return [0, 1, 2].some((i) => without[at + i] !== drawn[at + i]);
    });
  });
  assert.deepEqual(changed, [true, true, false]);
  await context.close();
});

test('lists the worst moments, marks missed decisions, and links restore the mode', async () => {
  const {page, problems, context} = await open({hash: `#t=${kMissedFrame}&p=l7&d=1`});
  await loaded(page);
  assert.match(await page.locator('.decision .player-state').innerText(), /Missed after 1.55 ms: no reply before the deadline/);
  await page.locator('.worst button').first().click();
  assert.equal(await page.evaluate(() => window.clsViewer.viewer.frame), kWorstFrame);
  await page.waitForFunction(() => window.location.hash.includes('d=1'));
  const strip = await page.locator('.decision-strip').first().boundingBox();
  await page.mouse.click(strip.x + strip.width / 2, strip.y + 10);
  assert.ok(Math.abs((await page.evaluate(() => window.clsViewer.viewer.frame)) - 150) < 3);
  await page.getByRole('button', {name: 'Call the Playmaker again'}).click();
  assert.match(await page.locator('.copied').innerText(), /^# match.rpc: .*\ncls test --replay match.rpc --side left --at \d+ --player 7 (localhost:50051|mock|'.+')$/);
  await page.keyboard.press('Shift+Digit7');
  await page.locator('.decision .hint', {hasText: '--record-world-models'}).first().waitFor();
  assert.deepEqual(problems, []);
  await context.close();
});

test('calls the Playmaker of this match again', async () => {
  const {page, context} = await open({hash: `#t=${kMissedFrame}&p=l7&d=1`, sides: ['run:./run --port {port}', 'mock']});
  await loaded(page);
  await page.getByRole('button', {name: 'Call the Playmaker again'}).click();
  assert.match(await page.locator('.copied').innerText(),
    /^# match.rpc: played again with --record-rpc match.rpc, unless it was recorded\ncls test --replay match.rpc --side left --at \d+ --player 7 'run:.\/run --port \{port\}'$/);
  await context.close();
});

test('draws what the Playmaker shows, as far as the filter lets it', async () => {
  const {page, problems, context} = await open({hash: `#t=${kDrawnFrame}&p=l7&d=1`});
  await loaded(page);
  const red = () => page.evaluate(() => {
    const {viewer, page} = window.clsViewer;
    page.draw();
    const {camera} = viewer;
    const data = page.canvas.getContext('2d').getImageData(Math.round(camera.screenX(10 + 3)), Math.round(camera.screenY(5)), 1, 1).data;
    return data[0] > 200 && data[1] < 90 && data[2] < 90;
  });
  const panel = page.locator('.decision');
  const list = panel.locator('.drawings li');
  assert.equal(await list.count(), 6);
  assert.equal(await red(), true);
  await panel.getByLabel('Level of texts and drawings').selectOption({label: 'team'});
  assert.deepEqual(await list.allInnerTexts().then((texts) => texts.map((text) => text.split('\n').pop())), ['run here', 'plan 7.50, -0, 1234567']);
  assert.equal(await red(), false);
  await panel.getByLabel('Level of texts and drawings').selectOption({label: 'all levels'});
  await panel.getByLabel('Filter texts and drawings').fill('filled');
  assert.equal(await list.count(), 1);
  assert.equal(await red(), true);
  await page.keyboard.press('7');
  assert.equal(await page.evaluate(() => window.clsViewer.viewer.selected.join()), '6');
  // Reading pixels often is this test's own.
  assert.deepEqual(problems.filter((each) => !each.includes('willReadFrequently')), []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await context.close();
});

test('has no debugger where nothing is recorded', async () => {
  const {page, problems, context} = await open({decisions: {}});
  assert.equal(await page.getByRole('tab', {name: 'Decision'}).count(), 0);
  await page.keyboard.press('Shift+P');
  assert.equal(await page.evaluate(() => window.clsViewer.viewer.debugging), false);
  assert.deepEqual(problems, []);
  await context.close();
});

test('makes no markup out of actions', async () => {
  const text = kInjections.filter((each) => !each.includes('\n') && each.length < 2000).join(' ');
  const {page, problems, context} = await open({text, hash: '#t=20&p=l7&d=1'});
  await loaded(page);
  assert.ok((await page.locator('.decision .actions').innerText()).includes('<script>window.injected=1</script>'));
  assert.equal(await page.evaluate(() => document.querySelectorAll('.decision script, .decision img, .decision iframe, .decision svg').length), 0);
  assert.equal(await page.evaluate(() => window.injected), undefined);
  assert.deepEqual(problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await context.close();
});

test('has no accessibility violations, in both themes and on narrow screens', async () => {
  const drawn = `#t=${kDrawnFrame}&p=l7&d=1`;
  for (const options of [{}, {colorScheme: 'light', hash: drawn}, {viewport: {width: 320, height: 800}}, {viewport: {width: 320, height: 800}, hash: drawn}]) {
    const {page, context} = await open({hash: `#t=${kMissedFrame}&p=l7&d=1`, ...options});
    await loaded(page);
    assert.deepEqual(await accessibilityViolations(page), []);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide`);
    await context.close();
  }
});
