// Settings and situations of a match, in the page, in links and under cls match; and what the visitor saves of it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';
import { hashOfCls, sha256, unzip, wordsOfReadme } from './cls_match.mjs';
import { playedHash, resultMatches, sharedLink, startSite, whenShown, writeCode } from './site.mjs';

const packages = fileURLToPath(new URL('../../../examples/javascript/node_modules', import.meta.url));
const skip = existsSync(`${packages}/@grpc/proto-loader`) ? false : 'no packages of examples/javascript (examples/javascript/run build)';

let site;
let folder; // with a book
before(async () => {
  site = await startSite();
  folder = mkdtempSync(path.join(os.tmpdir(), 'cls-settings-'));
  const cls = (...words) => execFileSync(process.env.CLS, words, { cwd: folder, stdio: ['ignore', 'ignore', 'pipe'] });
  cls('match', 'mock:simple', 'mock:simple', '--seed', '3', '--cycles', '1500', '--dir', 'recorded');
  cls('book', 'make', 'recorded', '--out', 'moments.book.gz');
});
after(async () => {
  await site?.close();
  if (folder) rmSync(folder, { recursive: true });
});

/** The page with a match of bundled teams chosen. */
async function opened(hash = '') {
  const one = await site.open(hash);
  if (hash === '') {
    await whenShown(one.page);
    await one.page.selectOption('[name=left]', 'mock:simple');
  }
  return one;
}

test('half time and parameters are those of cls match, and go with a link', async () => {
  const { page, problems, context } = await opened();
  await page.click('.more summary');
  await page.fill('[name=half]', '8');
  await page.fill('[name=set]', 'server::kick_rand=0\n\nplayer::pt_max=2');
  assert.equal(await page.locator('.more summary').textContent(), 'More (3)');
  await page.click('#play');
  assert.ok(!await page.locator('.more-body').isVisible(), 'the form is out of the way');
  const hash = await playedHash(page);
  const words = ['mock:simple', 'mock:simple', '--seed', '7', '--half-time', '8', '--set', 'server::kick_rand=0', '--set', 'player::pt_max=2'];
  assert.equal(hash, hashOfCls(words));

  const other = await opened((await sharedLink(page)).hash);
  await other.page.locator('#banner').filter({ hasText: 'seed 7, with settings' }).waitFor();
  await other.page.locator('#banner').getByRole('button').click();
  assert.equal(await playedHash(other.page), hash);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.context.close();
  await context.close();
});

test('a parameter that is wrong is told, by the form or by the engine', async () => {
  const { page, context } = await opened();
  await page.click('.more summary');
  await page.fill('[name=set]', 'kick_rand=0');
  await page.click('#play');
  assert.match(await page.locator('[name=set]').evaluate((field) => field.validationMessage), /^Not server::NAME=VALUE .*: kick_rand=0$/);
  await page.fill('[name=set]', 'server::kick_rnd=0');
  await page.click('#play');
  await resultMatches(page, /kick_rnd.*kick_rand/);
  await context.close();
});

test('a situation of a book is that of cls match, and goes with a link', async () => {
  const { page, problems, context } = await opened();
  await page.click('.more summary');
  assert.ok(!await page.locator('[name=situation]').isVisible());
  await page.setInputFiles('[name=file]', path.join(folder, 'recorded/result.json'));
  await page.locator('.more .problem').filter({ hasText: 'result.json: not a book of situations (cls.book/1).' }).waitFor();
  await page.setInputFiles('[name=file]', path.join(folder, 'moments.book.gz'));
  await page.locator('[name=situation]').waitFor();
  assert.match(await page.locator('[name=situation]').textContent(), /(attack|defense|set play|turnover) at \d+, simple_l : simple_r/);
  await page.selectOption('[name=situation]', '1');
  await page.fill('[name=situationCycles]', '40');
  await page.click('#play');
  const hash = await playedHash(page);

  const { book } = await page.evaluate(() => window.clsPlayground.chosenMatch());
  const file = path.join(folder, 'one.book');
  execFileSync('python3', ['-c', 'import sys; open(sys.argv[1], "w").write(sys.argv[2])', file, book]);
  assert.equal(hash, hashOfCls(['mock:simple', 'mock:simple', '--seed', '7', '--book', file, '--situations', '1', '--cycles', '40']));

  const link = (await sharedLink(page)).hash;
  assert.ok(link.length < 20_000, `${link.length} characters`);
  const other = await opened(link);
  await other.page.locator('#banner').filter({ hasText: 'seed 7, a situation' }).waitFor();
  await other.page.locator('#banner').getByRole('button').click();
  assert.equal(await playedHash(other.page), hash);

  await page.click('.more summary');
  await page.selectOption('[name=situation]', '');
  assert.equal((await page.evaluate(() => window.clsPlayground.chosenMatch())).book, null);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.context.close();
  await context.close();
});

const CODE = `export function decide(state) {
  const { self } = state.world_model;
  if (state.world_model.game_mode_type !== 'PlayOn') return { actions: [{ helios_set_play: {} }] };
  return { actions: [self.is_kickable ? { kick: { power: 100, relative_direction: 0 } } : { body_intercept: {} }] };
}
`;

/** Plays a match of 60 cycles of code that the visitor wrote. */
async function playCode(page) {
  await page.click('.steps [data-step=write]');
  await page.fill('#team-name', 'Blue');
  await page.locator('#team-name').blur();
  await writeCode(page, CODE);
  await page.evaluate(() => document.querySelector('#match-form [name=cycles]').append(new Option('60 cycles', '60')));
  await page.selectOption('#match-form [name=cycles]', '60');
  await page.click('#play');
  return playedHash(page);
}

test('a project plays the match of the page under cls match', { skip }, async () => {
  const { page, problems, context } = await opened();
  await page.click('.steps [data-step=improve]');
  await page.click('#keep');
  await page.click('.steps [data-step=write]');
  await page.selectOption('[name=right]', 'kept'); // its folder is opponent
  const hash = await playCode(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-project')]);
  assert.equal(download.suggestedFilename(), 'Blue.zip');

  const project = path.join(folder, 'Blue');
  unzip(await download.path(), project);
  for (const team of [project, path.join(project, 'opponent')]) symlinkSync(packages, path.join(team, 'node_modules'));
  const words = wordsOfReadme(readFileSync(path.join(project, 'README.md'), 'utf8'));
  assert.equal(hash, hashOfCls(words, project));

  // The side of cls.toml, and its scenarios.
  const tested = execFileSync(process.env.CLS, ['test', 'tests/', '--filter', 'kicks_off'], { cwd: project, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  assert.match(tested, /kicks_off/);
  assert.deepEqual(problems, []);
  await context.close();
});

test('the replay page shows the match and its decisions, and cls reads it', async () => {
  const { page, context } = await opened();
  const hash = await playCode(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-replay')]);
  const file = path.join(folder, 'match.html');
  await download.saveAs(file);
  execFileSync(process.env.CLS, ['convert', file, path.join(folder, 'back.rcg')], { stdio: ['ignore', 'ignore', 'pipe'] });
  assert.equal(sha256(readFileSync(path.join(folder, 'back.rcg'))), hash, 'the game log comes back from the page');

  const replay = await context.newPage();
  const wrong = [];
  replay.on('pageerror', (error) => wrong.push(error.message));
  replay.on('console', (message) => ['error', 'warning'].includes(message.type()) && wrong.push(message.text()));
  await replay.goto(`file://${file}`);
  await replay.waitForFunction(() => window.clsViewer?.viewer.record.frames > 50);
  assert.match(await replay.title(), /^Blue \d+ : \d+ simple$/);
  await replay.evaluate(() => window.clsViewer.viewer.seek(40));
  await replay.getByRole('tab', { name: 'Decision' }).click();
  await replay.locator('.decision .actions li').first().waitFor();
  assert.deepEqual(wrong, []);
  await context.close();
});

test('the replay page of bundled teams has no decisions', async () => {
  const { page, context } = await opened();
  await page.click('.more summary');
  await page.fill('[name=half]', '3');
  await page.click('#play');
  await playedHash(page);
  assert.ok(!await page.locator('#save-project').isVisible(), 'there is no code to save');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-replay')]);
  const file = path.join(folder, 'bundled.html');
  await download.saveAs(file);
  const replay = await context.newPage();
  await replay.goto(`file://${file}`);
  await replay.waitForFunction(() => window.clsViewer?.viewer.record.frames > 50);
  assert.equal(await replay.getByRole('tab', { name: 'Decision' }).count(), 0);
  await context.close();
});
