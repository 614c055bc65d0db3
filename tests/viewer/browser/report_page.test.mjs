// Reports of a match and of a tournament in Chromium, from disk. They are played by the built cls: $CLS, or build/bin/cls.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';

const {chromium} = createRequire(import.meta.url)('playwright-core');
const kAxe = createRequire(import.meta.url).resolve('axe-core');
const kCls = process.env.CLS ?? fileURLToPath(new URL('../../../build/bin/cls', import.meta.url));
const kSkip = fs.existsSync(kCls) ? false : `no ${kCls}; build it or set CLS`;
const kFolder = fs.mkdtempSync(path.join(os.tmpdir(), 'cls-reports-'));
const kViews = [{colorScheme: 'light'}, {colorScheme: 'dark'}, {viewport: {width: 360, height: 800}}];

const kTournament = `[tournament]
name = "<b>cup</b>"
rounds = 3
[server]
half_time = 10
nr_normal_halfs = 1
[teams.A]
endpoint = "mock"
[teams.B]
endpoint = "mock:hold"
`;

let browser;

const cls = (...words) => execFileSync(kCls, words, {cwd: kFolder, stdio: ['ignore', 'ignore', 'inherit']});

before(async () => {
  if (kSkip) return;
  cls('match', 'mock', 'mock:hold', '--seed', '7', '--cycles', '400', '--quiet', '--dir', 'match');
  cls('report', 'match', '--out', 'match.html');
  fs.mkdirSync(path.join(kFolder, 'cup'));
  fs.writeFileSync(path.join(kFolder, 'cup/cls.toml'), kTournament);
  cls('tournament', 'run', 'cup', '--quiet');
  cls('tournament', 'report', 'cup', '--format', 'html', '--out', 'cup.html');
  const args = ['--disable-gpu', ...(process.getuid() === 0 ? ['--no-sandbox'] : [])];
  browser = await chromium.launch({executablePath: process.env.CHROMIUM, args});
});

after(async () => {
  await browser?.close();
  fs.rmSync(kFolder, {recursive: true, force: true});
});

async function open(file, options) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const problems = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(error.stack));
  page.on('request', (request) => !/^(file|blob|data|about):/.test(request.url()) && problems.push(`request of ${request.url()}`));
  await page.goto(pathToFileURL(path.join(kFolder, file)).href);
  return {page, problems, context};
}

for (const file of ['match.html', 'cup.html']) {
  test(`${file} has no accessibility violations and loads nothing`, {skip: kSkip}, async () => {
    for (const options of kViews) {
      const {page, problems, context} = await open(file, options);
      await page.evaluate(fs.readFileSync(kAxe, 'utf8'));
      const {violations} = await page.evaluate(() => window.axe.run({iframes: false}));
      assert.deepEqual(violations.map((each) => `${each.id}: ${each.nodes.map((node) => node.html).join(' ')}`), []);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      assert.ok(overflow <= 0, `${overflow} px wider than the window`);
      assert.deepEqual(problems, []);
      await context.close();
    }
  });
}

test('cup.html charts goal differences, and shows names as text', {skip: kSkip}, async () => {
  const {page, context} = await open('cup.html', {});
  assert.equal(await page.getByRole('img', {name: 'Goals of A minus those of B', exact: true}).count(), 1);
  assert.equal(await page.locator('b').count(), 0);
  await context.close();
});
