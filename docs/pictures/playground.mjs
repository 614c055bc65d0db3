// Takes the pictures of docs/playground.md: node playground.mjs PAGE PICTURES. PAGE is what `make playground` builds.
import path from 'node:path';
import {resultMatches, startSite, viewerFrame, whenShown, writeCode} from '../../tests/playground/browser/site.mjs';

const [folder, pictures] = process.argv.slice(2);
const kLongMs = 900_000;
/** A cycle with something to see. */
const kShownFrame = 420;

const site = await startSite(folder);
const {page} = await site.open('', {viewport: {width: 1360, height: 800}, colorScheme: 'dark'});
const save = (name) => page.screenshot({path: path.join(pictures, `${name}.png`)});

/** Waits for the end of the match, and shows a moment of it. */
async function showMoment() {
  await resultMatches(page, /cycles at/, kLongMs);
  await viewerFrame(page).evaluate((frame) => {
    const {viewer} = window.clsViewer;
    if (viewer.clock.playing) viewer.togglePlay();
    viewer.seek(frame);
  }, kShownFrame);
  await page.waitForTimeout(500);
}

await whenShown(page);
await page.click('.steps [data-step=write]');
const code = await page.evaluate(() => window.clsPlayground.editor.files['decide.js']);
await writeCode(page, code.replace('actions.smartKick(GOAL, 3, 0.1, 3)', 'actions.planAttack()'));
await page.selectOption('#match-form [name=cycles]', '1000');
await page.click('#play');
await showMoment();
await save('playground');

await page.click('.steps [data-step=improve]');
await page.selectOption('#compare-form [name=base]', 'mock:hold');
await page.selectOption('#compare-form [name=cycles]', '1000');
await page.click('#compare');
await page.locator('[data-decision=H1]').waitFor({timeout: kLongMs});
await page.locator('#compare:enabled').waitFor({timeout: kLongMs});
await save('playground-improve');

await page.click('.steps [data-step=learn]');
await page.click('[data-lesson=the-first-change-that-wins]');
await writeCode(page, code);
await page.locator('#learn').getByRole('button', {name: 'Make the change'}).click();
await page.locator('#learn').getByRole('button', {name: 'Play the match again'}).click();
await showMoment();
await save('playground-learn');
await site.close();
