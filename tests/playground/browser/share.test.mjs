// Links: the same match for everyone, nothing of a stranger's runs unasked, broken ones say so.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { playedHash, sharedLink, startSite, whenShown, writeCode } from './site.mjs';

const LONG = 500_000;
const CODE = `export function decide(state) {
  const { self } = state.world_model;
  if (state.world_model.game_mode_type !== 'PlayOn') return { actions: [{ helios_set_play: {} }] };
  return { actions: [self.is_kickable ? { kick: { power: 100, relative_direction: 0 } } : { body_intercept: {} }] };
}
export function decideAsCoach() { return {}; }
`;

let site;
before(async () => {
  site = await startSite();
});
after(() => site?.close());

/** A link to a short match with code, and the hash of its log. */
async function makeLink() {
  const { page, context } = await site.open();
  await whenShown(page);
  await page.click('.steps [data-step=write]');
  await writeCode(page, CODE);
  await page.selectOption('[name=right]', 'mock:hold');
  await page.fill('[name=seed]', '99');
  await page.evaluate(() => document.querySelector('#match-form [name=cycles]').append(new Option('60 cycles', '60')));
  await page.selectOption('#match-form [name=cycles]', '60');
  await page.click('#play');
  const hash = await playedHash(page);
  const link = (await sharedLink(page)).href;
  await context.close();
  return { link, hash };
}

test('a link gives the same match, after the visitor has pressed the button', async () => {
  const { link, hash } = await makeLink();
  assert.ok(link.startsWith(`${site.url}#m=`));
  assert.ok(link.length < 1000, `${link.length} characters`);

  const { page, problems, context } = await site.open(new URL(link).hash);
  const banner = page.locator('#banner');
  await banner.getByRole('button', { name: 'Play this match' }).waitFor({ timeout: LONG });
  assert.match(await banner.textContent(), /mine against hold, seed 99\..*code of the person who made the link/);
  await page.waitForTimeout(2000);
  assert.equal(page.workers().length, 0, 'nothing runs');
  assert.equal(await page.locator('#result').textContent(), 'Nothing is played yet.');

  await banner.getByRole('button').click();
  assert.equal(await playedHash(page), hash);
  await page.click('.steps [data-step=write]');
  assert.equal(await page.evaluate(() => window.clsPlayground.editor.files['decide.js']), CODE);
  assert.deepEqual(problems, []);

  // The stranger's code is not the visitor's own.
  await page.goto('about:blank');
  await page.goto(site.url);
  await whenShown(page);
  assert.notEqual(await page.evaluate(() => window.clsPlayground.editor.files['decide.js']), CODE);
  await context.close();
});

test('a link that arrives while the page is open waits for the button, too', async () => {
  const { link } = await makeLink();
  const { page, context } = await site.open();
  await whenShown(page);
  await page.evaluate((hash) => {
    location.hash = hash;
  }, new URL(link).hash);
  await page.locator('#banner').getByRole('button', { name: 'Play this match' }).waitFor();
  await page.waitForTimeout(1000);
  assert.equal(page.workers().length, 0);
  await context.close();
});

const packed = async (match) => {
  const stream = new Blob([JSON.stringify(match)]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return `#m=${Buffer.from(await new Response(stream).arrayBuffer()).toString('base64url')}`;
};

test('a broken link says what is wrong with it, and the page plays on', async () => {
  const sides = { left: 'mock', right: 'mock', seed: 1 };
  const cases = [
    ['#m=', /cut or changed/], ['#m=AAAA', /cut or changed/], ['#m=!!', /cut or changed/],
    [(await packed({ v: 1, ...sides })).slice(0, -6), /cut or changed/],
    [await packed({ v: 3, ...sides }), /newer version/],
    [await packed({ v: 2, ...sides, set: ['server::half_time=1\nx'] }), /settings/],
    [await packed({ v: 2, ...sides, set: 'server::half_time=1' }), /settings/],
    [await packed({ v: 2, ...sides, set: ["server::half_time=1'; touch x '"] }), /settings/],
    [await packed({ v: 2, ...sides, cycles: 50, book: 'no book' }), /situation/],
    [await packed({ v: 1, left: 'mock', seed: 1 }), /no two teams/],
    [await packed({ v: 1, ...sides, left: { name: '<b>', files: { 'decide.js': '' } } }), /no two teams/],
    [await packed({ v: 1, ...sides, left: { name: 'a', files: { 'decide.js': '', 'other.js': '' } } }), /no two teams/],
    [await packed({ v: 1, ...sides, seed: -1 }), /seed/],
    [await packed({ v: 1, ...sides, cycles: 1e9 }), /length/],
    [await packed({ v: 1, ...sides, left: 'replay:/etc/passwd' }), /no two teams/],
  ];
  const { page, problems, context } = await site.open(cases[0][0]);
  for (const [hash, expected] of cases) {
    await page.evaluate((given) => {
      location.hash = given;
    }, hash);
    await page.locator('#banner').filter({ hasText: expected }).waitFor({ timeout: 20_000 });
    assert.match(await page.locator('#banner').textContent(), /^This link is broken: /);
  }
  await page.locator('#banner').getByRole('button', { name: 'Play another match' }).click();
  await whenShown(page, 1, LONG);
  assert.equal(new URL(page.url()).hash, '');
  assert.deepEqual(problems, []);
  await context.close();
});
