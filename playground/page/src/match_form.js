// The form of a match: teams, seed, length, and what else is different from a match of two halves.
import { element, setText } from '../../../viewer/web/src/dom.js';
import { oneSituation, readBook } from './book.js';
import { isSetting } from './share_link.js';

const kHalfTime = 'server::half_time=';

/** Selects a value, adding an option for it if there is none. */
function select(list, value, label) {
  if (![...list.options].some((option) => option.value === value)) list.append(element('option', { value }, label));
  list.value = value;
}

export class MatchForm {
  /** @param {HTMLFormElement} form @param {{onPlay: () => void}} listener */
  constructor(form, { onPlay }) {
    this.root = form;
    this.fields = form.elements;
    this.book = null; // the text of a book with the situation that is played
    this.more = form.querySelector('details');
    this.problem = form.querySelector('.more .problem');
    form.noValidate = true; // isValid() opens what is folded first
    form.onsubmit = (event) => {
      event.preventDefault();
      this.more.open = false;
      onPlay();
    };
    this.more.addEventListener('keydown', ({ key }) => key === 'Escape' && this.#closeMore());
    document.addEventListener('click', ({ target }) => !this.more.contains(target) && this.#closeMore(false));
    this.fields.set.oninput = this.fields.half.oninput = () => this.#showMore();
    this.fields.file.onchange = () => this.#readBook();
    this.fields.situation.onchange = () => this.#chooseSituation();
  }

  /** @param {[side: string, label: string][]} teams to choose from */
  setTeams(teams) {
    for (const list of [this.fields.left, this.fields.right]) {
      const { value } = list;
      list.replaceChildren(...teams.map(([side, label]) => element('option', { value: side }, label)));
      list.value = teams.some(([side]) => side === value) ? value : teams[0][0];
    }
  }

  /** @param {string} left @param {string} right values of teams */
  setSides(left, right) {
    select(this.fields.left, left, left);
    select(this.fields.right, right, right);
  }

  /** Shows a match. @param {import('./share_link.js').SharedMatch} match whose sides are texts */
  choose({ left, right, seed, cycles, set = [], book = null }) {
    const { fields } = this;
    this.setSides(left, right);
    fields.seed.value = seed;
    const length = book === null ? String(cycles ?? '') : '';
    select(fields.cycles, length, `${length} cycles`);
    const half = set.find((setting) => setting.startsWith(kHalfTime));
    fields.half.value = half?.slice(kHalfTime.length) ?? '';
    fields.set.value = set.filter((setting) => setting !== half).join('\n');
    if (book !== null) fields.situationCycles.value = cycles;
    this.#setBook(book, 'that of the link');
  }

  /** What the form says, with the values of the sides. @returns {import('./share_link.js').SharedMatch} */
  get chosen() {
    const { left, right, seed, cycles, situationCycles } = this.fields;
    const length = this.book === null ? cycles.value : situationCycles.value;
    return {
      left: left.value, right: right.value, seed: Number(seed.value), cycles: length === '' ? null : Number(length),
      set: this.#settings(), book: this.book,
    };
  }

  /** False if a field is wrong, which the browser then shows. */
  isValid() {
    const wrong = this.#lines().find((line) => !isSetting(line));
    this.fields.set.setCustomValidity(wrong ? `Not server::NAME=VALUE or player::NAME=VALUE: ${wrong}` : '');
    if (this.more.querySelector(':invalid')) this.more.open = true;
    return this.root.reportValidity();
  }

  #lines() {
    return this.fields.set.value.split('\n').map((line) => line.trim()).filter(Boolean);
  }

  #settings() {
    const half = this.fields.half.value;
    return [...(half === '' ? [] : [kHalfTime + half]), ...this.#lines()];
  }

  async #readBook() {
    const [file] = this.fields.file.files;
    if (!file) return;
    try {
      this.opened = await readBook(file);
      this.#tell('');
    } catch (error) {
      this.opened = null;
      this.#tell(`${file.name}: ${error.message}.`);
      return this.#setBook(null);
    }
    this.#listSituations(this.opened.labels.map((label, i) => [String(i), label]));
    this.fields.situation.value = '0';
    this.#chooseSituation();
  }

  #chooseSituation() {
    const { value } = this.fields.situation;
    if (value === 'given') return;
    this.book = value === '' ? null : oneSituation(this.opened, Number(value));
    this.#showMore();
  }

  /** A book with one situation, or null for whole matches. */
  #setBook(book, label) {
    this.book = book;
    this.opened = null;
    this.#listSituations(book === null ? [] : [['given', label]]);
    this.fields.situation.value = book === null ? '' : 'given';
    this.#showMore();
  }

  #listSituations(situations) {
    this.fields.situation.replaceChildren(...[['', 'none: a whole match'], ...situations]
      .map(([value, label]) => element('option', { value }, label)));
    this.fields.situation.closest('label').hidden = situations.length === 0;
  }

  #showMore() {
    const count = this.#settings().length + (this.book === null ? 0 : 1);
    setText(this.more.querySelector('summary'), count === 0 ? 'More' : `More (${count})`);
    this.fields.cycles.disabled = this.book !== null;
    this.fields.situationCycles.disabled = this.book === null;
    this.fields.situationCycles.closest('label').hidden = this.book === null;
  }

  #tell(text) {
    setText(this.problem, text);
    this.problem.hidden = text === '';
  }

  #closeMore(focus = true) {
    if (!this.more.open) return;
    this.more.open = false;
    if (focus) this.more.querySelector('summary').focus();
  }
}
