// Starts the page: reads the match, shows how far it is, then hands over to Page.
import {element, setText} from './dom.js';
import {completeRecord, readData} from './embedded.js';
import {kExtensions} from './extensions.js';
import {slotsOfNames} from './hash.js';
import {readLive} from './live.js';
import {Page} from './page.js';
import {Settings} from './settings.js';
import {Viewer} from './viewer.js';

/** What `cls watch` wrote about this page. */
function pageSettings() {
  try {
    return JSON.parse(document.getElementById('settings')?.textContent ?? '{}') ?? {};
  } catch {
    return {};
  }
}

/** @param {HTMLElement} root @param {string} text one sentence without a period */
function showProblem(root, text) {
  root.replaceChildren(element('main', {class: 'message', role: 'alert'}, element('h1', {}, 'No match to show'), element('p', {}, `${text}.`)));
}

/** The hash wins over what the page was written with. */
function showFirstMoment(viewer, options) {
  if (Array.isArray(options.players)) viewer.selected = slotsOfNames(options.players);
  if (Number.isInteger(options.at)) viewer.restore(`#t=${options.at}`);
  viewer.restore(window.location.hash);
}

/** What the browser's user prefers. */
function hostPreferences() {
  const light = window.matchMedia('(prefers-color-scheme: light)');
  return {prefersLight: () => light.matches, reducedMotion: window.matchMedia('(prefers-reduced-motion: reduce)').matches};
}

function makePage(root, record, options) {
  const host = hostPreferences();
  record.missed = options.missed ?? [];
  record.review = options.review ?? [];
  if (Array.isArray(options.sides)) record.sides = options.sides;
  const viewer = new Viewer(record, new Settings(host), host);
  const page = new Page(root, viewer);
  if (typeof options.home === 'string') page.scoreboard.addHome(options.home);
  showFirstMoment(viewer, options);
  page.draw();
  performance.mark('cls-first-picture');
  showDrawings(viewer, options);
  // For scripts and tests: the parts of this page.
  Object.assign(window, {clsViewer: {viewer, page}});
  return page;
}

/** Those that do not arrive, or not whole, leave the match as it is. */
function showDrawings(viewer, options) {
  const onChange = () => viewer.changed('moment');
  const path = typeof options.drawings === 'string' ? options.drawings : '';
  kExtensions.drawings?.read(path, viewer.teamDrawings, onChange).catch((error) => viewer.tell(error instanceof Error ? error.message : String(error)));
}

async function startReplay(root, options) {
  const bar = element('progress', {max: 1, value: 0, 'aria-label': 'Reading the match'});
  const percent = element('p', {}, 'Reading the match');
  root.replaceChildren(element('main', {class: 'message'}, percent, bar));
  const onProgress = (fraction) => {
    bar.value = fraction;
    setText(percent, `Reading the match: ${Math.floor(100 * fraction)} %`);
  };
  const record = await readData('match', onProgress);
  const differences = document.getElementById('differences');
  if (!differences) {
    makePage(root, record, options);
    return completeRecord(record);
  }
  const records = [record, await readData('other', onProgress)];
  const host = hostPreferences();
  const comparison = kExtensions.compare(root, records, JSON.parse(differences.textContent), new Settings(host), host);
  // For scripts and tests.
  Object.assign(window, {clsComparison: comparison});
}

async function startLive(root, options) {
  const state = element('p', {role: 'status'}, 'Connecting');
  root.replaceChildren(element('main', {class: 'message'}, element('h1', {}, document.title), state));
  /** @type {Page | null} */
  let page = null;
  await readLive(options.live, {
    onConnection(connected) {
      setText(state, connected ? 'Waiting for the kick-off. The match appears here by itself.' : 'No connection to cls; trying again');
      page?.showNotice(connected ? '' : 'No connection to cls; trying again');
    },
    onRecord(record) {
      if (record.frames === 0) return;
      if (page) return page.viewer.grow();
      page = makePage(root, record, options);
      const chosen = Number.isInteger(options.at) || window.location.hash.includes('t=');
      if (record.isLive && !chosen) page.viewer.follow();
    },
  });
  if (!page) throw new Error('the match ended before it began');
}

async function startPage() {
  const root = document.getElementById('app');
  const options = pageSettings();
  try {
    await (typeof options.live === 'string' ? startLive(root, options) : startReplay(root, options));
  } catch (error) {
    showProblem(root, error instanceof Error ? error.message : String(error));
    console.warn(error);
  }
}

if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', startPage);
else startPage();
