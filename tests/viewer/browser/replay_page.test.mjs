// The replay page in Chromium, from disk, as a viewer uses it. CLS_PAGE names a page of `cls watch` to open as well,
// CLS_SCREENSHOTS a folder for pictures of its states.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';
import {kActions} from '../../../viewer/web/src/actions.js';
import {kFrames, kGoalFrame, sampleStream} from '../web/sample_match.mjs';
import {accessibilityViolations, launch, openPage, toolbarLayout} from './browser.mjs';
import {kBrokenBytes, kInjections} from './injections.mjs';
import {pageOf} from './page_writer.mjs';

const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-browser-'));

let browser;
let samplePath;

before(async () => {
  browser = await launch();
  samplePath = write('sample.html', pageOf(sampleStream()));
});

after(async () => {
  await browser?.close();
  fs.rmSync(kFolder, {recursive: true, force: true});
});

function write(name, text) {
  const file = path.join(kFolder, name);
  fs.writeFileSync(file, text);
  return file;
}

/** Opens a page; `problems` collects console messages, errors and requests. */
async function open(file, hash = '', options = {}) {
  const opened = await openPage(browser, pathToFileURL(file).href + hash, /^(file|blob):/, options);
  await opened.page.waitForFunction(() => window.clsViewer || document.querySelector('[role=alert]'), null, {timeout: 120000});
  return opened;
}

const frameOf = (page) => page.evaluate(() => window.clsViewer.viewer.frame);

test('opens from disk without errors, requests or policy violations', async (t) => {
  for (const file of [samplePath, process.env.CLS_PAGE].filter(Boolean)) {
    const {page, problems, context} = await open(file);
    await page.keyboard.press('Space');
    await page.waitForTimeout(400);
    const first = await page.evaluate(() => performance.getEntriesByName('cls-first-picture')[0].startTime);
    t.diagnostic(`${path.basename(file)}: first picture after ${first.toFixed(0)} ms`);
    assert.ok((await frameOf(page)) > 0);
    assert.deepEqual(problems, []);
    assert.deepEqual(await page.evaluate(() => window.violations), []);
    await context.close();
  }
});

test('draws each player where the record says', async () => {
  const {page, context} = await open(samplePath);
  for (let round = 0; round < 20; ++round) {
    const frame = (round * 137 + 11) % kFrames;
    const wrong = await page.evaluate(misplacedPlayers, frame);
    assert.deepEqual(wrong, [], `frame ${frame}`);
  }
  await context.close();
});

/** In the page: slots whose disc has not its color around the recorded position. */
function misplacedPlayers(frame) {
  const {viewer, page} = window.clsViewer;
  viewer.settings.layers.trails = false;
  viewer.settings.layers.numbers = false;
  viewer.seek(frame);
  page.draw();
  const {record, camera, theme} = viewer;
  const context = page.canvas.getContext('2d');
  const at = (slot) => [camera.screenX(record.column('x')[slot][frame]), camera.screenY(record.column('y')[slot][frame])];
  const ball = [camera.screenX(record.column('ball_x')[0][frame]), camera.screenY(record.column('ball_y')[0][frame])];
  const radius = Math.min(16, Math.max(6.5, 1.08 * camera.scale));
  const is = (x, y, color) => {
    const data = context.getImageData(Math.round(x), Math.round(y), 1, 1).data;
    return [1, 3, 5].every((from, i) => Math.abs(parseInt(color.slice(from, from + 2), 16) - data[i]) < 40);
  };
  const around = (x, y, distance, color) => [0, 1, 2, 3, 4, 5, 6, 7].filter((k) => is(x + Math.cos((k * Math.PI) / 4) * distance, y + Math.sin((k * Math.PI) / 4) * distance, color)).length;
  const wrong = [];
  for (let slot = 0; slot < 22; ++slot) {
    const [x, y] = at(slot);
    const others = [...Array(22).keys()].filter((other) => other !== slot).map(at);
    if ([...others, ball].some(([a, b]) => Math.hypot(a - x, b - y) < 3 * radius)) continue;
    const goalie = record.column('state')[slot][frame] & 8;
    const fill = goalie ? theme.ball : slot < 11 ? theme.left.fill : theme.right.fill;
    const inside = goalie ? 0.5 : 0.7;
    const hits = around(x, y, radius * inside, fill);
    const outside = around(x, y, radius + 3, fill);
    if (hits < (goalie ? 2 : 4) || outside > 3) wrong.push({slot, hits, outside});
  }
  return wrong;
}

test('every key of the table works, none breaks the page', async () => {
  const {page, problems, context} = await open(samplePath, '#t=50');
  const changes = async (key, read) => {
    const earlier = await page.evaluate(read);
    await page.keyboard.press(key);
    return [earlier, await page.evaluate(read)];
  };
  assert.deepEqual(await changes('ArrowRight', () => window.clsViewer.viewer.frame), [50, 51]);
  assert.deepEqual(await changes('Shift+ArrowLeft', () => window.clsViewer.viewer.frame), [51, 41]);
  assert.deepEqual(await changes('g', () => window.clsViewer.viewer.frame), [41, kGoalFrame]);
  assert.deepEqual(await changes('Shift+E', () => window.clsViewer.viewer.frame), [kGoalFrame, 65]);
  assert.deepEqual(await changes('End', () => window.clsViewer.viewer.frame), [65, kFrames - 1]);
  assert.deepEqual(await changes('Home', () => window.clsViewer.viewer.frame), [kFrames - 1, 0]);
  assert.deepEqual(await changes('.', () => window.clsViewer.viewer.clock.speed), [1, 2]);
  assert.deepEqual(await changes('7', () => window.clsViewer.viewer.selected.join()), ['', '6']);
  assert.deepEqual(await changes('Shift+Digit7', () => window.clsViewer.viewer.selected.join()), ['6', '17']);
  assert.deepEqual(await changes('u', () => window.clsViewer.viewer.selected.join()), ['17', '']);
  assert.deepEqual(await changes('o', () => window.clsViewer.viewer.settings.layers.offside), [false, true]);
  assert.deepEqual(await changes('Shift+T', () => document.documentElement.dataset.theme), ['dark', 'light']);
  assert.deepEqual(await changes('m', () => document.querySelector('.panel').hidden), [false, true]);
  for (const {keys} of kActions) {
    for (const key of keys) {
      await page.keyboard.press(key.replace(/Shift\+(\d)/, 'Shift+Digit$1').replace('Shift+-', 'Shift+Minus'));
      if (key === '?') await page.keyboard.press('Escape');
    }
  }
  await page.evaluate(() => window.clsViewer.viewer.setKeys(false));
  assert.deepEqual(await changes('Home', () => window.clsViewer.viewer.frame).then(([, now]) => now), 0);
  assert.deepEqual(await changes('g', () => window.clsViewer.viewer.frame), [0, 0]);
  assert.deepEqual(problems, []);
  await context.close();
});

test('buttons, timeline and event list seek and play', async () => {
  const {page, problems, context} = await open(samplePath);
  await page.getByRole('button', {name: 'Next goal'}).click();
  assert.equal(await frameOf(page), kGoalFrame);
  const box = await page.locator('.timeline').boundingBox();
  await page.mouse.click(box.x + box.width * 0.9, box.y + 30);
  assert.ok(Math.abs((await frameOf(page)) - 0.9 * kFrames) < 4);
  await page.getByRole('tab', {name: 'Events'}).click();
  await page.getByRole('button', {name: /Goal: Azure 10/}).click();
  assert.equal(await frameOf(page), kGoalFrame);
  assert.equal(await page.evaluate(() => window.clsViewer.viewer.selected.join()), '9');
  await page.getByRole('button', {name: 'Play the highlights'}).click();
  await page.waitForTimeout(300);
  const playing = await page.evaluate(() => [window.clsViewer.viewer.clock.playing, window.clsViewer.viewer.frame]);
  assert.ok(playing[0] && playing[1] >= kGoalFrame - 60 && playing[1] < kGoalFrame);
  await page.getByRole('button', {name: 'Pause'}).click();
  assert.equal(await page.evaluate(() => window.clsViewer.viewer.clock.playing), false);
  assert.deepEqual(problems, []);
  await context.close();
});

test('toolbar and menu are inside the window at every width, in one row beside the panel', async () => {
  const {page, context} = await open(samplePath);
  const {outside, rows} = await toolbarLayout(page);
  assert.deepEqual(outside, []);
  for (const width of [1200, 1280, 1350, 1366, 1440, 1500, 1501, 1920, 2560]) assert.equal(rows[width], 1, `${rows[width]} rows at ${width}`);
  await context.close();
});

test('the first frame shows ball and kicker, the clock says what its numbers are', async () => {
  for (const viewport of [{width: 390, height: 844}, {width: 1280, height: 800}]) {
    const {page, context} = await open(samplePath, '', {viewport});
    const hidden = await page.evaluate(() => {
      const {viewer, page} = window.clsViewer;
      const stage = page.stage.getBoundingClientRect();
      const button = page.bigPlay.getBoundingClientRect();
      const near = (x, y) => Math.abs(x) < 10 && Math.abs(y) < 10;
      const {record, camera} = viewer;
      const things = [[record.column('ball_x')[0][0], record.column('ball_y')[0][0]], ...Array.from({length: 22}, (_, slot) => [record.column('x')[slot][0], record.column('y')[slot][0]]).filter(([x, y]) => near(x, y))];
      return things.filter(([x, y]) => {
        const [left, top] = [stage.left + camera.screenX(x), stage.top + camera.screenY(y)];
        return left > button.left - 8 && left < button.right + 8 && top > button.top - 8 && top < button.bottom + 8;
      });
    });
    assert.deepEqual(hidden, []);
    assert.match(await page.locator('.clock').innerText(), /minute\s+1\s+cycle\s+0/);
    await context.close();
  }
});

test('the tip of the timeline has the play mode in words', async () => {
  const {page, context} = await open(samplePath);
  const box = await page.locator('.timeline').boundingBox();
  const tip = async (frame) => {
    await page.mouse.move(box.x + (frame / kFrames) * box.width, box.y + 30);
    return page.locator('.timeline-tip').innerText();
  };
  assert.match(await tip(45), /^cycle 4\d · play on$/);
  assert.match(await tip(110), /^cycle 100\+\d+ · goal, Azure$/);
  await context.close();
});

test('a link restores moment, selection, speed and view', async () => {
  const {page, context} = await open(samplePath);
  await page.evaluate(() => {
    const {viewer} = window.clsViewer;
    viewer.seek(107);
    viewer.select(6);
    viewer.select(11, true);
    viewer.clock.setSpeed(0.5);
    viewer.zoom(3, 400, 300);
  });
  await page.waitForFunction(() => window.location.hash.includes('z='));
  const hash = await page.evaluate(() => window.location.hash);
  assert.match(hash, /^#t=100\+7&p=r1,l7&s=0\.5&z=3,/);
  const again = await open(samplePath, hash);
  const state = await again.page.evaluate(() => {
    const {viewer} = window.clsViewer;
    return [viewer.frame, viewer.selected.join(), viewer.clock.speed, viewer.camera.zoom];
  });
  assert.deepEqual(state, [107, '11,6', 0.5, 3]);
  await context.close();
  await again.context.close();
});

test('starts at the moment that the page was written with', async () => {
  const file = write('at.html', pageOf(sampleStream(), {schema: 'cls.page/1', at: 42, players: ['r3'], live: null}));
  const {page, context} = await open(file);
  assert.deepEqual(await page.evaluate(() => [window.clsViewer.viewer.frame, window.clsViewer.viewer.selected.join()]), [42, '13']);
  await context.close();
});

test('draws half-way positions while it plays, whole frames while it rests', async () => {
  const {page, context} = await open(samplePath);
  const shown = await page.evaluate(() => {
    const {viewer, page} = window.clsViewer;
    viewer.clock.at = 40.5;
    viewer.clock.playing = true;
    page.draw();
    const moving = page.renderer.pose.x[5];
    viewer.clock.playing = false;
    page.draw();
    const x = viewer.record.column('x')[5];
    return {moving, resting: page.renderer.pose.x[5], first: x[40], second: x[41]};
  });
  assert.ok(Math.abs(shown.moving - (shown.first + shown.second) / 2) < 1e-6);
  assert.equal(shown.resting, shown.first);
  await context.close();
});

test('names and messages never become markup', async () => {
  assert.ok(kInjections.length >= 60);
  const count = async (page) => page.evaluate(() => document.querySelectorAll('*').length);
  const clean = await open(write('clean.html', pageOf(sampleStream())));
  const expected = await count(clean.page);
  await clean.context.close();
  const context = await browser.newContext();
  const page = await context.newPage();
  const texts = [...kInjections, ...kBrokenBytes];
  for (const [index, text] of texts.entries()) {
    const file = write('injection.html', pageOf(sampleStream({names: [text, 'Amber'], texts: [text]}), {players: [String(text)]}));
    await page.goto(`${pathToFileURL(file).href}?${index}`);
    await page.waitForFunction(() => window.clsViewer, null, {timeout: 60000});
    assert.equal(await page.evaluate(() => window.injected), undefined, String(text).slice(0, 60));
    assert.equal(await count(page), expected, String(text).slice(0, 60));
  }
  await context.close();
});

test('the policy blocks scripts that get in all the same', async () => {
  const {page, context} = await open(samplePath);
  await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.injected = 1';
    document.body.append(script);
  });
  await page.waitForFunction(() => window.violations.length > 0);
  assert.equal(await page.evaluate(() => window.injected), undefined);
  await context.close();
});

test('axe finds no accessibility violations', async () => {
  const states = [
    ['dark', {colorScheme: 'dark'}], ['light', {colorScheme: 'light'}], ['320 px', {viewport: {width: 320, height: 640}}],
    ['200 %', {viewport: {width: 640, height: 400}, deviceScaleFactor: 2, colorScheme: 'light'}], ['reduced motion', {reducedMotion: 'reduce'}],
  ];
  for (const [name, options] of states) {
    const {page, context} = await open(samplePath, '#t=100&p=l10', options);
    for (const tab of ['Match', 'Events', 'Player', 'Pitch', 'help']) {
      if (tab === 'help') await page.keyboard.press('?');
      else await page.getByRole('tab', {name: tab}).click();
      assert.deepEqual(await accessibilityViolations(page), [], `${name}, ${tab}`);
    }
    await context.close();
  }
});

test('nothing is wider than a screen of 320 px', async () => {
  const {page, context} = await open(samplePath, '', {viewport: {width: 320, height: 640}, hasTouch: true});
  for (const tab of ['Match', 'Events', 'Player', 'Pitch']) {
    await page.getByRole('tab', {name: tab}).click();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320, tab);
  }
  await context.close();
});

test('reduced motion starts without trails and does not play', async () => {
  const {page, context} = await open(samplePath, '#t=50&play=1', {reducedMotion: 'reduce'});
  const state = await page.evaluate(() => [window.clsViewer.viewer.clock.playing, window.clsViewer.viewer.settings.layers.trails]);
  assert.deepEqual(state, [false, false]);
  await context.close();
});

test('two fingers zoom, one finger moves the pitch', async () => {
  const {page, context} = await open(samplePath, '', {hasTouch: true});
  const client = await context.newCDPSession(page);
  const touch = (type, ...points) => client.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
  await touch('touchStart', [400, 300], [500, 300]);
  await touch('touchMove', [300, 300], [600, 300]);
  await touch('touchEnd');
  const zoomed = await page.evaluate(() => window.clsViewer.viewer.camera.zoom);
  assert.ok(zoomed > 2 && zoomed < 4, String(zoomed));
  const earlier = await page.evaluate(() => window.clsViewer.viewer.camera.x);
  await touch('touchStart', [400, 300]);
  await touch('touchMove', [300, 300]);
  await touch('touchEnd');
  assert.ok((await page.evaluate(() => window.clsViewer.viewer.camera.x)) > earlier);
  await context.close();
});

test('says how much of a truncated page is there', async () => {
  const text = fs.readFileSync(samplePath, 'utf8');
  const start = text.indexOf('>', text.lastIndexOf('data-length="')) + 1;
  const end = text.lastIndexOf('</script>');
  const cut = write('cut.html', text.slice(0, start + Math.floor((end - start) * 0.615)));
  const {page, context} = await open(cut);
  assert.match(await page.locator('[role=alert]').innerText(), /truncated at 61 %/);
  await context.close();
});

test('announces events and describes a moment', async () => {
  const {page, context} = await open(samplePath, `#t=95`);
  await page.keyboard.press('Space');
  await page.waitForFunction(() => document.querySelector('[role=status]').textContent.includes('Goal: Azure 10'), null, {timeout: 20000});
  await page.keyboard.press('Space');
  await page.keyboard.press('w');
  assert.match(await page.locator('[role=status]').innerText(), /Cycle .* Ball: .* Nearest: /);
  assert.match(await page.locator('canvas.field').getAttribute('aria-label'), /Azure against Amber: 1 to 0/);
  await context.close();
});

test('saves an image', async () => {
  const {page, context} = await open(samplePath, '#t=50');
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Shift+S')]);
  const bytes = fs.readFileSync(await download.path());
  assert.equal(download.suggestedFilename(), 'cycle-50.png');
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  assert.ok(bytes.length > 10000);
  await context.close();
});

test('prints the field without its controls', async () => {
  const {page, context} = await open(samplePath, '#t=50');
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('.controls').first().isVisible(), false);
  const field = await page.locator('canvas').first().boundingBox();
  assert.ok(field.width > 200 && field.height > 100, JSON.stringify(field));
  const bytes = await page.pdf();
  assert.equal(bytes.subarray(0, 4).toString(), '%PDF');
  assert.ok(bytes.length > 10000, `${bytes.length} bytes`);
  if (process.env.CLS_SCREENSHOTS) fs.writeFileSync(path.join(process.env.CLS_SCREENSHOTS, 'print.pdf'), bytes);
  await context.close();
});

test('records a clip that plays', async () => {
  const {page, problems, context} = await open(samplePath, '#t=50');
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Shift+C').then(async () => {
    assert.equal(await page.evaluate(() => window.clsViewer.viewer.clock.playing), true);
    await page.waitForFunction(() => window.clsViewer.viewer.frame >= 60);
    await page.keyboard.press('Space');
  })]);
  assert.match(download.suggestedFilename(), /^cycles-50-to-6\d\.webm$/);
  const bytes = fs.readFileSync(await download.path());
  assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3);
  assert.deepEqual(problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  // The page's policy lets no video in, so another page plays it.
  const player = await context.newPage();
  await player.goto(pathToFileURL(write('empty.html', '<!doctype html><video></video>')).href);
  const picture = await player.evaluate(playedPicture, bytes.toString('base64'));
  assert.ok(picture.seconds > 0.3 && picture.green > 40 && picture.green > picture.red, JSON.stringify(picture));
  await context.close();
});

/** In another page: plays a video and says what color its field has. */
async function playedPicture(base64) {
  const video = document.querySelector('video');
  video.muted = true;
  video.src = `data:video/webm;base64,${base64}`;
  await video.play();
  await new Promise((resolve) => video.addEventListener('ended', resolve));
  const canvas = Object.assign(document.createElement('canvas'), {width: video.videoWidth, height: video.videoHeight});
  const context = canvas.getContext('2d');
  context.drawImage(video, 0, 0);
  const [red, green] = context.getImageData(canvas.width / 4, canvas.height / 3, 1, 1).data;
  return {seconds: video.currentTime, red, green};
}

test('draws and seeks in time, without growth of the heap', async (t) => {
  const file = process.env.CLS_PAGE ?? samplePath;
  for (const rate of [1, 4]) {
    const {page, context} = await open(file);
    const client = await context.newCDPSession(page);
    await client.send('Emulation.setCPUThrottlingRate', {rate});
    const times = await page.evaluate(measureDrawing);
    t.diagnostic(`CPU / ${rate}: all layers ${times.median.toFixed(2)} ms median, ${times.p95.toFixed(2)} ms p95; seek ${times.seek.toFixed(2)} ms median`);
    await context.close();
  }
  const {page, context} = await open(file);
  const client = await context.newCDPSession(page);
  await client.send('Performance.enable');
  const heap = async () => {
    await client.send('HeapProfiler.collectGarbage');
    return (await client.send('Performance.getMetrics')).metrics.find(({name}) => name === 'JSHeapUsedSize').value;
  };
  await page.evaluate(seekOften, 100);
  const earlier = await heap();
  await page.evaluate(seekOften, 1000);
  const later = await heap();
  t.diagnostic(`JS heap ${(later / 1e6).toFixed(1)} MB, ${((later - earlier) / 1e3).toFixed(0)} kB more after 1000 seeks`);
  assert.ok(later < 40e6 && later - earlier < 1e6);
  await context.close();
});

function measureDrawing() {
  const {viewer, page} = window.clsViewer;
  for (const name of Object.keys(viewer.settings.layers)) viewer.settings.layers[name] = true;
  const timed = (run) => Array.from({length: 200}, (_, i) => {
    const start = performance.now();
    run(i);
    return performance.now() - start;
  }).sort((a, b) => a - b);
  viewer.clock.playing = true;
  const draws = timed((i) => {
    viewer.clock.at = (i * 7.37) % viewer.clock.last;
    page.draw();
  });
  viewer.clock.playing = false;
  const seeks = timed((i) => {
    viewer.seek((i * 911) % viewer.clock.last);
    page.draw();
  });
  return {median: draws[100], p95: draws[190], seek: seeks[100]};
}

function seekOften(count) {
  const {viewer, page} = window.clsViewer;
  for (let i = 0; i < count; ++i) {
    viewer.seek((i * 7919) % viewer.clock.last);
    page.draw();
  }
}

test('takes pictures of eight states', {skip: process.env.CLS_SCREENSHOTS ? false : 'CLS_SCREENSHOTS names no folder'}, async () => {
  const file = process.env.CLS_PAGE ?? samplePath;
  const wide = {viewport: {width: 1360, height: 820}};
  const narrow = {viewport: {width: 390, height: 844}, deviceScaleFactor: 2, hasTouch: true};
  const states = [
    ['replay', '#t=165', wide, []], ['light', '#t=165', {...wide, colorScheme: 'light'}, []], ['player', '#t=165&p=l10&z=3,40,5', wide, ['v', 'k', 'o']],
    ['layers', '#t=160', wide, ['v', 'k', 't', 'c', 'o', 'Shift+F', 's', 'h', 'j']], ['events', '#t=165', wide, ['g']], ['help', '#t=165', wide, ['?']],
    ['narrow', '#t=165', narrow, []], ['pitch', '#t=165', {...wide, colorScheme: 'light'}, []],
  ];
  for (const [name, hash, options, keys] of states) {
    const {page, context} = await open(file, hash, options);
    if (name === 'events' || name === 'pitch') await page.getByRole('tab', {name: name === 'events' ? 'Events' : 'Pitch'}).click();
    for (const key of keys) await page.keyboard.press(key);
    await page.waitForTimeout(300);
    await page.screenshot({path: path.join(process.env.CLS_SCREENSHOTS, `${name}.png`)});
    await context.close();
  }
});

test('shows decisions that were played again: marks, paths of the alternatives, playouts', async () => {
  const worths = (mean) => Array.from({length: 20}, (_, i) => mean + ((i % 5) - 2) / 20);
  const review = [{cycle: 40, player: 'l7', cost: [0.25, 0.1, 0.4], better: 2, choices: [
    {text: 'pass to their 4', target: null, worths: worths(-0.2)}, {text: 'hold', target: [2, 1], worths: worths(-0.1)},
    {text: 'through pass to 11', target: [30, -20], worths: worths(0.05)}]}];
  const {page, problems, context} = await open(write('review.html', pageOf(sampleStream(), {review})), '', {viewport: {width: 1366, height: 768}});
  await page.keyboard.press('Shift+X');
  assert.equal(await frameOf(page), 40);
  await page.getByRole('tab', {name: 'Events'}).click();
  const table = page.getByRole('table').filter({hasText: 'Goals after each choice, 20 playouts; difference 0.25 (95 %: 0.10 to 0.40)'});
  await table.waitFor();
  assert.match(await table.innerText(), /pass to their 4 \(played\)\s+\u22120\.20[^]*through pass to 11\s+\+0\.05/);
  assert.equal(await table.locator('circle').count(), 60);

  assert.deepEqual(problems, [], 'later the test itself reads pixels');
  const painted = () => page.evaluate(() => {
    const {viewer, page: whole} = window.clsViewer;
    whole.draw();
    const at = [viewer.camera.screenX(30), viewer.camera.screenY(-20)].map(Math.round);
    return [...whole.canvas.getContext('2d').getImageData(at[0], at[1], 1, 1).data];
  });
  const shown = await painted();
  if (process.env.CLS_SCREENSHOTS) await page.screenshot({path: path.join(process.env.CLS_SCREENSHOTS, 'review.png')});
  await page.evaluate(() => window.clsViewer.viewer.seek(105));
  assert.notDeepEqual(await painted(), shown, 'the paths end with the moment');
  await table.waitFor({state: 'hidden'});
  assert.deepEqual(await accessibilityViolations(page), []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await context.close();
});
