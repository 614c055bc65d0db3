// The side panel: tabs for statistics, players, events and the pitch as a table.
import {element, setAttribute} from './dom.js';
import {EventsPanel} from './panel_events.js';
import {kExtensions} from './extensions.js';
import {missingDrawings} from './panel_missing.js';
import {PitchPanel} from './panel_pitch.js';
import {PlayerPanel} from './panel_player.js';
import {StatisticsPanel} from './panel_statistics.js';

export class Panel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.pages = [
      {id: 'statistics', label: 'Match', page: new StatisticsPanel(viewer)},
      {id: 'events', label: 'Events', page: new EventsPanel(viewer)},
      {id: 'player', label: 'Player', page: new PlayerPanel(viewer)},
      {id: 'pitch', label: 'Pitch', page: new PitchPanel(viewer)},
      {id: 'drawings', label: 'Drawings', page: kExtensions.drawings?.makePanel(viewer) ?? {root: missingDrawings(), show: () => {}}},
      ...(viewer.decisions ? [{id: 'decision', label: 'Decision', page: kExtensions.decisions.makePanel(viewer)}] : []),
    ];
    this.viewer = viewer;
    this.current = 'statistics';
    const tabs = element('div', {class: this.pages.length > 5 ? 'tabs many' : 'tabs', role: 'tablist', 'aria-label': 'Side panel'});
    for (const page of this.pages) {
      page.tab = element('button', {type: 'button', role: 'tab', id: `tab-${page.id}`, 'aria-controls': `page-${page.id}`, onclick: () => this.open(page.id)}, page.label);
      page.body = element('div', {class: 'tab-page', role: 'tabpanel', id: `page-${page.id}`, 'aria-labelledby': `tab-${page.id}`, tabindex: 0}, page.page.root);
      tabs.append(page.tab);
    }
    tabs.addEventListener('keydown', (event) => this.#moveTab(event));
    this.root = element('aside', {class: 'panel', 'aria-label': 'Match details'}, tabs, ...this.pages.map(({body}) => body));
    this.open('statistics');
  }

  /** @param {string} id */
  open(id) {
    this.current = id;
    for (const {id: each, tab, body, page} of this.pages) {
      setAttribute(tab, 'aria-selected', String(each === id));
      setAttribute(tab, 'tabindex', each === id ? '0' : '-1');
      body.hidden = each !== id;
      if (each === id) page.show();
    }
    this.viewer.setDebugging(id === 'decision');
  }

  #moveTab(event) {
    const index = this.pages.findIndex(({id}) => id === this.current);
    const count = this.pages.length;
    const targets = {ArrowRight: (index + 1) % count, ArrowLeft: (index + count - 1) % count, Home: 0, End: count - 1};
    const target = targets[event.key];
    if (target === undefined) return;
    event.preventDefault();
    this.open(this.pages[target].id);
    this.pages[target].tab.focus();
  }

  show() {
    this.pages.find(({id}) => id === this.current).page.show();
  }
}
