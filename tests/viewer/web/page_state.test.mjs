// Clock, interpolation, links, keys, events: the parts of the page that need no browser.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import test from 'node:test';
import {actionsByKey, kActions} from '../../../viewer/web/src/actions.js';
import {Camera} from '../../../viewer/web/src/camera.js';
import {Clock, kSpeeds} from '../../../viewer/web/src/clock.js';
import {eventsOf, highlightsOf, nextEvent} from '../../../viewer/web/src/events.js';
import {formatHash, parseHash} from '../../../viewer/web/src/hash.js';
import {Pose, poseAt} from '../../../viewer/web/src/interpolate.js';
import {keyName} from '../../../viewer/web/src/keys.js';
import {drawBall} from '../../../viewer/web/src/layer_ball.js';
import {signed} from '../../../viewer/web/src/layer_choices.js';
import {offsideLineX} from '../../../viewer/web/src/layer_offside.js';
import {momentText} from '../../../viewer/web/src/moment.js';
import {kPitch} from '../../../viewer/web/src/pitch.js';
import {playModeClass, playModeText} from '../../../viewer/web/src/play_modes.js';
import {replayedAt} from '../../../viewer/web/src/replayed.js';
import {slotOfShortName} from '../../../viewer/web/src/sides.js';
import {StreamDecoder} from '../../../viewer/web/src/stream.js';
import {kFrames, kGoalFrame, sampleStream} from './sample_match.mjs';

function sampleRecord(options) {
  const decoder = new StreamDecoder();
  Array.from(decoder.push(sampleStream(options)));
  return decoder.record;
}

test('Clock plays in real time at its speed', () => {
  const clock = new Clock(1000);
  clock.play();
  clock.tick(100);
  assert.equal(clock.at, 1);
  clock.setSpeed(0.5);
  clock.tick(100);
  assert.equal(clock.at, 1.5);
  clock.reverse();
  clock.tick(100);
  assert.equal(clock.at, 1);
});

test('Clock pauses on a whole frame and at the end', () => {
  const clock = new Clock(10);
  clock.play();
  clock.tick(160);
  clock.pause();
  assert.equal(clock.at, 2);
  clock.play();
  for (let i = 0; i < 20; ++i) clock.tick(100);
  assert.equal(clock.at, 9);
  assert.equal(clock.playing, false);
  clock.play();
  assert.equal(clock.at, 0);
});

test('Clock does not skip play after a hidden tab', () => {
  const clock = new Clock(1000);
  clock.play();
  clock.tick(60000);
  assert.equal(clock.at, 2.5);
});

test('Clock follows a live match smoothly, and rests when nothing comes', () => {
  const clock = new Clock(100);
  clock.grow(100, true);
  clock.expected = 6000;
  assert.equal(clock.span, 6000);
  clock.seek(99);
  clock.follow();
  assert.equal(clock.waiting, true);
  clock.grow(101, true);
  assert.equal(clock.waiting, false);
  clock.tick(16);
  assert.ok(clock.at > 99 && clock.at < 99.5);
  for (let i = 0; i < 60; ++i) clock.tick(16);
  assert.equal(clock.at, 100);
  clock.grow(5000, true);
  for (let i = 0; i < 120; ++i) clock.tick(16);
  assert.equal(clock.frame, 4999);
  clock.grow(5000, false);
  clock.tick(16);
  assert.deepEqual([clock.playing, clock.following, clock.span], [false, false, 4999]);
});

test('Clock leaves the present with every seek, and returns to it at the head', () => {
  const clock = new Clock(100);
  clock.grow(100, true);
  for (const leave of [() => clock.seek(5), () => clock.step(-1), () => clock.reverse(), () => clock.playSegments([[1, 2]]), () => clock.pause()]) {
    clock.follow();
    leave();
    assert.equal(clock.following, false);
  }
  clock.seek(98.5);
  clock.backwards = false;
  clock.segments = [];
  clock.play();
  clock.tick(100);
  assert.deepEqual([clock.following, clock.playing], [true, true]);
});

test('Clock steps, seeks and changes speeds within limits', () => {
  const clock = new Clock(100);
  clock.step(Infinity);
  assert.equal(clock.at, 99);
  clock.step(-10);
  assert.equal(clock.at, 89);
  clock.seek(-5);
  assert.equal(clock.at, 0);
  for (let i = 0; i < 20; ++i) clock.changeSpeed(1);
  assert.equal(clock.speed, kSpeeds.at(-1));
  for (let i = 0; i < 20; ++i) clock.changeSpeed(-1);
  assert.equal(clock.speed, kSpeeds[0]);
});

test('Clock plays segments in sequence and stops after the last', () => {
  const clock = new Clock(1000);
  clock.playSegments([[10, 12], [50, 52]]);
  assert.equal(clock.at, 10);
  const seen = [];
  for (let i = 0; i < 12; ++i) {
    clock.tick(50);
    seen.push(clock.at);
  }
  assert.ok(seen.every((at) => (at >= 10 && at <= 12) || (at >= 50 && at <= 52)));
  assert.equal(clock.playing, false);
  assert.equal(clock.at, 52);
});

test('poseAt shows the numbers of the log on whole frames', () => {
  const record = sampleRecord();
  const pose = new Pose();
  poseAt(record, 40, pose);
  assert.equal(pose.x[5], record.column('x')[5][40]);
  assert.equal(pose.ballX, record.column('ball_x')[0][40]);
});

test('The ball of the 2.5D server rises above its shadow', () => {
  const record = sampleRecord();
  const pose = new Pose();
  poseAt(record, 40, pose);
  assert.equal(pose.ballZ, 0, 'other logs have no height');
  record.columns.set('ball_z', {series: [new Float32Array(kFrames).fill(2)]});
  poseAt(record, 40, pose);
  assert.equal(pose.ballZ, 2);
  const discs = [];
  const context = {beginPath() {}, fill() {}, stroke() {}, arc: (x, y) => discs.push([x, y])};
  const camera = new Camera(kPitch);
  camera.resize(1000, 700);
  drawBall({context, camera, pose, theme: {}});
  const [shadow, ball] = discs;
  assert.ok(Math.abs(shadow[1] - 1.5 - camera.screenY(pose.ballY)) < 1e-9);
  assert.ok(Math.abs(shadow[1] - 1.5 - ball[1] - 2 * camera.scale) < 1e-9);
});

test('poseAt is half-way between two frames', () => {
  const record = sampleRecord();
  const pose = new Pose();
  poseAt(record, 40.5, pose);
  const x = record.column('x')[5];
  assert.ok(Math.abs(pose.x[5] - (x[40] + x[41]) / 2) < 1e-6);
  poseAt(record, 40.5, pose, false);
  assert.equal(pose.x[5], x[40]);
});

test('poseAt turns bodies the short way', () => {
  const record = sampleRecord();
  const body = record.column('body')[0];
  let frame = 0;
  while (Math.abs(body[frame + 1] - body[frame]) < 180) ++frame;
  const pose = new Pose();
  poseAt(record, frame + 0.5, pose);
  assert.ok(Math.abs(pose.body[0]) > 170);
});

test('poseAt lets the ball not glide where it jumps', () => {
  const record = sampleRecord();
  const pose = new Pose();
  poseAt(record, kGoalFrame + 9.5, pose);
  assert.equal(pose.ballX, 53);
  poseAt(record, kGoalFrame + 10.5, pose);
  assert.equal(pose.ballX, 20);
});

test('A hash restores what it was made from', () => {
  const moment = {time: 1234, stopped: 7, selected: [6, 11], speed: 0.5, view: {zoom: 2.5, x: 10, y: -3.5}, follow: 'ball', debugging: true, play: true};
  assert.equal(formatHash(moment), '#t=1234+7&p=l7,r1&s=0.5&z=2.5,10,-3.5&f=ball&d=1&play=1');
  assert.deepEqual(parseHash(formatHash(moment)), moment);
  assert.deepEqual(parseHash('#t=12%2B3&p=l7%2Cr1').stopped, 3);
});

test('A hash of any text is harmless', () => {
  for (const text of ['', '#', '#t=', '#t=abc', '#p=x9,l12,r0', '#z=1,2', '#s=-1', '#=&&=', `#t=${'9'.repeat(50)}`]) {
    const moment = parseHash(text);
    assert.equal(moment.time, null);
    assert.ok(moment.selected === null || moment.selected.length === 0);
  }
  assert.equal(slotOfShortName('l12'), -1);
});

test('Each key has one action, and each action a label and a key', () => {
  const byKey = actionsByKey();
  assert.ok(byKey.size >= kActions.length);
  for (const {id, label, keys, group} of kActions) assert.ok(id && label && group && keys.length > 0, id);
  assert.equal(new Set(kActions.map(({id}) => id)).size, kActions.length);
});

test('keyName names keys of any layout', () => {
  const key = (name, code, shiftKey = false) => keyName({key: name, code, shiftKey, ctrlKey: false, altKey: false, metaKey: false});
  assert.equal(key('g', 'KeyG'), 'G');
  assert.equal(key('G', 'KeyG', true), 'Shift+G');
  assert.equal(key('&', 'Digit7', true), 'Shift+7');
  assert.equal(key(' ', 'Space'), 'Space');
  assert.equal(key('?', 'Slash', true), '?');
  assert.equal(key('ArrowLeft', 'ArrowLeft', true), 'Shift+ArrowLeft');
  assert.equal(keyName({key: 'g', code: 'KeyG', shiftKey: false, ctrlKey: true, altKey: false, metaKey: false}), '');
});

test('eventsOf finds goals, shots, cards and offenses in order of time', () => {
  const events = eventsOf(sampleRecord());
  assert.deepEqual(events.map(({kind, frame}) => [kind, frame]), [['turnover', 65], ['goal', kGoalFrame], ['card', 150], ['shot', 220]]);
  assert.deepEqual(events.map(({expectedGoals}) => expectedGoals), [undefined, 0.5, undefined, 0.3], 'goals and shots have theirs');
  assert.equal(nextEvent(events, 0, 1, ['goal']).frame, kGoalFrame);
  assert.equal(nextEvent(events, 299, -1).kind, 'shot');
  assert.equal(nextEvent(events, 299, 1), undefined);
});

test('eventsOf finds goals without statistics', () => {
  const events = eventsOf(sampleRecord({statistics: false}));
  assert.deepEqual(events.filter(({kind}) => kind === 'goal').map(({frame}) => frame), [kGoalFrame]);
});

test('highlightsOf merges what overlaps', () => {
  const events = [{kind: 'goal', frame: 100}, {kind: 'shot', frame: 150, expectedGoals: 0.3}, {kind: 'shot', frame: 700, expectedGoals: 0.1}, {kind: 'goal', frame: 900}];
  assert.deepEqual(highlightsOf(events, 910), [[40, 170], [840, 909]]);
});

test('Camera zooms around the pointer and keeps the pitch in the picture', () => {
  const camera = new Camera(kPitch);
  camera.resize(1000, 700);
  const x = camera.fieldX(300);
  const y = camera.fieldY(400);
  camera.zoomBy(2, 300, 400);
  assert.ok(Math.abs(camera.screenX(x) - 300) < 1e-6 && Math.abs(camera.screenY(y) - 400) < 1e-6);
  camera.panBy(1e6, 1e6);
  assert.ok(camera.fieldX(0) > -kPitch.length / 2 - 6);
  camera.fit();
  assert.equal(camera.screenX(0), 500);
});

test('offsideLineX is the second last opponent, the ball or the halfway line', () => {
  const pose = new Pose();
  for (let slot = 0; slot < 22; ++slot) {
    pose.state[slot] = 1;
    pose.x[slot] = slot < 11 ? -50 + slot : 50 - 3 * (slot - 11);
  }
  assert.equal(offsideLineX(pose, 1), 47);
  assert.equal(offsideLineX(pose, -1), -49);
  pose.ballX = 48;
  assert.equal(offsideLineX(pose, 1), 48);
  pose.x.fill(10, 11);
  pose.ballX = -20;
  assert.equal(offsideLineX(pose, 1), 10);
  pose.x.fill(-10, 11);
  assert.equal(offsideLineX(pose, 1), 0);
});

test('momentText names clock, mode, score, ball and players', () => {
  const text = momentText(sampleRecord(), kGoalFrame + 7, [2]);
  assert.match(text, /^Cycle 100\+7, goal, Azure\. Azure against Amber: 1 to 0\. Ball: /);
  assert.match(text, /Azure 3: /);
});

test('Play modes read as text and have a class', () => {
  assert.equal(playModeText('kick_in_r', 'A', 'B'), 'kick in, B');
  assert.equal(playModeClass('foul_charge_l'), 'offense');
  assert.equal(playModeClass('corner_kick_r'), 'set_play');
  assert.equal(playModeClass('before_kick_off'), 'pause');
});

const kWeb = new URL('../../../viewer/web/', import.meta.url);
const kLines = fs.readFileSync(new URL('modules.txt', kWeb), 'utf8').trim().split('\n').map((line) => line.split(' '));
const kModules = kLines.map(([name]) => name);
/** Modules that every page has. */
const kEveryPage = kLines.filter((line) => line.length === 1).map(([name]) => name);
const kSources = kModules.map((name) => [name, fs.readFileSync(new URL(`src/${name}`, kWeb), 'utf8')]);

test('Modules can be joined: each listed once, after what it imports, names unique', () => {
  assert.deepEqual(kModules.slice().sort(), fs.readdirSync(new URL('src/', kWeb)).sort());
  const names = new Map();
  const before = new Set();
  for (const [file, text] of kSources) {
    for (const [, imported] of text.matchAll(/^import .* from '\.\/(.*)';$/gm)) {
      assert.ok(before.has(imported), `${file} imports ${imported}`);
      assert.ok(kEveryPage.includes(imported) || !kEveryPage.includes(file), `${file} is in every page, ${imported} is not`);
    }
    assert.equal((text.match(/^import /gm) ?? []).length, (text.match(/^import .*;$/gm) ?? []).length, `${file}: imports of more than one line`);
    assert.doesNotMatch(text, /^export (default|\{|\*)/m);
    for (const [, name] of text.matchAll(/^(?:export )?(?:async )?(?:function\*?|class|const|let)\s+(\w+)/gm)) {
      assert.ok(!names.has(name), `${name} in ${file} and ${names.get(name)}`);
      names.set(name, file);
    }
    before.add(file);
  }
});

test('The page never makes markup out of text, and fits into 150 kB', () => {
  const whole = kSources.map(([, text]) => text).join('');
  assert.doesNotMatch(whole, /innerHTML|outerHTML|insertAdjacentHTML|document\.write|eval\(|new Function|setAttribute\('style'/);
  assert.doesNotMatch(whole, /<\/script|\)embedded"/);
  assert.doesNotMatch(whole, /https?:\/\/(?!www\.w3\.org\/2000\/svg)/);
  const common = kSources.filter(([name]) => kEveryPage.includes(name)).map(([, text]) => text).join('');
  const embedded = common.split('\n').filter((line) => !/^( *(\/\/|\/\*\*|\*( |\/))|import )/.test(line)).join('\n');
  assert.ok(embedded.length <= 150000, `${embedded.length} bytes`);
});

test('The sample is as long as the tests say', () => {
  assert.equal(sampleRecord().frames, kFrames);
});

test('Decisions that were played again are events with their choices, nonsense is left out', () => {
  const record = sampleRecord();
  const choice = (text, target, ...worths) => ({text, target, worths});
  const decision = {cycle: 30, player: 'r2', cost: [0.25, 0.125, 0.5], better: 1, choices: [choice('pass', null, 0, -1), choice('clear', [10, -3], 0.5, 0)]};
  record.review = [decision, null, 7, {...decision, player: 'x9'}, {...decision, cycle: 'a'}, {...decision, better: 0}, {...decision, better: 2},
    {...decision, cost: [1]}, {...decision, choices: [choice('pass', null), choice('clear', null)]}, {...decision, choices: 'none'}, {...decision, cycle: 10, player: 'l7'}];
  const found = eventsOf(record).filter(({kind}) => kind === 'costly');
  assert.deepEqual(found.map(({frame, side, text}) => [frame, side, text]), [
    [10, 'left', 'Cost 0.25 goals: Azure 7, pass; better: clear'], [30, 'right', 'Cost 0.25 goals: Amber 2, pass; better: clear']]);
  assert.deepEqual(found[1].replayed.choices.map(({mean, target}) => [mean, target]), [[-0.5, null], [0.25, [10, -3]]]);
  assert.equal(replayedAt(record, 24)?.frame, 10);
  assert.equal(replayedAt(record, 29), undefined);
  assert.equal(replayedAt(record, 30)?.slot, found[1].slot);
  assert.equal(replayedAt(record, 44)?.frame, 30);
  assert.equal(replayedAt(record, 45), undefined);
  assert.equal(signed(-0.125) + signed(0.5), '\u22120.13+0.50');
  record.review = /** @type {any} */ ('nonsense');
  assert.deepEqual(eventsOf(record).filter(({kind}) => kind === 'costly'), []);
});

test('Missed decisions are events, neighboring ones together', () => {
  const record = sampleRecord();
  const missed = (cycle, stopped, player, reason = 'deadline') => [cycle, stopped, player, reason];
  record.missed = [missed(10, 0, 'l7'), missed(30, 0, 'r2'), missed(31, 0, 'r2'), missed(33, 0, 'r3'), missed(100, 7, 'l7', 'error'), missed(5, 0, 'x9'), missed('a', 0, 'l1')];
  const found = eventsOf(record).filter(({kind}) => kind === 'missed');
  assert.deepEqual(found.map(({frame, end, text}) => [frame, end, text]), [
    [10, 10, 'Missed decision: Azure 7, deadline'], [30, 33, '3 missed decisions: 2 players of Amber, deadline'], [107, 107, 'Missed decision: Azure 7, error']]);
  record.missed = /** @type {any} */ ('nonsense');
  assert.deepEqual(eventsOf(record).filter(({kind}) => kind === 'missed'), []);
});
