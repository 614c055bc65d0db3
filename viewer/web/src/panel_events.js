// The list of events; each is a button that shows its moment.
import {choicesTable} from './choices.js';
import {element, setAttribute} from './dom.js';
import {cycleLabel} from './record.js';

const kKeyKinds = ['goal', 'shot', 'card', 'missed', 'costly'];

export class EventsPanel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.all = element('input', {type: 'checkbox', onchange: () => this.#fill()});
    this.list = element('ol', {class: 'events'});
    this.root = element('div', {}, element('label', {class: 'filter'}, this.all, element('span', {}, 'Set plays, offenses and lost balls, too')), this.list);
    this.filled = null;
  }

  #fill() {
    const {viewer} = this;
    const {record} = viewer;
    this.filled = viewer.events;
    this.rows = viewer.events.filter((event) => this.all.checked || kKeyKinds.includes(event.kind)).map((event) => ({
      event,
      button: element('button', {type: 'button', class: `event ${event.kind}`, 'data-side': event.side, onclick: () => this.#open(event)},
        element('span', {class: 'event-time'}, cycleLabel(record, event.frame)), element('span', {class: 'event-text'}, event.text),
        ...(event.expectedGoals === undefined ? [] : [element('span', {class: 'event-extra'}, `${event.expectedGoals.toFixed(2)} xG`)])),
    }));
    for (const row of this.rows) row.choices = row.event.replayed ? choicesTable(row.event.replayed) : null;
    this.list.replaceChildren(...this.rows.map(({button, choices}) => element('li', {}, button, ...(choices ? [choices] : []))));
    if (this.rows.length === 0) this.list.append(element('li', {class: 'hint'}, 'No goals, shots, cards or missed decisions.'));
    this.show();
  }

  #open(event) {
    this.viewer.seek(event.frame);
    if (event.slot >= 0) this.viewer.select(event.slot);
  }

  show() {
    if (this.filled !== this.viewer.events) return this.#fill();
    const frame = this.viewer.frame;
    let current = null;
    for (const row of this.rows) {
      if (row.event.frame <= frame) current = row;
    }
    for (const row of this.rows) {
      if (row.choices) row.choices.hidden = row !== current;
      if (row === current) setAttribute(row.button, 'aria-current', 'true');
      else row.button.removeAttribute('aria-current');
    }
  }
}
