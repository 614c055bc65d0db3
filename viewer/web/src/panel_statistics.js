// Statistics of the whole match, side by side. The figures are those of `cls stats`; the page computes none.
import {element} from './dom.js';

const percent = (share) => `${Math.round(100 * share)} %`;
const decimal = (value) => value.toFixed(2);
const whole = (value) => String(Math.round(value));

/** Rows: label, how to find the figure of a team, how to format it. */
const kRows = [
  ['Possession', (team) => team.possession?.last_touch, percent],
  ['Shots', (team) => team.shots?.total, whole],
  ['Shots on target', (team) => team.shots?.on_target, whole],
  ['Expected goals', (team) => team.shots?.expected_goals, decimal],
  ['Passes', (team) => team.passes?.attempted, whole],
  ['Pass completion', (team) => team.passes?.completion, percent],
  ['Through passes', (team) => team.passes?.through, whole],
  ['Crosses', (team) => team.passes?.crosses, whole],
  ['Interceptions', (team) => team.interceptions, whole],
  ['Effective tackles', (team) => team.tackles?.effective, whole],
  ['Take-ons', (team) => team.take_ons, whole],
  ['Box entries', (team) => team.territory?.box_entries, whole],
  ['Pitch control', (team) => team.territory?.pitch_control, percent],
  ['Corners', (team) => team.stoppages?.corners, whole],
  ['Offsides', (team) => team.stoppages?.offsides, whole],
  ['Fouls', (team) => team.stoppages?.fouls, whole],
  ['Yellow cards', (team) => team.stoppages?.yellow_cards, whole],
  ['Red cards', (team) => team.stoppages?.red_cards, whole],
  ['Saves', (team) => team.goalkeeping?.saves, whole],
  ['Distance', (team) => team.distance, (meters) => `${(meters / 1000).toFixed(1)} km`],
  ['Formation', (team) => team.shape?.formation, String],
];

export class StatisticsPanel {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.root = element('div', {class: 'statistics'});
    this.shown = null;
  }

  show() {
    const {statistics, isLive} = this.viewer.record;
    if (this.shown === statistics && this.shownLive === isLive && this.root.childElementCount > 0) return;
    this.shown = statistics;
    this.shownLive = isLive;
    if (!statistics) {
      this.root.replaceChildren(element('p', {class: 'hint'}, 'The first statistics come after ten seconds.'));
      return;
    }
    const {left, right} = statistics;
    const rows = kRows.map(([label, figure, format]) => comparison(label, figure(left), figure(right), format)).filter((row) => row !== null);
    const head = element('tr', {}, element('th', {scope: 'col', class: 'team-name left'}, left.name || 'left'),
      element('th', {scope: 'col', class: 'middle'}, isLive ? 'So far' : 'Whole match'), element('th', {scope: 'col', class: 'team-name right'}, right.name || 'right'));
    const table = element('table', {class: 'comparison'}, element('thead', {}, head), element('tbody', {}, ...rows));
    this.root.replaceChildren(table, ...this.#remarks());
  }

  #remarks() {
    const {statistics, end, isLive} = this.viewer.record;
    if (isLive) return [];
    const remarks = (statistics.doubts ?? []).map((doubt) => element('li', {}, doubtText(String(doubt))));
    if (end?.errors?.count > 0) remarks.push(element('li', {}, `The log has ${end.errors.count} corrupt lines.`));
    if (remarks.length === 0) return [];
    return [element('h2', {}, 'Remarks'), element('ul', {}, ...remarks)];
  }
}

/** A doubt of `cls stats` as a sentence. */
function doubtText(doubt) {
  if (doubt === 'no time_over') return 'The log ends before the match is over.';
  return doubt.replace(/^([lr]) (\d+)\b/, (_, side, unum) => `${side === 'l' ? 'Left' : 'Right'} ${unum}`).replaceAll('_', ' ');
}

/** One row with a bar that shows the shares. */
function comparison(label, left, right, format) {
  if (left === undefined || right === undefined || left === null || right === null) return null;
  const cell = element('th', {scope: 'row', class: 'middle'}, label);
  if (typeof left === 'number' && left + right > 0) {
    const bar = element('span', {class: 'bar', 'aria-hidden': 'true'}, element('span', {class: 'bar-left'}));
    bar.firstChild.style.width = `${(100 * left) / (left + right)}%`;
    cell.append(bar);
  }
  return element('tr', {}, element('td', {}, format(left)), cell, element('td', {}, format(right)));
}
