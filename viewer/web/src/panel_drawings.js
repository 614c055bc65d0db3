// A list of texts and shapes that Playmakers show, and the filter for them and the field.
import {levelName} from './drawings.js';
import {element, setText} from './dom.js';
import {shortNameOfSlot} from './sides.js';

export class DrawingsPanel {
  /** @param {import('./viewer.js').Viewer} viewer @param {string} title */
  constructor(viewer, title) {
    this.viewer = viewer;
    this.levels = element('select', {'aria-label': 'Level of texts and drawings', onchange: () => this.#choose({level: Number(this.levels.value)})});
    this.search = element('input', {type: 'search', 'aria-label': 'Filter texts and drawings', placeholder: 'Filter', oninput: () => this.#choose({text: this.search.value})});
    this.list = element('ul', {class: 'drawings'});
    this.hint = element('p', {class: 'hint'});
    this.root = element('section', {'aria-label': title}, element('h3', {}, title),
      element('div', {class: 'drawing-filter'}, this.levels, this.search), this.list, this.hint);
    /** @type {import('./drawing_store.js').Shown[]} */
    this.all = [];
    this.named = false;
  }

  #choose(change) {
    Object.assign(this.viewer.teamDrawings.filter, change);
    this.#list();
    this.viewer.changed('moment');
  }

  /** @param {[number, string][]} levels that occur */
  setLevels(levels) {
    const options = [[0, 'all levels'], ...levels];
    if (options.length !== this.levels.options.length) {
      this.levels.replaceChildren(...options.map(([value, label]) => element('option', {value}, label)));
    }
  }

  /** @param {import('./drawing_store.js').Shown[]} all @param {boolean} named whether to say whose each is */
  show(all, named) {
    this.all = all;
    this.named = named;
    this.levels.value = String(this.viewer.teamDrawings.filter.level);
    if (this.search.value !== this.viewer.teamDrawings.filter.text) this.search.value = this.viewer.teamDrawings.filter.text;
    this.#list();
  }

  #list() {
    const shown = this.all.filter(({drawing}) => this.viewer.teamDrawings.filter.shows(drawing));
    this.list.replaceChildren(...shown.map(({slot, drawing}) => element('li', {},
      ...(this.named ? [element('span', {class: 'who'}, shortNameOfSlot(slot))] : []),
      element('span', {class: 'outcome'}, levelName(drawing.level)), element('span', {}, drawingText(drawing)))));
    setText(this.hint, this.all.length === 0 ? 'None about this frame.' : `${shown.length} of ${this.all.length}`);
  }
}

function drawingText({text, filled, kind, color}) {
  return text || `${filled ? 'filled ' : ''}${kind}${color ? `, ${color}` : ''}`;
}
