// The tutorial beside the field: a step, a button that tries it, and a check that says when it is done.
import { element, setAttribute, setText } from '../../../viewer/web/src/dom.js';
import { kLessons } from './lessons.js';

const kKey = 'learn=';

/** True if a fragment names a step of the tutorial. @param {string} hash */
export function hasLesson(hash) {
  return hash.replace(/^#/, '').startsWith(kKey);
}

/** The step that a fragment names, or null. @param {string} hash */
export function lessonOf(hash) {
  const id = hash.replace(/^#/, '').slice(kKey.length);
  return kLessons.find((lesson) => lesson.id === id) ?? null;
}

/** A text whose `code` is code and whose *names* are names of what is on the screen. */
function richText(text) {
  return text.split(/(`[^`]+`|\*[^*]+\*)/).filter(Boolean).map((part) => {
    if (part.startsWith('`')) return element('code', {}, part.slice(1, -1));
    return part.startsWith('*') ? element('b', {}, part.slice(1, -1)) : part;
  });
}

export class Tutorial {
  /**
   * @param {HTMLElement} root
   * @param {{done: string[], documentation: string, onOpen: (lesson: import('./lessons.js').Lesson) => void, onTry: () => void,
   *   onEdit: (edit: any) => void, onDone: (ids: string[]) => void}} options `done` are the steps of earlier visits;
   *   `documentation` is the address of its folder, or empty
   */
  constructor(root, options) {
    this.options = options;
    this.done = new Set(options.done);
    this.lesson = kLessons.find(({ id }) => !this.done.has(id)) ?? kLessons[0];
    this.list = element('ol', { class: 'lesson-list' }, ...kLessons.map((lesson, i) => element('li', {},
      element('button', { type: 'button', title: lesson.title, 'data-lesson': lesson.id, onclick: () => this.open(lesson) }, i + 1))));
    this.title = element('h2', { tabindex: '-1' });
    this.body = element('div', { class: 'lesson-text' });
    this.buttons = element('div', { class: 'buttons' });
    this.state = element('p', { class: 'lesson-state', role: 'status' });
    root.append(element('div', { class: 'lesson-head' }, this.title, element('nav', { 'aria-label': 'Steps of the tutorial' }, this.list)),
      this.body, this.buttons, this.state);
    this.#draw();
  }

  /** @param {import('./lessons.js').Lesson} lesson */
  open(lesson) {
    this.lesson = lesson;
    this.#draw();
    this.options.onOpen(lesson);
    this.title.focus({ preventScroll: true });
  }

  /** @returns {string} the fragment of a link to this step */
  get fragment() {
    return `#${kKey}${this.lesson.id}`;
  }

  /** What has happened in the page. @param {import('./lessons.js').LessonEvent} event */
  hear(event) {
    const result = this.lesson.check(event);
    if (!result) return;
    if (result.done && !this.done.has(this.lesson.id)) {
      this.done.add(this.lesson.id);
      this.options.onDone([...this.done]);
    }
    this.#tell(result);
    this.#drawList();
  }

  /** What was not possible. @param {string} text */
  refuse(text) {
    this.#tell({ done: false, text });
  }

  #tell({ done, text }) {
    setText(this.state, done ? `✓ Done. ${text}` : text);
    this.state.classList.toggle('done', done);
    this.next?.classList.toggle('primary-text', done);
    this.attempt.classList.toggle('primary-text', !done || !this.next);
  }

  #draw() {
    const { lesson } = this;
    const { documentation } = this.options;
    const number = kLessons.indexOf(lesson);
    setText(this.title, `${number + 1}. ${lesson.title}`);
    const link = documentation === '' ? []
      : [element('p', {}, element('a', { href: `${documentation}tutorial.html#${lesson.id}`, target: '_blank', rel: 'noopener' }, 'This step in the tutorial of all languages'))];
    this.body.replaceChildren(...lesson.text.map((text) => element('p', {}, ...richText(text))), ...link);

    const button = (label, onclick, primary = false) => element('button', { type: 'button', class: `button text ${primary ? 'primary-text' : ''}`, onclick }, label);
    this.attempt = button(lesson.attempt.label, () => this.options.onTry(), true);
    const following = kLessons[number + 1];
    this.next = following && button('Next step', () => this.open(following));
    const edits = (lesson.edits ?? []).map((edit) => button(edit.label, () => this.options.onEdit(edit)));
    this.buttons.replaceChildren(...edits, this.attempt, ...(this.next ? [this.next] : []));
    setText(this.state, this.done.has(lesson.id) ? '✓ Done.' : '');
    this.state.classList.toggle('done', this.done.has(lesson.id));
    this.#drawList();
  }

  #drawList() {
    for (const [i, lesson] of kLessons.entries()) {
      const button = this.list.children[i].firstChild;
      const done = this.done.has(lesson.id);
      setText(button, done ? '✓' : String(i + 1));
      setAttribute(button, 'aria-label', `${i + 1}. ${lesson.title}${done ? ', done' : ''}`);
      if (lesson === this.lesson) button.setAttribute('aria-current', 'step');
      else button.removeAttribute('aria-current');
    }
  }
}
