// A team of the visitor's own: written, played, understood, compared, and ended where it misbehaves.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import test, { after, before } from 'node:test';
import { expectNothingReached } from './spy.mjs';
import { fieldOf, resultMatches, startSite, viewerFrame, whenShown, writeCode } from './site.mjs';

const LONG = 500_000; // ms, on a host that does other things, too

let site;
before(async () => {
  site = await startSite();
});
after(() => site?.close());

/** The page at the step Write, with a match of `cycles` chosen. */
async function atWrite(cycles = '1000') {
  const opened = await site.open();
  await whenShown(opened.page);
  await opened.page.click('.steps [data-step=write]');
  await opened.page.selectOption('#match-form [name=cycles]', cycles);
  return opened;
}

const output = (page) => page.locator('#output').textContent();
const codeOf = (page) => page.evaluate(() => window.clsPlayground.editor.files['decide.js']);

test('the first team plays, and beats simple after one edit', async () => {
  const { page, problems, context } = await atWrite();
  assert.equal(await page.inputValue('[name=left]'), 'mine');
  assert.equal(await page.inputValue('[name=right]'), 'mock:simple');
  const code = await codeOf(page);
  const kick = 'actions.smartKick(GOAL, 3, 0.1, 3)';
  assert.ok(code.includes(kick));
  await writeCode(page, code.replace(kick, 'actions.planAttack()'));
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+Enter');
  const result = await resultMatches(page, /cycles at|ended|usable/, LONG);
  const [, mine, simple] = /^mine (\d+) : (\d+) simple, 1000 cycles/.exec(result) ?? assert.fail(result);
  assert.ok(Number(mine) > Number(simple), result);
  assert.deepEqual(problems, []);

  // Understand: what a player was asked for and did.
  const field = fieldOf(page);
  await viewerFrame(page).evaluate(() => window.clsViewer.viewer.seek(400));
  await field.getByRole('tab', { name: 'Decision' }).click();
  await field.locator('.decision .actions li').first().waitFor();
  assert.match(await field.locator('.decision .actions').textContent(), /helios_(offensive_planner|basic_move)|body_|helios_/);
  assert.deepEqual(problems, []);
  await context.close();
});

test('the code and its name last for the next visit, and download as a project', async () => {
  const { page, context } = await atWrite();
  await page.fill('#team-name', 'Blue');
  await page.locator('#team-name').blur();
  await writeCode(page, `// mine\n${await codeOf(page)}`);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#download-team')]);
  assert.equal(download.suggestedFilename(), 'Blue.zip');
  const names = execFileSync('python3', ['-c', 'import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; print(" ".join(z.namelist()), z.read("src/decide.js")[:7], "teams.Blue" in str(z.read("cls.toml")))', await download.path()], { encoding: 'utf8' });
  for (const name of ['README.md', 'run', 'cls.toml', 'proto/playmaker.proto', 'src/main.js', 'src/actions.js', 'src/situation.js', 'tests/scores.json']) {
    assert.ok(names.split(' ').includes(name), `${name} in ${names}`);
  }
  assert.match(names, /b'\/\/ mine' True\n$/);

  await page.reload();
  await whenShown(page);
  assert.match(await codeOf(page), /^\/\/ mine\n/);
  assert.equal(await page.inputValue('#team-name'), 'Blue');
  await context.close();
});

const AFTER = 'export function decideAsCoach() { return {}; }\n';
const HOLD = `export function decide() { return { actions: [] }; }\n${AFTER}`;
const CASES = [
  ['throws', `export function decide(state) {\n  return state.nothing.here;\n}\n${AFTER}`, /TypeError.*\(decide\.js:2\)/],
  ['throws in a module that it imports', null, /RangeError: too far.*\(situation\.js:2\)/],
  ['throws when it loads', `const x = 1;\nnull.place;\n${HOLD}`, /TypeError.*\(decide\.js:2\)/],
  ['is not JavaScript', `const x = 1;\nconst y = ;\n${HOLD}`, /SyntaxError.*\(decide\.js:2\)/],
  ['imports what is not there', `\nimport fs from 'node:fs';\n${HOLD}`, /no module 'node:fs' here; there are '\.\/actions\.js' and '\.\/situation\.js' \(decide\.js:2\)/],
  ['exports no decide', 'export const decision = 1;\n', /decide\.js exports no function decide/],
  ['returns nonsense', `export function decide() {\n  return { actions: 7 };\n}\n${AFTER}`, /protos\.PlayerActions\.actions: array expected/],
  ['returns a promise', `export async function decide() {\n  return { actions: [] };\n}\n${AFTER}`, /decide is async/],
  ['never returns', `export function decide() {\n  for (;;);\n}\n${AFTER}`, /has not returned for 5 s.*A loop without an end\?/],
  ['never finishes loading', `for (;;);\n${HOLD}`, /has not returned for 5 s/],
  ['allocates without end', `const all = [];\nexport function decide() {\n  for (;;) all.push(new Array(1e6).fill(0).map(Math.random));\n}\n${AFTER}`, /The match was ended|memory/],
  ['allocates buffers without end', `const all = [];\nexport function decide() {\n  for (;;) all.push(new Float64Array(1e8).fill(1));\n}\n${AFTER}`, /RangeError.*\(decide\.js:3\)|The match was ended/],
];

for (const [what, code, expected] of CASES) {
  test(`a team that ${what} is told so, and the page goes on`, async () => {
    const { page, problems, context } = await atWrite();
    if (code) {
      await writeCode(page, code);
    } else {
      await writeCode(page, "import { far } from './situation.js';\nexport function decide() {\n  return far();\n}\n");
      await page.click('#files [data-file="situation.js"]');
      await writeCode(page, "export function far() {\n  throw new RangeError('too far');\n}\n");
    }
    await page.click('#play');
    const result = await resultMatches(page, expected, LONG);
    assert.ok((await output(page)).includes(result.slice(-30)));
    const [, file, line] = /\(([\w.]+):(\d+)\)/.exec(result) ?? [];
    if (file) {
      assert.equal(await page.locator('#files [aria-selected=true]').textContent(), file);
      assert.equal(await page.locator('.cm-activeLineGutter').first().textContent(), line);
    }

    // Nothing is left that could disturb the next match.
    await page.evaluate(() => window.clsPlayground.editor.open('decide.js'));
    await writeCode(page, HOLD);
    await page.click('#play');
    await whenShown(page, 1, LONG);
    assert.deepEqual(problems, []);
    await context.close();
  });
}

test('a team that floods the console is cut short', async () => {
  const { page, context } = await atWrite();
  await writeCode(page, `export function decide() {\n  for (let i = 0; i < 2000; ++i) console.log('line', i, { deep: [i] });\n  return { actions: [] };\n}\n${AFTER}`);
  await page.click('#play');
  await page.waitForFunction(() => /and \d+ lines more/.test(document.getElementById('output').textContent), null, { timeout: LONG });
  assert.match(await output(page), /left: line 0 \{"deep":\[0\]\}/);
  assert.ok(await page.locator('#output > *').count() <= 500);
  await context.close();
});

test('a team reaches neither network nor storage', async () => {
  const { page, context } = await atWrite();
  await expectNothingReached(page, site);
  await context.close();
});

test('pairs of matches play on all cores until the verdict of cls compare, which the tutorial hears', async () => {
  const { page, problems, context } = await atWrite();
  const code = await codeOf(page);
  // The players of the kept version stay where they are: a team that kicks at the goal beats them soon.
  await writeCode(page, HOLD);
  await page.click('.steps [data-step=improve]');
  await page.click('#keep');
  await page.evaluate((text) => window.clsPlayground.editor.replace('decide.js', text), code);

  await page.click('.steps [data-step=learn]');
  await page.click('[data-lesson=is-it-better]');
  assert.equal(await page.inputValue('#compare-form [name=base]'), 'kept');
  assert.equal(await page.inputValue('#compare-form [name=cycles]'), '3000');
  await page.evaluate(() => document.querySelector('#compare-form [name=cycles]').append(new Option('500 cycles', '500')));
  await page.selectOption('#compare-form [name=cycles]', '500');
  await page.locator('#learn').getByRole('button', { name: 'Compare' }).click();
  const headline = page.locator('.verdict');
  await headline.filter({ hasText: /Mine is better than the kept version/ }).waitFor({ timeout: 2 * LONG });
  assert.equal(await page.locator('.verdict-panel').getAttribute('data-decision'), 'H1');
  assert.match(await page.locator('.verdict-panel').textContent(), /\+\d+ Elo .*6 pairs, 1[2-4] matches/);
  assert.ok(await page.locator('#stop').isDisabled());
  await page.locator('.lesson-state').filter({ hasText: 'Done. Your team is better' }).waitFor();
  assert.deepEqual(problems, []);
  await context.close();
});

test('a comparison stops when the visitor says so, and names a team that fails', async () => {
  const { page, context } = await atWrite();
  await page.click('.steps [data-step=improve]');
  await page.click('#compare');
  await page.locator('.verdict-panel').waitFor({ timeout: LONG });
  await page.click('#stop');
  await page.locator('.verdict').filter({ hasText: 'Undecided' }).waitFor({ timeout: LONG });

  await page.click('.steps [data-step=write]');
  await writeCode(page, `export function decide() {\n  throw new Error('no idea');\n}\n${AFTER}`);
  await page.click('.steps [data-step=improve]');
  await page.click('#keep');
  assert.equal(await page.inputValue('#compare-form [name=base]'), 'kept');
  await page.click('#compare');
  await page.locator('#compare-problem').filter({ hasText: /no idea/ }).waitFor({ timeout: LONG });
  assert.ok(await page.locator('#compare').isEnabled());
  await context.close();
});
