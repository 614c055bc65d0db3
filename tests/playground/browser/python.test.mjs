// Teams in Python: an interpreter that is loaded on demand, in the same sandbox.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { hashOfCls, unzip, wordsOfReadme } from './cls_match.mjs';
import { playedHash, resultMatches, sharedLink, startSite, whenShown, writeCode } from './site.mjs';

const LONG = 500_000; // ms, on a host that does other things, too
// What ./run of a project needs; Debian's Python has it where others may not.
const hasGrpc = ['python3', '/usr/bin/python3'].some((python) => spawnSync(python, ['-c', 'import grpc, google.protobuf']).status === 0);
const skip = hasGrpc ? false : 'no grpc for Python (apt-get install python3-grpcio python3-protobuf protobuf-compiler-grpc)';

let site;
before(async () => {
  site = await startSite();
});
after(() => site?.close());

/** The page at the step Write, in Python, with a short match chosen. */
async function atPython(cycles = 30) {
  const known = site.requests.length;
  const opened = await site.open();
  const { page } = opened;
  await whenShown(page, 1, LONG);
  assert.deepEqual(site.requests.slice(known).filter((request) => request.includes('pyodide')), [], 'nothing of Python is loaded yet');
  await page.click('.steps [data-step=write]');
  await page.selectOption('#language', 'python');
  await page.evaluate((length) => document.querySelector('#match-form [name=cycles]').append(new Option(`${length} cycles`, length)), cycles);
  await page.selectOption('#match-form [name=cycles]', String(cycles));
  return opened;
}

const KICK = `from cls_playmaker import proto as pb


def decide(state):
    world = state.world_model
    if world.cycle == 3 and world.self.uniform_number == 7:
        print("seven", len(world.teammates), world.self.HasField("position"))
    if world.game_mode_type != pb.PlayOn:
        return pb.PlayerActions(actions=[pb.PlayerAction(helios_set_play=pb.HeliosSetPlay())])
    if world.self.is_kickable:
        return pb.PlayerActions(actions=[pb.PlayerAction(kick=pb.Kick(power=100, relative_direction=0.5))])
    return pb.PlayerActions(actions=[pb.PlayerAction(body_intercept=pb.Body_Intercept())])


def decide_as_trainer(state):
    return pb.TrainerActions()


def decide_as_coach(state):
    return pb.CoachActions()
`;

test('a team in Python plays the match of its project under cls match, and that of its link', { skip }, async () => {
  const { page, problems, context } = await atPython();
  await writeCode(page, KICK);
  await page.click('#play');
  const hash = await playedHash(page);
  assert.match(await page.locator('#output').textContent(), /left: seven \d+ True/);

  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-project')]);
  const folder = mkdtempSync(path.join(os.tmpdir(), 'cls-python-'));
  try {
    unzip(await download.path(), folder);
    execFileSync('./run', ['build'], { cwd: folder, stdio: ['ignore', 'ignore', 'pipe'] });
    assert.equal(hash, hashOfCls(wordsOfReadme(readFileSync(path.join(folder, 'README.md'), 'utf8')), folder));
  } finally {
    rmSync(folder, { recursive: true });
  }

  const { hash: link } = await sharedLink(page);
  const other = await site.open(link);
  await other.page.locator('#banner').getByRole('button', { name: 'Play this match' }).click({ timeout: LONG });
  assert.equal(await playedHash(other.page), hash);
  await other.page.click('.steps [data-step=write]');
  assert.equal(await other.page.inputValue('#language'), 'python');
  assert.deepEqual([...problems, ...other.problems], []);
  await other.context.close();
  await context.close();
});

test("the tutorial's team in Python plays its documented result", async () => {
  const { page, problems, context } = await site.open('#learn=the-first-change-that-wins');
  const learn = page.locator('#learn');
  await page.selectOption('#language', 'python');
  await learn.getByRole('button', { name: 'Make the change' }).click();
  await learn.getByRole('button', { name: 'Play the match again' }).click();
  await page.locator('.lesson-state').filter({ hasText: '✓ Done. Your team wins the match, 2 : 0.' }).waitFor({ timeout: LONG });
  assert.deepEqual(problems, []);

  // A team in each language lasts for the next visit.
  await page.reload();
  assert.equal(await page.inputValue('#language'), 'python');
  assert.match(await page.evaluate(() => window.clsPlayground.editor.files['decide.py']), /plan_attack\(\)/);
  await page.selectOption('#language', 'javascript');
  assert.match(await page.evaluate(() => window.clsPlayground.editor.files['decide.js']), /smartKick/);
  await context.close();
});

const CASES = [
  ['raises', 'def decide(state):\n    return state.nothing\n', /AttributeError: State has no field nothing \(decide\.py:2\)/],
  ['is not Python', 'x = 1\ndef decide(state)\n    return None\n', /SyntaxError.*\(decide\.py:2\)/],
  ['never returns', 'def decide(state):\n    while True:\n        pass\n', /has not returned for 5 s/],
];

test('problems of a team in Python have their line', async () => {
  const { page, problems, context } = await atPython();
  for (const [what, code, expected] of CASES) {
    await writeCode(page, code);
    await page.click('#play');
    const result = await resultMatches(page, expected, LONG);
    const line = /\(decide\.py:(\d+)\)/.exec(result)?.[1];
    if (line) assert.equal(await page.locator('.cm-activeLineGutter').first().textContent(), line, what);
  }
  assert.deepEqual(problems, []);
  await context.close();
});

const SPY = `import js

tried = {}
for name, attempt in {
    "request": lambda: (lambda r: (r.open("GET", "SITE/spy-xhr", False), r.send()))(js.XMLHttpRequest.new()),
    "storage": lambda: js.localStorage.getItem("cls-team"),
    "scripts": lambda: js.importScripts("SITE/spy-scripts.js"),
    "files": lambda: open("/etc/passwd").read(),
}.items():
    try:
        attempt()
        tried[name] = "REACHED"
    except Exception as error:
        tried[name] = "refused"
js.fetch("SITE/spy-fetch")
print("TRIED", sorted(tried.items()))


def decide(state):
    return None
`;

test('a team in Python reaches neither network nor storage', async () => {
  const { page, context } = await atPython();
  const url = site.url.replace(/\/$/, '');
  await writeCode(page, SPY.replaceAll('SITE', url));
  await page.click('#play');
  await page.locator('#output').filter({ hasText: 'TRIED' }).waitFor({ timeout: LONG });
  const output = await page.locator('#output').textContent();
  for (const name of ['request', 'storage', 'scripts', 'files']) assert.ok(output.includes(`('${name}', 'refused')`), output);
  await page.waitForTimeout(500);
  assert.deepEqual(site.requests.filter((request) => request.includes('spy')), []);
  await context.close();
});
