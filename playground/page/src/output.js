// What went wrong and what the teams printed, below the editor.
import { element } from '../../../viewer/web/src/dom.js';
import { placeIn } from './team_files.js';

const kMostRows = 500;
const kHints = [
  'Ctrl+Enter plays. Problems and what your team prints with console.log appear here.',
  'A first edit: with the ball, actions.planAttack() in place of actions.smartKick(GOAL, 3, 0.1, 3), in Python plan_attack in place of smart_kick. The tab Decision beside the field shows what a player asked for and what came of it.',
];

export class Output {
  /** @param {HTMLElement} root @param {(file: string, line: number, text: string) => void} onPlace a place was chosen */
  constructor(root, onPlace) {
    this.root = root;
    this.onPlace = onPlace;
    this.clear();
  }

  clear() {
    this.root.replaceChildren(...kHints.map((hint) => element('p', { class: 'hint' }, hint)));
    this.rows = 0;
  }

  /** @param {{level: string, side: string, text: string}[]} lines */
  add(lines) {
    for (const { level, side, text } of lines) this.#row(element('p', { class: `line ${level}` }, side === '' ? text : `${side}: ${text}`));
  }

  /** @param {string[]} warnings of the engine */
  addWarnings(warnings) {
    for (const text of warnings) this.addProblem(text, placeIn(text));
  }

  /** @param {string} text @param {{file: string, line: number} | null} place */
  addProblem(text, place) {
    if (!place) return this.#row(element('p', { class: 'line error' }, text));
    const open = () => this.onPlace(place.file, place.line, text);
    this.#row(element('button', { type: 'button', class: 'line error', onclick: open }, text));
  }

  #row(row) {
    if (this.rows === 0) this.root.replaceChildren();
    this.rows += 1;
    this.root.append(row);
    while (this.root.children.length > kMostRows) this.root.firstChild.remove();
    this.root.scrollTop = this.root.scrollHeight;
  }
}
