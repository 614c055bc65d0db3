// The editor of the team's files: a tab for each file, lines with problems marked.
import { javascript } from '@codemirror/lang-javascript';
import { python } from '@codemirror/lang-python';
import { HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { setDiagnostics } from '@codemirror/lint';
import { EditorState, Prec } from '@codemirror/state';
import { keymap } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { EditorView, basicSetup } from 'codemirror';
import { element, setAttribute } from '../../../viewer/web/src/dom.js';
import { mainFileOf } from './team_files.js';

const kNonce = 'cls-editor'; // of the policy of index.html: CodeMirror adds its style sheet

const kHighlighting = HighlightStyle.define([
  { tag: [tags.keyword, tags.moduleKeyword, tags.controlKeyword], color: 'var(--code-keyword)' },
  { tag: [tags.string, tags.special(tags.string)], color: 'var(--code-string)' },
  { tag: [tags.number, tags.bool, tags.null], color: 'var(--code-number)' },
  { tag: [tags.lineComment, tags.blockComment], color: 'var(--code-comment)' },
  { tag: [tags.function(tags.variableName), tags.function(tags.propertyName)], color: 'var(--code-function)' },
  { tag: tags.invalid, color: 'var(--warn)' },
]);

const kTheme = EditorView.theme({
  '&': { height: '100%', backgroundColor: 'var(--surface)', color: 'var(--text)', fontSize: '13.5px' },
  '&.cm-focused': { outline: '2px solid var(--focus)', outlineOffset: '-2px' },
  '.cm-scroller': { fontFamily: "ui-monospace, 'DejaVu Sans Mono', monospace", lineHeight: '1.5' },
  '.cm-gutters': { backgroundColor: 'var(--surface)', color: 'var(--soft)', border: 'none' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--raised)' },
  '&.cm-focused .cm-selectionBackground, .cm-selectionBackground, ::selection': { backgroundColor: 'var(--pressed) !important' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '.cm-matchingBracket, &.cm-focused .cm-matchingBracket': { backgroundColor: 'var(--pressed)', color: 'inherit' },
  '.cm-tooltip, .cm-panels': { backgroundColor: 'var(--raised)', color: 'var(--text)', borderColor: 'var(--edge)' },
  '.cm-selectionMatch': { backgroundColor: 'var(--raised)' },
});

export class Editor {
  /** @param {HTMLElement} tabs @param {HTMLElement} place of the editor @param {{onEdit: () => void, onRun: () => void}} listener */
  constructor(tabs, place, { onEdit, onRun }) {
    this.tabs = tabs;
    this.extensions = [
      basicSetup, kTheme, syntaxHighlighting(kHighlighting), EditorView.cspNonce.of(kNonce),
      EditorView.contentAttributes.of({ tabindex: '0', 'aria-label': "The team's code" }),
      EditorView.updateListener.of((update) => {
        if (!update.docChanged) return;
        this.#keepState();
        onEdit();
      }),
      Prec.highest(keymap.of([{ key: 'Mod-Enter', run: () => (onRun(), true) }])),
    ];
    this.view = new EditorView({ parent: place, extensions: this.extensions });
    this.states = new Map();
    this.file = '';
    tabs.addEventListener('keydown', (event) => this.#moveTab(event));
  }

  /** @param {Record<string, string>} files */
  setFiles(files) {
    this.states = new Map(Object.entries(files).map(([name, doc]) => [name, EditorState.create({ doc, extensions: [this.extensions, name.endsWith('.py') ? python() : javascript()] })]));
    this.tabs.replaceChildren(...[...this.states.keys()].map((name) => element('button', {
      type: 'button', role: 'tab', 'aria-controls': 'editor', 'data-file': name, onclick: () => this.open(name),
    }, name)));
    this.open(mainFileOf(files));
  }

  /** @returns {Record<string, string>} */
  get files() {
    this.#keepState();
    return Object.fromEntries([...this.states].map(([name, state]) => [name, state.doc.toString()]));
  }

  /** @param {string} name of a file */
  open(name) {
    if (!this.states.has(name)) return;
    this.file = name;
    this.view.setState(this.states.get(name));
    for (const tab of this.tabs.children) {
      setAttribute(tab, 'aria-selected', String(tab.dataset.file === name));
      setAttribute(tab, 'tabindex', tab.dataset.file === name ? '0' : '-1');
    }
  }

  /** Replaces a file by a text, and selects what differs: one step back for the visitor. @param {string} file @param {string} text */
  replace(file, text) {
    this.open(file);
    const before = this.view.state.doc.toString();
    let from = 0;
    while (from < text.length && before[from] === text[from]) ++from;
    let rest = 0;
    while (rest < Math.min(text.length, before.length) - from && before.at(-1 - rest) === text.at(-1 - rest)) ++rest;
    const insert = text.slice(from, text.length - rest);
    const line = text.lastIndexOf('\n', from - 1) + 1;
    this.view.dispatch({
      changes: { from, to: before.length - rest, insert }, selection: { anchor: from, head: from + insert.length },
      effects: EditorView.scrollIntoView(line, { y: 'center' }),
    });
  }

  /** Shows a line and marks it. @param {string} file @param {number} line from 1 @param {string} message */
  mark(file, line, message) {
    this.open(file);
    if (this.file !== file) return;
    const { doc } = this.view.state;
    const { from, to } = doc.line(Math.min(Math.max(1, line), doc.lines));
    this.view.dispatch(setDiagnostics(this.view.state, [{ from, to, severity: 'error', message }]));
    this.view.dispatch({ selection: { anchor: from }, scrollIntoView: true });
    this.#keepState();
  }

  clearMarks() {
    this.view.dispatch(setDiagnostics(this.view.state, []));
  }

  #keepState() {
    if (this.states.has(this.file)) this.states.set(this.file, this.view.state);
  }

  #moveTab({ key }) {
    const names = [...this.states.keys()];
    const step = { ArrowRight: 1, ArrowLeft: names.length - 1 }[key];
    if (!step) return;
    this.open(names[(names.indexOf(this.file) + step) % names.length]);
    this.tabs.querySelector('[aria-selected=true]').focus();
  }
}
