// Starts the page: reads the match, shows how far it is, then hands over to Page.
import {element, setText} from './dom.js';
import {completeness, readEmbedded} from './embedded.js';
import {slotsOfNames} from './hash.js';
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

async function readMatch(onProgress) {
  const data = document.getElementById('match');
  if (!data) throw new Error('the page was truncated before the match; get the file again');
  const text = data.textContent ?? '';
  const share = completeness(text, Number(data.getAttribute('data-length')));
  if (share < 1) throw new Error(`the page was truncated at ${Math.floor(100 * share)} % of the match; get the file again`);
  const record = await readEmbedded(text, onProgress);
  data.remove();
  return record;
}

/** The hash wins over what the page was written with. */
function showFirstMoment(viewer, options) {
  if (Array.isArray(options.players)) viewer.selected = slotsOfNames(options.players);
  if (Number.isInteger(options.at)) viewer.restore(`#t=${options.at}`);
  viewer.restore(window.location.hash);
}

async function startPage() {
  const root = document.getElementById('app');
  const bar = element('progress', {max: 1, value: 0, 'aria-label': 'Reading the match'});
  const percent = element('p', {}, 'Reading the match');
  root.replaceChildren(element('main', {class: 'message'}, percent, bar));
  const reducedMotion = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  const light = window.matchMedia('(prefers-color-scheme: light)');
  try {
    const record = await readMatch((fraction) => {
      bar.value = fraction;
      setText(percent, `Reading the match: ${Math.floor(100 * fraction)} %`);
    });
    const viewer = new Viewer(record, new Settings({reducedMotion}), {prefersLight: () => light.matches, reducedMotion});
    const page = new Page(root, viewer);
    showFirstMoment(viewer, pageSettings());
    page.draw();
    performance.mark('cls-first-picture');
    // For scripts and tests: the parts of this page.
    Object.assign(window, {clsViewer: {viewer, page}});
  } catch (error) {
    showProblem(root, error instanceof Error ? error.message : String(error));
    console.warn(error);
  }
}

if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', startPage);
else startPage();
