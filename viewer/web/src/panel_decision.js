// The decision of the selected player: estimates beside the full state, request, reply, commands.
import {consideredTitle} from './decision_plan.js';
import {DecisionStrips} from './decision_strips.js';
import {executedCommands, makerText, missText, requestedActions} from './decision_track.js';
import {element, setText} from './dom.js';
import {playerName} from './moment.js';
import {scenarioOfMoment} from './moment_scenario.js';
import {DrawingsPanel} from './panel_drawings.js';
import {cycleLabel} from './record.js';
import {sideOfSlot, unumOfSlot} from './sides.js';

const kEstimateColumns = ['', 'Estimated', 'Full state', 'Error', 'Age'];
/** The others are behind a summary. */
const kShownConsidered = 8;

/** One word of a shell. @param {string} text */
function shellQuoted(text) {
  return /^[\w.:/@%+=,-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

export class DecisionPanel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.name = element('h2', {class: 'player-name'});
    this.call = element('p', {class: 'player-state'});
    this.actions = element('ul', {class: 'actions'});
    this.maker = element('p', {class: 'hint'});
    this.mirrored = element('p', {class: 'hint'}, 'Points in texts are as the team sees them: it attacks to the right.');
    this.sent = element('p', {class: 'sent'});
    this.executed = element('p', {class: 'hint'});
    this.planTitle = element('h3', {});
    this.plan = element('ol', {class: 'plan'});
    this.otherTitle = element('summary', {});
    this.otherPlan = element('ol', {class: 'plan'});
    this.others = element('details', {}, this.otherTitle, this.otherPlan);
    this.rows = element('tbody', {});
    this.reach = element('p', {class: 'hint'});
    this.drawings = new DrawingsPanel(viewer, 'Texts and drawings of the Playmaker');
    this.strips = new DecisionStrips(viewer);
    this.worst = element('ul', {class: 'events worst'});
    this.body = element('div', {}, this.call, element('h3', {}, 'Requested actions'), this.actions, this.mirrored, this.maker,
      element('h3', {}, 'Commands'), this.sent, this.executed, this.planTitle, this.plan, this.others, this.drawings.root,
      element('h3', {}, 'World model beside the full state'), this.#table(), this.reach,
      element('h3', {}, 'All decisions of the player'), this.strips.root,
      element('h3', {}, 'Largest errors near the ball'), this.worst,
      element('h3', {}, 'Copy'), this.#copyButtons());
    this.hint = element('p', {class: 'hint'});
    this.root = element('div', {class: 'decision'}, this.name, this.hint, this.body);
    this.shown = '';
  }

  #table() {
    const head = element('tr', {}, ...kEstimateColumns.map((text) => (text === '' ? element('td', {}) : element('th', {scope: 'col'}, text))));
    return element('table', {class: 'pitch-table estimates'}, element('caption', {}, 'Meters; age in cycles since it was observed'), element('thead', {}, head), this.rows);
  }

  #copyButtons() {
    const {viewer} = this;
    const button = (label, text) => element('button', {type: 'button', class: 'button text', onclick: () => this.#copy(label, text())}, label);
    this.copied = element('pre', {class: 'copied', tabindex: 0, hidden: true, 'aria-label': 'What was copied'});
    return element('div', {class: 'copy-buttons'}, button('Call the Playmaker again', () => this.#replayCommand()),
      button('This moment as a scenario', () => scenarioOfMoment(viewer.record, viewer.frame, viewer.selected[0])), this.copied);
  }

  /** The command that sends this State again, to the Playmaker of this match where the page knows it. */
  #replayCommand() {
    const {viewer} = this;
    const slot = viewer.selected[0];
    const side = sideOfSlot(slot);
    const [left, right] = viewer.record.sides ?? ['localhost:50051', 'localhost:50051'];
    return '# match.rpc: played again with --record-rpc match.rpc, unless it was recorded\n' +
      `cls test --replay match.rpc --side ${side} --at ${viewer.record.time(viewer.frame)} --player ${unumOfSlot(slot)} ${shellQuoted(side === 'left' ? left : right)}`;
  }

  /** Shows the text, too: not every page may write to the clipboard. */
  async #copy(label, text) {
    setText(this.copied, text);
    this.copied.hidden = false;
    try {
      await navigator.clipboard.writeText(text);
      this.viewer.say(`${label}: copied`);
    } catch {
      this.viewer.say(`${label}: shown in the panel`);
    }
  }

  show() {
    const {viewer} = this;
    const slot = viewer.selected[0] ?? -1;
    const track = slot < 0 ? null : viewer.decisions.track(slot);
    this.body.hidden = !track;
    this.hint.hidden = track !== null;
    this.name.hidden = slot < 0;
    if (slot >= 0) {
      setText(this.name, `${playerName(viewer.record, viewer.frame, slot)}, cycle ${cycleLabel(viewer.record, viewer.frame)}`);
      this.name.className = `player-name ${sideOfSlot(slot)}`;
    }
    setText(this.hint, slot < 0 ? 'Choose a player on the field or with the number keys.' : viewer.decisions.problem(slot));
    if (track) this.#showTrack(track);
  }

  #showTrack(track) {
    const decision = track.at(this.viewer.frame);
    this.strips.show(track, decision);
    this.#showWorst(track);
    const key = `${track.slot} ${this.viewer.frame}`;
    if (key === this.shown) return;
    this.shown = key;
    this.drawings.root.hidden = track.decisions.drawings.every((text) => text === '');
    this.drawings.setLevels(track.levels);
    this.drawings.show(track.drawings(this.viewer.frame), false);
    if (decision < 0) this.#showNone();
    else this.#showDecision(track, decision);
  }

  #showNone() {
    setText(this.call, 'No decision in this frame.');
    this.actions.replaceChildren();
    this.#showConsidered([]);
    this.rows.replaceChildren();
    for (const text of [this.maker, this.sent, this.executed, this.reach]) setText(text, '');
  }

  #showDecision(track, i) {
    const {decisions} = track;
    const miss = missText(decisions.value('call', i));
    const latency = `${((decisions.latencies[i] ?? 0) / 1000).toFixed(2)} ms`;
    setText(this.call, miss === '' ? `Reply after ${latency}` : `Missed after ${latency}: ${miss}`);
    this.call.classList.toggle('missed', miss !== '');
    const actions = requestedActions(decisions.replies[i]);
    this.actions.replaceChildren(...actions.map(({letter, outcome, text}) => element('li', {class: `action ${letter === 'e' ? 'done' : ''}`},
      element('code', {}, text), element('span', {class: 'outcome'}, outcome))));
    if (actions.length === 0) this.actions.append(element('li', {class: 'hint'}, miss === '' ? 'The reply has no actions.' : 'No reply.'));
    const considered = track.considered(i);
    this.mirrored.hidden = sideOfSlot(track.slot) === 'left' || actions.length + considered.length === 0;
    setText(this.maker, makerText(decisions.value('maker', i)));
    setText(this.sent, decisions.commands[i] || 'none');
    const executed = executedCommands(track.record, track.slot, this.viewer.frame);
    setText(this.executed, `Counted by the server until the next frame: ${executed.join(', ') || 'none'}.`);
    this.#showConsidered(considered);
    this.rows.replaceChildren(...track.rows(i).map(estimateRow));
    setText(this.reach, `Cycles to the ball: itself ${reachText(decisions, i, 'own_reach')}, a teammate ${reachText(decisions, i, 'teammate_reach')}, an opponent ${reachText(decisions, i, 'opponent_reach')}.`);
  }

  /** @param {import('./decision_plan.js').Considered[]} considered */
  #showConsidered(considered) {
    const item = ({chosen, text}) => element('li', chosen ? {'aria-current': 'true'} : {}, text);
    const others = considered.slice(kShownConsidered);
    this.planTitle.hidden = considered.length === 0;
    setText(this.planTitle, consideredTitle(considered));
    this.plan.replaceChildren(...considered.slice(0, kShownConsidered).map(item));
    this.others.hidden = others.length === 0;
    setText(this.otherTitle, `${others.length} more`);
    this.otherPlan.replaceChildren(...others.map(item));
  }

  #showWorst(track) {
    if (this.worstOf === track) return;
    this.worstOf = track;
    const buttons = track.worstMoments().map(({frame, ballError}) => element('button', {type: 'button', class: 'event', onclick: () => this.viewer.seek(frame)},
      element('span', {class: 'event-time'}, cycleLabel(track.record, frame)), element('span', {class: 'event-text'}, `the ball is ${ballError.toFixed(1)} m from its estimate`)));
    this.worst.replaceChildren(...buttons.map((button) => element('li', {}, button)));
  }
}

function reachText(decisions, i, name) {
  const cycles = decisions.value(name, i);
  return cycles < 0 ? 'never' : String(cycles);
}

function pointText(point) {
  return point ? `${point[0].toFixed(1)}, ${point[1].toFixed(1)}` : 'unknown';
}

function estimateRow({name, estimated, actual, error, age}) {
  const texts = [pointText(estimated), pointText(actual), Number.isNaN(error) ? '' : error.toFixed(2), age < 0 ? '' : String(age)];
  return element('tr', {}, element('th', {scope: 'row'}, name), ...texts.map((text) => element('td', {}, text)));
}
