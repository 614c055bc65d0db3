// The pitch as a table: ball and players with position and distance to the ball.
import {element, setText} from './dom.js';
import {distanceToBall} from './moment.js';
import {PlayerState} from './player_state.js';
import {kSlots, shortNameOfSlot, sideOfSlot, unumOfSlot} from './sides.js';

const kColumns = ['x', 'y', 'to ball', 'stamina'];

export class PitchPanel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.ball = kColumns.map(() => element('td', {}));
    this.cells = Array.from({length: kSlots}, () => kColumns.map(() => element('td', {})));
    const head = element('tr', {}, element('th', {scope: 'col'}, 'Who'), ...kColumns.map((name) => element('th', {scope: 'col'}, name)));
    const ballRow = element('tr', {}, element('th', {scope: 'row'}, 'Ball'), ...this.ball);
    this.rows = this.cells.map((cells, slot) => element('tr', {}, element('th', {scope: 'row'},
      element('button', {type: 'button', class: `pick ${sideOfSlot(slot)}`, 'aria-label': `Select ${shortNameOfSlot(slot)}`, onclick: () => viewer.select(slot)}, String(unumOfSlot(slot)))), ...cells));
    this.root = element('table', {class: 'pitch-table'}, element('caption', {}, 'Meters from the center; y grows downwards'),
      element('thead', {}, head), element('tbody', {}, ballRow, ...this.rows));
  }

  show() {
    const {record, frame} = this.viewer;
    setText(this.ball[0], record.column('ball_x')[0][frame].toFixed(1));
    setText(this.ball[1], record.column('ball_y')[0][frame].toFixed(1));
    this.cells.forEach((cells, slot) => {
      const enabled = (record.column('state')[slot][frame] & PlayerState.enabled) !== 0;
      this.rows[slot].hidden = !enabled;
      if (!enabled) return;
      setText(cells[0], record.column('x')[slot][frame].toFixed(1));
      setText(cells[1], record.column('y')[slot][frame].toFixed(1));
      setText(cells[2], distanceToBall(record, frame, slot).toFixed(1));
      setText(cells[3], record.column('stamina')[slot][frame].toFixed(0));
    });
  }
}
