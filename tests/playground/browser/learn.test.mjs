// The tutorial beside the field: its steps, what each tries, and when it is done.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test, { after, before } from 'node:test';
import { resultMatches, startSite, whenShown } from './site.mjs';

const LONG = 500_000; // ms, on a host that does other things, too
const tutorial = readFileSync(new URL('../../../docs/tutorial.md', import.meta.url), 'utf8');

let site;
before(async () => {
  site = await startSite();
});
after(() => site?.close());

const lesson = (page) => page.locator('#learn');
const press = (page, name) => lesson(page).getByRole('button', { name, exact: true }).click();
const state = (page, text) => page.locator('.lesson-state').filter({ hasText: text }).waitFor({ timeout: LONG });

/** The address of a heading, as links have it. */
const anchorOf = (heading) => heading.toLowerCase().replace(/[^a-z0-9 -]/g, '').replaceAll(' ', '-');

test('the steps are those that docs/tutorial.md marks, and their match is that of its commands', async () => {
  const { page, context } = await site.open('#learn=the-first-match');
  await page.locator('[data-lesson]').first().waitFor();
  const steps = await page.locator('[data-lesson]').evaluateAll((buttons) => buttons.map(({ dataset }) => dataset.lesson));
  const marked = [...tutorial.matchAll(/^## (.*)\n\n<!-- a step of the page -->$/gm)].map(([, heading]) => anchorOf(heading));
  assert.deepEqual([...steps].sort(), marked.sort());
  const { seed, cycles } = await page.evaluate(() => window.clsPlayground.chosenMatch());
  assert.ok(tutorial.includes(`\ncls match ada mock --cycles ${cycles} --seed ${seed}\n`), `${cycles} cycles, seed ${seed}`);
  await context.close();
});

test('a link to a step plays nothing, and the steps lead to a team that wins', async () => {
  const { page, problems, context } = await site.open('#learn=the-first-match');
  assert.match(await lesson(page).getByRole('heading').textContent(), /^1\. The first match$/);
  await page.waitForFunction(() => window.clsPlayground.sandbox, null, { timeout: LONG });
  await page.waitForTimeout(1000);
  assert.equal(await page.locator('#result').textContent(), 'Nothing is played yet.');
  assert.equal(page.workers().length, 0, 'nothing runs');

  await press(page, 'Play the match');
  await state(page, '✓ Done. Your team has played: 0 : 0.');
  await press(page, 'Next step');
  assert.equal(new URL(page.url()).hash, '#learn=the-first-change-that-wins');
  await press(page, 'Play the match again');
  await state(page, /^0 : 0: your team has not won/);
  await press(page, 'Make the change');
  assert.match(await page.evaluate(() => window.clsPlayground.editor.files['decide.js']), /actions\.shoot\(\), actions\.planAttack\(\), actions\.watchBall\(0\)\] };\n {2}}\n/);
  await press(page, 'Make the change');
  await state(page, /has no place for this/);
  await press(page, 'Play the match again');
  await state(page, '✓ Done. Your team wins the match, 2 : 0.');

  // What is done stays done, and the next visit begins with what is left.
  await page.goto('about:blank');
  await page.goto(site.url);
  await whenShown(page);
  await page.click('.steps [data-step=learn]');
  assert.match(await lesson(page).getByRole('heading').textContent(), /^3\. Is it better\?$/);
  assert.deepEqual(await page.locator('[data-lesson]').allTextContents(), ['✓', '✓', '3', '4', '5']);
  assert.deepEqual(problems, []);
  await context.close();
});

test('the step about failures shows the line, and the keyboard leads through the steps', async () => {
  const { page, problems, context } = await site.open();
  await whenShown(page);
  await page.locator('.steps [data-step=learn]').focus();
  await page.keyboard.press('Enter');
  await page.locator('[data-lesson=when-something-fails]').focus();
  await page.keyboard.press('Enter');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), '4. When something fails');
  assert.equal(await page.locator('[data-lesson][aria-current=step]').getAttribute('aria-label'), '4. When something fails');

  await page.keyboard.press('Tab'); // the steps
  for (let i = 0; i < 5; ++i) await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Add a mistake');
  await page.keyboard.press('Enter');
  await press(page, 'Play the match');
  await state(page, '✓ Done. The mistake is found: decide.js, line 7.');
  assert.match(await resultMatches(page, /cycles at/, LONG), /1500 cycles/);
  await page.locator('#output button.line').first().click();
  assert.equal(await page.locator('.cm-activeLineGutter').first().textContent(), '7');
  await press(page, 'Take it back');
  assert.doesNotMatch(await page.evaluate(() => window.clsPlayground.editor.files['decide.js']), /no plan/);

  await press(page, 'Next step');
  const [download] = await Promise.all([page.waitForEvent('download'), press(page, 'Download the project')]);
  assert.equal(download.suggestedFilename(), 'mine.zip');
  await state(page, '✓ Done. Unpack the project');
  assert.deepEqual(problems, []);
  await context.close();
});

test('a link to a step that does not exist says so', async () => {
  const { page, context } = await site.open('#learn=nothing');
  await page.locator('#banner').filter({ hasText: 'the tutorial has no such step' }).waitFor();
  await page.locator('#banner').getByRole('button', { name: 'Open the tutorial' }).click();
  assert.match(await lesson(page).getByRole('heading').textContent(), /^1\. The first match$/);
  await context.close();
});
