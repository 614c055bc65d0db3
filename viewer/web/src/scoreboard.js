// Names, score, clock and play mode above the field.
import {element, setText} from './dom.js';
import {playModeClass, playModeText, splitPlayMode} from './play_modes.js';
import {cycleLabel, minuteOf} from './record.js';

export class Scoreboard {
  constructor() {
    this.names = ['left', 'right'].map((side) => element('span', {class: `team-name ${side}`}));
    this.scores = [element('span', {class: 'score-number'}), element('span', {class: 'score-number'})];
    this.penalties = element('span', {class: 'penalties'});
    this.cycle = element('span', {class: 'clock-cycle'});
    this.minute = element('span', {class: 'clock-minute'});
    this.mode = element('span', {class: 'mode'});
    this.title = element('h1', {class: 'unseen'});
    this.root = element('header', {class: 'scoreboard', 'aria-label': 'Score and clock'}, this.title,
      element('div', {class: 'score'}, this.names[0], element('span', {class: 'score-box'}, this.scores[0], element('span', {class: 'score-colon', 'aria-hidden': 'true'}, ':'), this.scores[1]), this.names[1], this.penalties),
      element('div', {class: 'clock'}, this.mode, this.minute, element('span', {class: 'clock-label'}, 'cycle ', this.cycle)));
  }

  /** A link to the page that this match belongs to. @param {string} address */
  addHome(address) {
    this.root.lastChild.append(element('a', {class: 'home', href: address}, 'All matches'));
  }

  /** @param {import('./record.js').MatchRecord} record @param {number} frame */
  show(record, frame) {
    const teams = record.teamsAt(frame);
    const names = teams.map((team, index) => team.name || record.header.names?.[index] || (index === 0 ? 'left' : 'right'));
    teams.forEach((team, index) => {
      setText(this.names[index], names[index]);
      setText(this.scores[index], String(team.score));
    });
    setText(this.title, `Replay of ${names[0]} against ${names[1]}`);
    const [left, right] = teams;
    const shootOut = left.scored + left.missed + right.scored + right.missed > 0;
    setText(this.penalties, shootOut ? `penalties ${left.scored}/${left.scored + left.missed} : ${right.scored}/${right.scored + right.missed}` : '');
    setText(this.cycle, cycleLabel(record, frame));
    setText(this.minute, `minute ${minuteOf(record, frame)}`);
    const mode = record.modeName(frame);
    setText(this.mode, playModeText(mode, names[0], names[1]));
    this.mode.dataset.kind = playModeClass(mode);
    this.mode.dataset.side = splitPlayMode(mode).side;
  }
}
