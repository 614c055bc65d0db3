// The selected players: the frame's numbers from the log, and their figures of the whole match.
import {element, setText} from './dom.js';
import {distanceToBall, playerName} from './moment.js';
import {PlayerState} from './player_state.js';
import {kPlayersPerTeam, kSlots, shortNameOfSlot, sideOfSlot, unumOfSlot} from './sides.js';

const kCounters = ['kick', 'dash', 'turn', 'catch', 'move', 'turn_neck', 'change_view', 'say', 'tackle', 'pointto', 'attentionto', 'change_focus'];

/** Of commands that are more than one word. */
const kCounterNames = {turn_neck: 'turn neck', change_view: 'change view', pointto: 'point to', attentionto: 'attention to', change_focus: 'change focus'};

export class PlayerPanel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.picker = element('div', {class: 'picker', role: 'group', 'aria-label': 'Players'});
    this.buttons = Array.from({length: kSlots}, (_, slot) => element('button', {
      type: 'button', class: `pick ${sideOfSlot(slot)}`, 'aria-label': `${sideOfSlot(slot)} ${unumOfSlot(slot)}`,
      onclick: (event) => viewer.select(viewer.selected.includes(slot) ? -1 : slot, event.shiftKey),
    }, String(unumOfSlot(slot))));
    this.picker.append(element('div', {class: 'pick-row'}, ...this.buttons.slice(0, kPlayersPerTeam)), element('div', {class: 'pick-row'}, ...this.buttons.slice(kPlayersPerTeam)));
    this.cards = element('div', {class: 'cards'});
    this.root = element('div', {}, this.picker, this.cards);
    this.shown = '';
  }

  show() {
    const {viewer} = this;
    const key = `${viewer.selected.join(' ')} ${viewer.record.statisticsFrames}`;
    if (key !== this.shown) {
      this.shown = key;
      this.rows = viewer.selected.map((slot) => new PlayerCard(viewer, slot));
      this.cards.replaceChildren(...this.rows.map(({root}) => root));
      if (this.rows.length === 0) this.cards.append(element('p', {class: 'hint'}, 'Choose a player here or on the field. Shift adds one.'));
    }
    this.buttons.forEach((button, slot) => button.setAttribute('aria-pressed', String(viewer.selected.includes(slot))));
    for (const row of this.rows) row.show(viewer.frame);
  }
}

/** Rows: label and text of a frame. */
const kFrameRows = [
  ['Position', (record, slot, frame) => `${record.column('x')[slot][frame].toFixed(2)}, ${record.column('y')[slot][frame].toFixed(2)} m`],
  ['Speed', speedText],
  ['Distance to ball', (record, slot, frame) => `${distanceToBall(record, frame, slot).toFixed(2)} m`],
  ['Body, neck', (record, slot, frame) => `${record.column('body')[slot][frame].toFixed(1)}°, ${record.column('neck')[slot][frame].toFixed(1)}°`],
  ['View width', (record, slot, frame) => `${record.column('view_width')[slot][frame].toFixed(0)}°`],
  ['Effort, recovery', (record, slot, frame) => `${record.column('effort')[slot][frame].toFixed(3)}, ${record.column('recovery')[slot][frame].toFixed(3)}`],
  ['Capacity', (record, slot, frame) => capacityText(record.column('capacity')[slot][frame])],
  ['Attention to', attentionText],
  ['Type', (record, slot, frame) => typeText(record, slot, frame)],
];

function speedText(record, slot, frame) {
  if (!record.has('vx')) return 'not in a compact page';
  return `${Math.hypot(record.column('vx')[slot][frame], record.column('vy')[slot][frame]).toFixed(3)} m/cycle`;
}

function capacityText(capacity) {
  return capacity < 0 ? 'unlimited' : capacity.toFixed(0);
}

function attentionText(record, slot, frame) {
  const other = record.column('attention')[slot][frame];
  return other < 0 ? 'none' : shortNameOfSlot(other);
}

function typeText(record, slot, frame) {
  const {player_speed_max: speed, kickable_margin: margin} = record.playerType(slot, frame);
  const id = record.column('type')[slot][frame];
  return speed === undefined ? String(id) : `${id}: top speed ${speed.toFixed(2)}, kickable ${(margin ?? 0).toFixed(2)}`;
}

/** Rows: label and text of the statistics of the match. */
const kMatchRows = [
  ['Passes', (figures) => `${figures.ball.completed} of ${figures.ball.passes}`],
  ['Touches', (figures) => String(figures.ball.touches)],
  ['Shots, goals', (figures) => `${figures.ball.shots}, ${figures.ball.goals}`],
  ['Expected goals', (figures) => figures.ball.expected_goals.toFixed(2)],
  ['Interceptions', (figures) => String(figures.interceptions)],
  ['Effective tackles', (figures) => `${figures.tackles.effective} of ${figures.tackles.tried}`],
  ['Distance', (figures) => `${(figures.movement.distance / 1000).toFixed(2)} km`],
  ['Top speed', (figures) => `${figures.movement.top_speed.toFixed(2)} m/cycle`],
  ['Lowest stamina', (figures) => figures.stamina.lowest.toFixed(0)],
];

class PlayerCard {
  constructor(viewer, slot) {
    this.viewer = viewer;
    this.slot = slot;
    this.name = element('h2', {class: `player-name ${sideOfSlot(slot)}`});
    this.state = element('p', {class: 'player-state'});
    this.stamina = element('meter', {min: 0, max: viewer.record.parameter('stamina_max', 8000), low: 2400, optimum: 8000, 'aria-label': 'Stamina'});
    this.staminaText = element('span', {});
    this.values = kFrameRows.map(() => element('dd', {}));
    this.counts = kCounters.map(() => element('dd', {}));
    const rows = kFrameRows.map(([label], index) => element('div', {}, element('dt', {}, label), this.values[index]));
    this.root = element('section', {class: 'player-card'}, this.name, this.state,
      element('div', {class: 'stamina'}, element('span', {}, 'Stamina'), this.stamina, this.staminaText),
      element('dl', {class: 'facts'}, ...rows), ...this.#matchFacts(), element('h3', {}, 'Commands executed so far'),
      element('dl', {class: 'facts counters'}, ...kCounters.map((name, index) => element('div', {}, element('dt', {}, kCounterNames[name] ?? name), this.counts[index]))));
  }

  #matchFacts() {
    const unum = unumOfSlot(this.slot);
    const figures = this.viewer.record.statistics?.players?.find((each) => each.side === sideOfSlot(this.slot) && each.unum === unum);
    if (!figures) return [];
    const rows = kMatchRows.map(([label, text]) => element('div', {}, element('dt', {}, label), element('dd', {}, text(figures))));
    return [element('h3', {}, 'Whole match'), element('dl', {class: 'facts'}, ...rows)];
  }

  show(frame) {
    const {viewer: {record}, slot} = this;
    const state = record.column('state')[slot][frame];
    const stamina = record.column('stamina')[slot][frame];
    setText(this.name, playerName(record, frame, slot));
    setText(this.state, stateText(state));
    this.stamina.value = stamina;
    setText(this.staminaText, stamina.toFixed(0));
    kFrameRows.forEach(([, text], index) => setText(this.values[index], text(record, slot, frame)));
    kCounters.forEach((name, index) => setText(this.counts[index], String(record.column(`count_${name}`)[slot][frame])));
  }
}

const kStateTexts = [
  ['goalie', 'goalie'], ['kick', 'kicks'], ['kickFailed', 'kick failed'], ['catch', 'catches'], ['catchFailed', 'catch failed'],
  ['tackle', 'tackles'], ['tackleFailed', 'tackle failed'], ['charged', 'was fouled'], ['backPass', 'back pass'],
  ['freeKickFault', 'free kick fault'], ['yellowCard', 'yellow card'], ['redCard', 'red card'], ['illegalDefense', 'illegal defense'],
];

function stateText(state) {
  if (!(state & PlayerState.enabled)) return 'not on the pitch';
  const texts = kStateTexts.filter(([bit]) => state & PlayerState[bit]).map(([, text]) => text);
  return texts.length > 0 ? texts.join(', ') : 'on the pitch';
}
