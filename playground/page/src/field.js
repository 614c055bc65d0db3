// The replay viewer for a match that the page plays: its stream and its decisions come as messages.
import { DecisionStore } from '../../../viewer/web/src/decision_store.js';
import { TeamDecisions } from '../../../viewer/web/src/decisions.js';
import { DrawingStore } from '../../../viewer/web/src/drawing_store.js';
import { DrawingFilter } from '../../../viewer/web/src/drawings.js';
import { element, setText } from '../../../viewer/web/src/dom.js';
import { kExtensions } from '../../../viewer/web/src/extensions.js';
import { drawDecision } from '../../../viewer/web/src/layer_considered.js';
import { drawDrawings } from '../../../viewer/web/src/layer_drawings.js';
import { Page } from '../../../viewer/web/src/page.js';
import { DecisionPanel } from '../../../viewer/web/src/panel_decision.js';
import { PlaymakerPanel } from '../../../viewer/web/src/panel_playmaker.js';
import { Settings } from '../../../viewer/web/src/settings.js';
import { StreamDecoder } from '../../../viewer/web/src/stream.js';
import { Viewer } from '../../../viewer/web/src/viewer.js';

const kSides = ['left', 'right'];
const decoder = new StreamDecoder();
const root = document.getElementById('app');
let page = null;
let giveDecisions;
const decisions = new Promise((resolve, reject) => {
  giveDecisions = { resolve, reject };
});
decisions.catch(() => {}); // shown when somebody asks for them

kExtensions.decisions = {
  makeStore(record) {
    return new DecisionStore(record, kSides, async (side) => new TeamDecisions((await decisions)[kSides.indexOf(side)]));
  },
  makePanel: (viewer) => new DecisionPanel(viewer),
  draw: drawDecision,
};

// Texts and drawings are in the decisions.
kExtensions.drawings = {
  makeStore: (record) => new DrawingStore(record, new DrawingFilter()),
  makePanel: (viewer) => new PlaymakerPanel(viewer),
  read: async () => {},
  draw: drawDrawings,
};

function hostPreferences() {
  const light = window.matchMedia('(prefers-color-scheme: light)');
  return { prefersLight: () => light.matches, reducedMotion: window.matchMedia('(prefers-reduced-motion: reduce)').matches };
}

function makePage(record) {
  const host = hostPreferences();
  const viewer = new Viewer(record, new Settings(host), host);
  page = new Page(root, viewer);
  leaveOutStatistics(page.panel);
  viewer.restore('#play=1');
  page.draw();
  performance.mark('cls-first-picture');
  // For scripts and tests.
  Object.assign(window, { clsViewer: { viewer, page } });
}

/** The engine counts none. */
function leaveOutStatistics(panel) {
  const isOut = ({ id }) => id === 'statistics';
  for (const { tab, body } of panel.pages.filter(isOut)) {
    tab.remove();
    body.remove();
  }
  panel.pages = panel.pages.filter((each) => !isOut(each));
  panel.open('events');
}

function addStream(bytes) {
  for (const _ of decoder.push(bytes));
  if (!decoder.record || decoder.record.frames === 0) return;
  if (page) page.viewer.grow();
  else makePage(decoder.record);
}

window.addEventListener('message', ({ source, data }) => {
  if (source !== window.parent) return;
  if (data.kind === 'stream') addStream(data.bytes);
  if (data.kind === 'failed' && !page) setText(state, 'The match has ended before its first picture.');
  if (data.kind === 'decisions' && data.decisions) giveDecisions.resolve(data.decisions);
  if (data.kind === 'decisions' && data.why) giveDecisions.reject(new Error(data.why));
});

const state = element('p', { role: 'status' });
setText(state, 'The teams line up');
root.replaceChildren(element('main', { class: 'message' }, state));
window.parent.postMessage({ kind: 'ready' }, '*');
