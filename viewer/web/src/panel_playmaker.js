// The tab of texts and drawings: what the Playmakers showed about this frame, or why there is nothing.
import {element, setText} from './dom.js';
import {missingDrawings} from './panel_missing.js';
import {DrawingsPanel} from './panel_drawings.js';
import {cycleLabel} from './record.js';
import {shortNameOfSlot} from './sides.js';

export class PlaymakerPanel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.title = element('h2', {});
    this.drawings = new DrawingsPanel(viewer, 'Texts and drawings by frame');
    const jump = (direction, label) => element('button', {type: 'button', class: 'button text', onclick: () => viewer.jumpToDrawings(direction)}, label);
    this.body = element('div', {}, element('div', {class: 'copy-buttons'}, jump(-1, 'Earlier'), jump(1, 'Later')), this.drawings.root);
    this.omitted = element('p', {class: 'hint'});
    this.missing = missingDrawings();
    this.root = element('div', {}, this.title, this.body, this.omitted, this.missing);
    this.shown = '';
  }

  show() {
    const {viewer} = this;
    const {teamDrawings: store, record, frame, selected} = viewer;
    this.body.hidden = store.empty;
    this.missing.hidden = !store.empty;
    const who = selected.length === 0 ? 'all players' : selected.map(shortNameOfSlot).join(', ');
    setText(this.title, store.empty ? 'Texts and drawings' : `${who}, cycle ${cycleLabel(record, frame)}`);
    setText(this.omitted, store.omitted > 0 ? `${store.omitted} more were left out: a team has room for 10 MB.` : '');
    const key = `${frame} ${who} ${store.moments.size} ${store.filter.level} ${store.filter.text}`;
    if (store.empty || key === this.shown) return;
    this.shown = key;
    this.drawings.setLevels(store.levels);
    this.drawings.show(store.at(frame, selected), true);
  }
}
