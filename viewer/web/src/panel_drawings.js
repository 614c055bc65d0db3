// What the Playmaker shows about a decision: its texts, its shapes, and the filter for both.
import {drawingsOf, levelName, levelsIn} from './drawings.js';
import {element, setText} from './dom.js';

export class DrawingsPanel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.levels = element('select', {'aria-label': 'Level of texts and drawings', onchange: () => this.#choose({level: Number(this.levels.value)})});
    this.search = element('input', {type: 'search', 'aria-label': 'Filter texts and drawings', placeholder: 'Filter', oninput: () => this.#choose({text: this.search.value})});
    this.list = element('ul', {class: 'drawings'});
    this.hint = element('p', {class: 'hint'});
    this.root = element('section', {'aria-label': 'Texts and drawings'}, element('h3', {}, 'Texts and drawings of the Playmaker'),
      element('div', {class: 'drawing-filter'}, this.levels, this.search), this.list, this.hint);
    /** @type {import('./decision_track.js').DecisionTrack | null} */
    this.track = null;
  }

  #choose(change) {
    if (!this.track) return;
    Object.assign(this.track.filter, change);
    this.#list();
    this.viewer.changed('moment');
  }

  /** @param {import('./decision_track.js').DecisionTrack} track @param {number} decision -1: none */
  show(track, decision) {
    if (track !== this.track) this.#showTrack(track);
    this.decision = decision;
    this.#list();
  }

  #showTrack(track) {
    this.track = track;
    const options = [[0, 'all levels'], ...levelsIn(track.decisions.drawings)];
    this.levels.replaceChildren(...options.map(([value, label]) => element('option', {value}, label)));
    this.levels.value = String(track.filter.level);
    this.search.value = track.filter.text;
    this.root.hidden = track.decisions.drawings.every((text) => text === '');
  }

  #list() {
    const {track, decision} = this;
    const all = decision < 0 ? [] : drawingsOf(track.decisions.drawings[decision], track.slot);
    const shown = all.filter((drawing) => track.filter.shows(drawing));
    this.list.replaceChildren(...shown.map((drawing) => element('li', {},
      element('span', {class: 'outcome'}, levelName(drawing.level)), element('span', {}, drawing.text || `${drawing.filled ? 'filled ' : ''}${drawing.kind}${drawing.color ? `, ${drawing.color}` : ''}`))));
    setText(this.hint, all.length === 0 ? 'None about this decision.' : `${shown.length} of ${all.length}`);
  }
}
