// Takes the screenshots of README and docs: node screenshots.mjs WORK PICTURES. WORK is what docs/pictures/make prepares.
import {createRequire} from 'node:module';
import fs from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';
import {pageOfCast} from './terminal_page.mjs';

const require = createRequire(new URL('../../tests/viewer/browser/package.json', import.meta.url));
const {chromium} = require('playwright-core');
const [work, pictures] = process.argv.slice(2);

/** Of the recording. */
const kTerminalSecond = 340.5;

/** name, file, hash, size and theme, when the page is ready */
const kPictures = [
  ['replay', 'match/match.html', '#t=3405&p=l11', {viewport: {width: 1360, height: 820}, colorScheme: 'dark'}, () => window.clsViewer],
  ['replay-narrow', 'match/match.html', '#t=3405', {viewport: {width: 390, height: 844}, deviceScaleFactor: 1.5, colorScheme: 'light'}, () => window.clsViewer],
  ['report', 'match/report.html', '', {viewport: {width: 1240, height: 1160}, colorScheme: 'light'}, () => document.querySelector('.charts')],
  ['debugger', 'debugged/match.html', '#t=1211&p=r9&d=1', {viewport: {width: 1360, height: 900}, colorScheme: 'dark'}, () => window.clsViewer?.viewer.track],
  ['compare', 'compare.html', '#t=400', {viewport: {width: 1300, height: 880}, colorScheme: 'dark'}, () => window.clsComparison],
];

const args = process.getuid() === 0 ? ['--no-sandbox'] : [];
const browser = await chromium.launch({executablePath: process.env.CHROMIUM, args});
for (const [name, file, hash, options, ready] of kPictures) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  await page.goto(pathToFileURL(path.resolve(work, file)).href + hash);
  await page.waitForFunction(ready, null, {timeout: 120000});
  await page.waitForTimeout(500);
  await page.screenshot({path: path.join(pictures, `${name}.png`)});
  await context.close();
}

// The terminal has the size of its text.
const terminal = await (await browser.newContext({viewport: {width: 900, height: 700}})).newPage();
await terminal.setContent(pageOfCast(fs.readFileSync(path.join(work, 'match.cast'), 'utf8'), kTerminalSecond));
await terminal.locator('body').screenshot({path: path.join(pictures, 'terminal.png')});
await browser.close();
