// The core of the page in Firefox, beside Chromium: the same matches, and teams that are contained.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { launchFirefox } from '../../viewer/browser/browser.mjs';
import { hashOfCls } from './cls_match.mjs';
import { expectNothingReached } from './spy.mjs';
import { fieldOf, playedHash, resultMatches, sharedLink, startSite, viewerFrame, whenShown, writeCode } from './site.mjs';

const LONG = 500_000; // ms, on a host that does other things, too
const skip = process.env.FIREFOX ? false : 'no Firefox (apt-get install firefox-esr)';
const CODE = `export function decide(state) {
  const { self } = state.world_model;
  if (state.world_model.game_mode_type !== 'PlayOn') return { actions: [{ helios_set_play: {} }] };
  return { actions: [self.is_kickable ? { kick: { power: 100, relative_direction: Math.sin(self.body_direction) } } : { body_intercept: {} }] };
}
export function decideAsCoach() { return {}; }
`;

let firefox;
let chromium;
before(async () => {
  if (skip) return;
  firefox = await startSite(process.env.CLS_PAGE, launchFirefox);
  chromium = await startSite();
});
after(async () => {
  await firefox?.close();
  await chromium?.close();
});

/** The page at a step, with a short match chosen. */
async function atStep(site, step, cycles = 60) {
  const opened = await site.open();
  await whenShown(opened.page, 1, LONG);
  await opened.page.click(`.steps [data-step=${step}]`);
  await opened.page.evaluate((length) => document.querySelector('#match-form [name=cycles]').append(new Option(`${length} cycles`, length)), cycles);
  await opened.page.selectOption('#match-form [name=cycles]', String(cycles));
  return opened;
}

/** Plays the link of one browser in another one, and changes its seed: the links and hashes of both matches. */
async function passOn(site, hash, seed) {
  const { page, context, problems } = await site.open(hash);
  await page.locator('#banner').getByRole('button', { name: 'Play this match' }).click({ timeout: LONG });
  const played = await playedHash(page);
  await page.fill('[name=seed]', String(seed));
  await page.click('#play');
  const next = await playedHash(page);
  const link = (await sharedLink(page)).hash;
  assert.deepEqual(problems, []);
  await context.close();
  return { played, next, link };
}

test('a match shows in Firefox, and has the bytes of cls match', { skip }, async (t) => {
  const began = Date.now();
  const { page, problems, context } = await atStep(firefox, 'watch', 300);
  t.diagnostic(`first picture and choice after ${Date.now() - began} ms`);
  await page.selectOption('[name=right]', 'mock:planner');
  await page.click('#play');
  assert.equal(await playedHash(page), hashOfCls(['mock:planner', 'mock:planner', '--seed', '7', '--cycles', '300']));
  assert.deepEqual(problems, []);
  await context.close();
});

test('a link of one browser is the same match in the other', { skip }, async () => {
  const { page, context } = await atStep(firefox, 'write');
  await writeCode(page, CODE);
  await page.click('#play');
  const inFirefox = await playedHash(page);
  const link = (await sharedLink(page)).hash;
  await context.close();

  const first = await passOn(chromium, link, 99);
  assert.equal(first.played, inFirefox);
  const second = await passOn(firefox, first.link, 100);
  assert.equal(second.played, first.next);
  assert.notEqual(second.next, second.played);
});

test('a team is written, played and understood in Firefox', { skip }, async () => {
  const { page, problems, context } = await atStep(firefox, 'write');
  await page.locator('.cm-content').focus();
  await page.keyboard.press('Control+Enter');
  assert.match(await resultMatches(page, /cycles at/, LONG), /^mine \d+ : \d+ simple, 60 cycles/);
  await viewerFrame(page).evaluate(() => window.clsViewer.viewer.seek(40));
  await fieldOf(page).getByRole('tab', { name: 'Decision' }).click();
  await fieldOf(page).locator('.decision .actions li').first().waitFor();
  assert.deepEqual(problems, []);
  await context.close();
});

const CASES = [
  ['throws', `export function decide(state) {\n  return state.nothing.here;\n}\n`, /TypeError.*\(decide\.js:2\)/],
  ['is not JavaScript', `const x = 1;\nconst y = ;\n`, /SyntaxError.*\(decide\.js:2\)/],
  ['never returns', `export function decide() {\n  for (;;);\n}\n`, /has not returned for 5 s/],
];
for (const [what, code, expected] of CASES) {
  test(`a team that ${what} is told so in Firefox`, { skip }, async () => {
    const { page, context } = await atStep(firefox, 'write');
    await writeCode(page, code);
    await page.click('#play');
    await resultMatches(page, expected, LONG);
    await context.close();
  });
}

test('a team reaches neither network nor storage in Firefox', { skip }, async () => {
  const { page, context } = await atStep(firefox, 'write');
  await expectNothingReached(page, firefox);
  await context.close();
});

test('steps of the tutorial and a comparison work in Firefox', { skip }, async () => {
  const { page, problems, context } = await firefox.open('#learn=the-first-match');
  await page.locator('#learn').getByRole('button', { name: 'Play the match' }).click({ timeout: LONG });
  await page.locator('.lesson-state').filter({ hasText: '✓ Done. Your team has played: 0 : 0.' }).waitFor({ timeout: LONG });
  await page.click('[data-lesson=is-it-better]');
  await page.selectOption('#compare-form [name=cycles]', '1000');
  await page.locator('#learn').getByRole('button', { name: 'Compare' }).click();
  await page.locator('.verdict-panel').filter({ hasText: '1 matches' }).waitFor({ timeout: LONG });
  await page.click('#stop');
  await page.locator('.verdict').filter({ hasText: 'Undecided' }).waitFor({ timeout: LONG });
  assert.deepEqual(problems, []);
  await context.close();
});
