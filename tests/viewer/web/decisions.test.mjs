// Recorded decisions: the decoder, how they belong to frames, and what the page says about them.
import assert from 'node:assert/strict';
import test from 'node:test';
import {consideredActions, consideredTitle} from '../../../viewer/web/src/decision_plan.js';
import {DecisionStore} from '../../../viewer/web/src/decision_store.js';
import {DecisionTrack, executedCommands, makerText, missText, requestedActions} from '../../../viewer/web/src/decision_track.js';
import {TeamDecisions} from '../../../viewer/web/src/decisions.js';
import {DrawingFilter, drawingsOf, levelsIn} from '../../../viewer/web/src/drawings.js';
import {scenarioOfMoment} from '../../../viewer/web/src/moment_scenario.js';
import {StreamDecoder} from '../../../viewer/web/src/stream.js';
import {kDrawnFrame, kMissedFrame, kWorstFrame, sampleDecisionStream} from './sample_decisions.mjs';
import {kFrames, kGoalFrame, sampleStream} from './sample_match.mjs';

function sampleRecord() {
  const decoder = new StreamDecoder();
  for (const _ of decoder.push(sampleStream()));
  return decoder.record;
}

const sampleTrack = () => new DecisionTrack(sampleRecord(), 6, new TeamDecisions(sampleDecisionStream()).player(7));
const near = (a, b) => assert.ok(Math.abs(a - b) < 0.011, `${a} is not ${b}`);

test('TeamDecisions decodes the players that are recorded', () => {
  const team = new TeamDecisions(sampleDecisionStream());
  assert.equal(team.header.team, 'Azure');
  assert.equal(team.player(8), null);
  const player = team.player(7);
  assert.equal(player, team.player(7));
  assert.equal(player.count, kFrames);
  assert.equal(player.commands[200], '(dash 100)(turn_neck 200)');
  assert.equal(player.latencies[299], 1799);
  assert.equal(player.value('age', 10, 12), 12);
  assert.equal(player.value('no_such_column', 10), -1);
});

test('TeamDecisions refuses what is cut, corrupt, or newer', () => {
  const stream = sampleDecisionStream();
  assert.throws(() => new TeamDecisions(stream.subarray(0, 5000)), /incomplete/);
  const changed = Buffer.from(stream);
  changed[3000] ^= 1;
  assert.throws(() => new TeamDecisions(changed), /corrupt/);
  const newer = Buffer.from(stream);
  newer.write('cls.decisions/2', newer.indexOf('cls.decisions/1'));
  assert.throws(() => new TeamDecisions(newer), /format cls.decisions\/2; write the page again/);
});

test('DecisionTrack finds the decision of each frame, stopped clock included', () => {
  const track = sampleTrack();
  assert.equal(track.at(5), 5);
  assert.equal(track.at(kGoalFrame + 7), kGoalFrame + 7);
  assert.equal(track.at(kFrames - 1), kFrames - 1);
  assert.equal(track.at(kFrames), -1);
});

test('DecisionTrack compares estimates with the full state', () => {
  const track = sampleTrack();
  const rows = track.rows(10);
  assert.deepEqual(rows.slice(0, 2).map(({name}) => name), ['self', 'ball']);
  assert.equal(rows.length, 7);
  near(rows[0].error, 0.5);
  near(rows[1].error, 1);
  near(rows[2].error, 2);
  assert.ok(rows.slice(2).every(({slot}) => slot >= 0 && slot !== 6));
  const unseen = track.playerRow(10, 19);
  assert.equal(unseen.estimated, null);
  assert.ok(Number.isNaN(unseen.error));
  assert.deepEqual(track.unnumbered(10), [{side: -1, x: 1, y: 2, age: 3}]);
});

test('DecisionTrack lists the worst moments, apart from each other', () => {
  const worst = sampleTrack().worstMoments();
  assert.equal(worst[0].frame, kWorstFrame);
  near(worst[0].ballError, 9);
  assert.ok(worst.length >= 3 && worst.length <= 8);
  for (const a of worst) assert.ok(worst.every((b) => a === b || Math.abs(a.decision - b.decision) >= 40));
});

test('A decision reads as text', () => {
  const {decisions} = sampleTrack();
  assert.deepEqual(requestedActions(decisions.replies[3]).map(({outcome}) => outcome), ['not possible', 'executed', 'not tried: an earlier action succeeded']);
  assert.deepEqual(requestedActions(''), []);
  assert.equal(missText(decisions.value('call', kMissedFrame)), 'no reply before the deadline');
  assert.equal(missText(0), '');
  assert.match(makerText(decisions.value('maker', kMissedFrame)), /without a reply/);
  assert.equal(makerText(99), '');
  assert.deepEqual(executedCommands(sampleRecord(), 6, 20), ['dash']);
  assert.deepEqual(executedCommands(sampleRecord(), 6, kFrames - 1), []);
});

test('A decision has what the planner considered', () => {
  const track = sampleTrack();
  assert.deepEqual(track.considered(kWorstFrame), [
    {chosen: true, text: 'pass 9 (12, -4) 45.2', target: [12, -4], value: 45.2, isShare: false},
    {chosen: false, text: 'dribble 7 (1, 1) 30', target: [1, 1], value: 30, isShare: false},
  ]);
  assert.deepEqual(track.considered(kWorstFrame + 1), []);
  assert.match(consideredTitle(track.considered(kWorstFrame)), /^Planner/);
});

test('A decision has the options of a policy, most likely first', () => {
  const considered = consideredActions('- shoot (52.5, 0) 8.1%\n- hold 20%\n- dribble -157.5 deg (-1.5, 2) 20% room 0.5\n* through pass 9 (12.3, -4) 51.9% room 3.1\nnot a line\n');
  assert.deepEqual(considered.map(({chosen, value, target}) => [chosen, value, target]),
    [[true, 51.9, [12.3, -4]], [false, 20, null], [false, 20, [-1.5, 2]], [false, 8.1, [52.5, 0]]]);
  assert.ok(considered.every(({isShare}) => isShare));
  assert.equal(considered[0].text, 'through pass 9 (12.3, -4) 51.9% room 3.1');
  assert.match(consideredTitle(considered), /^Options of the policy/);
  const [chosen] = consideredActions('- hold 50%\n* clear 50%\n');
  assert.equal(chosen.text, 'clear 50%');
});

test('DecisionStore loads a side once, and says why it has nothing', async () => {
  let reads = 0;
  const store = new DecisionStore(sampleRecord(), ['left'], async () => (++reads, new TeamDecisions(sampleDecisionStream())));
  const loaded = new Promise((resolve) => (store.onLoad = resolve));
  assert.equal(store.track(6), null);
  assert.equal(store.track(6), null);
  assert.match(store.problem(6), /^Reading/);
  await loaded;
  assert.equal(store.track(6).slot, 6);
  assert.equal(store.track(7), null);
  assert.match(store.problem(7), /no decisions of this player/);
  assert.match(store.problem(17), /--record-world-models/);
  assert.equal(reads, 1);
  const broken = new DecisionStore(sampleRecord(), ['left'], () => Promise.reject(new Error('the page was truncated')));
  const failed = new Promise((resolve) => (broken.onLoad = resolve));
  broken.track(6);
  await failed;
  assert.equal(broken.problem(6), 'the page was truncated.');
});

test('A moment becomes a scenario of cls test', () => {
  const scenario = JSON.parse(scenarioOfMoment(sampleRecord(), 30, 17));
  assert.equal(scenario.mode, 'play_on');
  assert.deepEqual(scenario.ball, {at: [15.9, 2.9925], velocity: [0.4213, 0]});
  assert.equal(Object.keys(scenario.left.players).length, 11);
  assert.deepEqual(Object.keys(scenario.right.players['7']), ['at', 'body', 'velocity', 'stamina']);
  assert.equal(scenario.right.players['7'].stamina, 7700);
  assert.deepEqual(scenario.expect, [{actions: '*', side: 'right', unum: 7}]);
  assert.equal(scenario.right.playmaker, 'mock');
  assert.match(scenario.about, /does not know the Playmakers: cls test FILE --against SIDE/);
});

test('The scenario of a moment plays the sides of the match', () => {
  const record = sampleRecord();
  record.sides = ['run:./run --port {port}', 'mock'];
  const scenario = JSON.parse(scenarioOfMoment(record, 30, 6));
  assert.deepEqual([scenario.left.playmaker, scenario.right.playmaker], record.sides);
  assert.equal(scenario.under_test, 'left');
  assert.doesNotMatch(scenario.about, /--against/);
});

test('Texts and shapes of a Playmaker are read, on both sides of the pitch', () => {
  const text = sampleTrack().decisions.drawings[kDrawnFrame];
  const drawings = drawingsOf(text, 6);
  assert.deepEqual(drawings[0], {kind: 'circle', filled: true, level: 1024, numbers: [10, 5, 3], text: '', color: '#ff0000'});
  assert.deepEqual(drawings[1].numbers, [-10, -5.25, 0, 0]);
  assert.deepEqual(drawings[2], {kind: 'message', filled: false, level: 65536, numbers: [1, -2], text: 'run here', color: 'white'});
  assert.equal(drawings[3].text, 'plan 7.50, -0, 1234567');
  assert.deepEqual(drawings[4].numbers, [1, 2, 4, 6]);
  const mirrored = drawingsOf(text, 17);
  assert.deepEqual(mirrored[0].numbers, [-10, -5, 3]);
  assert.deepEqual(mirrored[4].numbers, [-1, -2, -4, -6]);
  assert.deepEqual(drawingsOf('8 a 1 2 3 30 60 \n', 17)[0].numbers, [-1, -2, 3, 210, 60]);
  assert.deepEqual(drawingsOf('8 q 1\n8 c 1 2\nno line\n8 c x 2 3', 6), []);
  assert.deepEqual(levelsIn([text, '']).map(([, name]) => name), ['system', 'action', 'kick', 'shoot', 'team']);
});

test('DrawingFilter chooses by level and text', () => {
  const drawings = drawingsOf(sampleTrack().decisions.drawings[kDrawnFrame], 6);
  const filter = new DrawingFilter();
  const shown = () => drawings.filter((drawing) => filter.shows(drawing)).map(({kind}) => kind);
  assert.equal(shown().length, drawings.length);
  filter.level = 65536;
  assert.deepEqual(shown(), ['message', 'text']);
  filter.text = ' RUN';
  assert.deepEqual(shown(), ['message']);
  filter.level = 0;
  filter.text = 'circle';
  assert.deepEqual(shown(), ['circle']);
});
