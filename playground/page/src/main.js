// The page: watch, learn, write, improve and share matches. It joins the parts and keeps what they have in common.
import { element, setText } from '../../../viewer/web/src/dom.js';
import { saveFile } from '../../../viewer/web/src/export.js';
import { Engine } from '../../web/engine.js';
import { compare, VerdictPanel } from './comparison.js';
import { Editor } from './editor.js';
import { FieldFrame } from './field_frame.js';
import { kTutorialMatch } from './lessons.js';
import { playMatch, Sandbox } from './matches.js';
import { MatchForm } from './match_form.js';
import { Output } from './output.js';
import { projectOf } from './project.js';
import { replayPage } from './replay_page.js';
import { fragmentOf, hasMatch, matchOf } from './share_link.js';
import { Storage } from './storage.js';
import { CodeError, kTemplates, languageOf, mainFileOf, placeIn, reachableFiles } from './team_files.js';
import { hasLesson, lessonOf, Tutorial } from './tutorial.js';

const kMocks = [
  ['mock:planner', 'planner'], ['mock:simple', 'simple'], ['mock', 'basic'],
  ['mock:example', 'example'], ['mock:hold', 'hold'], ['mock:random', 'random'],
];
const kFirstMatch = { left: 'mock:planner', right: 'mock:simple', seed: 7, cycles: null };
const kMine = 'mine';
const kKept = 'kept';

const byId = (id) => document.getElementById(id);

class Playground {
  constructor() {
    this.storage = new Storage();
    this.team = this.storage.team ?? firstTeam(this.storage.language);
    /** Another team in JavaScript: a kept version, or one of a link. @type {import('./share_link.js').Team | null} */
    this.kept = this.storage.kept;
    this.form = new MatchForm(byId('match-form'), { onPlay: () => this.playChosen() });
    this.output = new Output(byId('output'), (file, line, text) => this.editor.mark(file, line, text));
    this.field = new FieldFrame(byId('field'));
    this.editor = new Editor(byId('files'), byId('editor'), { onEdit: () => this.#onEdit(), onRun: () => this.playChosen() });
    this.verdict = new VerdictPanel();
    byId('verdict').append(this.verdict.root);
    this.tutorial = new Tutorial(byId('learn'), {
      done: this.storage.lessons,
      documentation: document.querySelector('meta[name=documentation]').content,
      onOpen: () => this.#showLesson(),
      onTry: () => this.#tryLesson(),
      onEdit: (edit) => this.#editForLesson(edit),
      onDone: (ids) => {
        this.storage.lessons = ids;
      },
    });
    this.playing = null; // an AbortController
    this.played = null; // the match that has been played: its setup, logs and what the viewer shows
    this.#listen();
    this.#showTeam();
    this.#showSides();
    this.form.choose(kFirstMatch);
  }

  /** Loads the engine, then plays: the first match, or that of a link once the visitor asks for it. */
  async start() {
    const learns = hasLesson(location.hash);
    if (learns) this.#openLesson(location.hash);
    try {
      const response = await fetch('cls.wasm');
      if (!response.ok) throw new Error(`${response.status}`);
      this.bytes = new Uint8Array(await response.arrayBuffer());
    } catch {
      return this.#showResult('The engine (cls.wasm) cannot be read. This page needs a web server: python3 -m http.server in its folder is one.', true);
    }
    this.sandbox = new Sandbox(this.bytes);
    if (hasMatch(location.hash)) await this.#openLink(location.hash);
    else if (!learns || this.early) this.playChosen();
  }

  #listen() {
    for (const button of document.querySelectorAll('.steps button')) button.onclick = () => this.openStep(button.dataset.step);
    byId('share').onclick = () => this.share();
    byId('share-close').onclick = () => byId('share-dialog').close();
    byId('copy-link').onclick = () => this.#copyLink();
    byId('team-name').onchange = ({ target }) => this.#rename(target);
    byId('language').onchange = ({ target }) => this.#chooseLanguage(target.value);
    byId('reset').onclick = () => this.#reset();
    byId('download-team').onclick = () => this.#downloadTeam();
    byId('compare-form').onsubmit = (event) => {
      event.preventDefault();
      this.compareTeams();
    };
    byId('stop').onclick = () => this.comparing?.abort();
    byId('keep').onclick = () => this.#keep();
    byId('save-game-log').onclick = () => saveFile(new Blob(this.played.game), 'match.rcg');
    byId('save-text-log').onclick = () => saveFile(new Blob(this.played.text), 'match.rcl');
    byId('save-replay').onclick = () => this.#saveReplay();
    byId('save-project').onclick = () => this.#saveProject(this.played.match);
    byId('compare-form').elements.workers.value = Math.max(1, Math.min(64, navigator.hardwareConcurrency || 2));
    window.addEventListener('hashchange', () => {
      if (hasMatch(location.hash)) this.#openLink(location.hash);
      if (hasLesson(location.hash)) this.#openLesson(location.hash);
    });
    window.addEventListener('storage', () => this.#followTheme());
    this.#followTheme();
  }

  /** The viewer keeps the theme; the page has the same. */
  #followTheme() {
    const { theme } = this.storage.viewerSettings;
    if (theme === 'dark' || theme === 'light') document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
  }

  /** @param {string} step watch, learn, write or improve */
  openStep(step) {
    document.body.dataset.step = step;
    const side = step === 'learn' ? this.tutorial.lesson.side : step;
    if (step === 'learn') history.replaceState(null, '', this.tutorial.fragment);
    else if (hasLesson(location.hash)) history.replaceState(null, '', location.pathname + location.search);
    for (const button of document.querySelectorAll('.steps button')) button.setAttribute('aria-pressed', String(button.dataset.step === step));
    byId('learn').hidden = step !== 'learn';
    byId('write').hidden = side !== 'write';
    byId('improve').hidden = side !== 'improve';
    const { left, right } = this.form.chosen;
    if (step === 'write' && left !== kMine && right !== kMine) this.form.setSides(kMine, 'mock:simple');
  }

  /** The step that a link names. */
  #openLesson(hash) {
    const lesson = lessonOf(hash);
    if (!lesson) return this.#showBanner('This link is broken: the tutorial has no such step.', 'Open the tutorial', () => this.openStep('learn'));
    byId('banner').hidden = true;
    this.tutorial.open(lesson);
    if (!this.playing) this.#showResult('Nothing is played yet.');
  }

  /** The match and the opponent of the step. */
  #showLesson() {
    const { attempt } = this.tutorial.lesson;
    if (attempt.kind === 'match') this.form.choose({ left: kMine, ...kTutorialMatch });
    if (attempt.kind === 'compare') {
      byId('compare-form').elements.cycles.value = attempt.cycles;
      if (!this.kept) this.#keep(firstTeam(languageOf(this.team.files)).files);
      byId('compare-form').elements.base.value = kKept;
    }
    this.openStep('learn');
  }

  #tryLesson() {
    const { attempt } = this.tutorial.lesson;
    if (attempt.kind === 'match') {
      this.#showLesson();
      this.playChosen();
    }
    if (attempt.kind === 'compare') this.compareTeams();
    if (attempt.kind === 'download') this.#downloadTeam();
  }

  #editForLesson({ edit, keep }) {
    const { files } = this.editor;
    const file = mainFileOf(files);
    const changed = edit(files[file], languageOf(files));
    if (changed === files[file]) return this.tutorial.refuse('Your code has no place for this: Start again gives the first version.');
    if (keep) this.#keep();
    this.editor.replace(file, changed);
  }

  #showTeam() {
    byId('team-name').value = this.team.name;
    byId('language').value = languageOf(this.team.files);
    this.editor.setFiles(this.team.files);
  }

  /** The teams to choose from, as options of all lists. */
  #showSides() {
    const own = [[kMine, `${this.team.name} (yours)`]];
    if (this.kept) own.push([kKept, this.kept.name === kKept ? 'the kept version' : `${this.kept.name} (kept)`]);
    this.form.setTeams([...own, ...kMocks]);
    const { base } = byId('compare-form').elements;
    const chosen = base.value;
    const others = [...own.slice(1), ...kMocks];
    base.replaceChildren(...others.map(([side, label]) => element('option', { value: side }, label)));
    base.value = others.some(([side]) => side === chosen) ? chosen : others[0][0];
  }

  /** What the form says, with the teams themselves. @returns {import('./share_link.js').SharedMatch} */
  chosenMatch() {
    const match = this.form.chosen;
    return { ...match, left: this.#sideOf(match.left), right: this.#sideOf(match.right) };
  }

  #sideOf(value) {
    if (value === kMine) return { name: this.team.name, files: reachableFiles(this.editor.files) };
    return value === kKept ? this.kept : value;
  }

  playChosen() {
    this.early = !this.sandbox; // start() then plays
    if (this.early || !this.form.isValid()) return;
    this.play(this.chosenMatch());
  }

  /** Plays a match in the viewer. @param {import('./share_link.js').SharedMatch} match */
  async play(match) {
    this.playing?.abort();
    const playing = new AbortController();
    this.playing = playing;
    this.played = null;
    byId('banner').hidden = true;
    byId('result-links').hidden = true;
    this.output.clear();
    this.editor.clearMarks();
    const inPython = [match.left, match.right].some((side) => typeof side !== 'string' && languageOf(side.files) === 'python');
    this.#showResult(inPython ? 'Python is loading.' : 'The teams line up.');
    this.field.open('The match in the replay viewer');
    const began = performance.now();
    const warnings = [];
    const shown = [];
    const onPiece = ({ status, lines, view }) => {
      this.output.add(lines);
      this.output.addWarnings(status.warnings);
      warnings.push(...status.warnings);
      this.field.push(view);
      shown.push(view);
      this.#showResult(`${scoreText(status)}, played to cycle ${status.cycle}`);
    };
    try {
      const coded = isCoded(match);
      const done = await playMatch(this.sandbox, { ...match, view: true, logs: true, decisions: coded }, onPiece, playing.signal);
      if (coded) this.field.addDecisions(done.decisions);
      else this.field.endWithoutDecisions('The page records decisions where a team in JavaScript plays');
      this.played = { match, status: done.status, game: done.game, text: done.text, view: shown, decisions: done.decisions ?? null };
      await this.#finish(done, performance.now() - began);
      this.tutorial.hear({ kind: 'match', match, status: done.status, warnings: [...warnings, ...done.status.warnings] });
    } catch (error) {
      if (!playing.signal.aborted) this.#showProblem(error);
    }
  }

  async #finish({ status, lines, game }, milliseconds) {
    this.output.add(lines);
    this.output.addWarnings(status.warnings);
    byId('result-links').hidden = false;
    byId('save-project').hidden = !isCoded(this.played.match);
    const speed = Math.round(status.cycle / (milliseconds / 1000));
    if (status.failure !== '') return this.#showProblem(new Error(status.failure));
    this.#showResult(`${scoreText(status)}, ${status.cycle} cycles at ${speed} a second`);
    byId('result').dataset.hash = await hashOf(game);
  }

  #showResult(text, bad = false) {
    const result = byId('result');
    setText(result, text);
    result.classList.toggle('problem', bad);
    delete result.dataset.hash;
  }

  /** What went wrong, with its line in the editor where there is one. */
  #showProblem(error) {
    this.field.fail();
    const text = error instanceof Error ? error.message : String(error);
    this.#showResult(text, true);
    const place = error instanceof CodeError ? error : placeIn(text);
    this.output.addProblem(text, place);
    if (place && document.body.dataset.step === 'write') this.editor.mark(place.file, place.line, text);
  }

  #onEdit() {
    if (!this.borrowed) this.storage.team = { name: this.team.name, files: this.editor.files };
  }

  #rename(input) {
    if (!input.checkValidity() || input.value === '') input.value = this.team.name;
    this.team.name = input.value;
    this.#onEdit();
    this.#showSides();
  }

  /** The visitor has a team in each language. */
  #chooseLanguage(language) {
    this.team = this.storage.teamIn(language) ?? firstTeam(language);
    this.borrowed = false;
    this.storage.language = language;
    this.#showTeam();
    this.#showSides();
  }

  #reset() {
    const question = this.borrowed ? 'Leave the code of the link and return to your own?' : 'Throw your code away and start again with the first version?';
    if (!window.confirm(question)) return;
    this.team = (this.borrowed && this.storage.team) || firstTeam(languageOf(this.team.files));
    this.borrowed = false;
    this.#showTeam();
    this.#onEdit();
    this.#showSides();
  }

  /** The visitor's team as a project, for the match of the form if the team plays in it. */
  #downloadTeam() {
    const match = this.chosenMatch();
    const { left, right } = this.form.chosen;
    return this.#saveProject(left === kMine || right === kMine ? match : { ...match, left: this.#sideOf(kMine) });
  }

  /** @param {import('./share_link.js').SharedMatch} match in which a team with code of its own plays */
  async #saveProject(match) {
    const around = await (await fetch('project.json')).json();
    const { name } = [match.left, match.right].find((side) => typeof side !== 'string');
    saveFile(projectOf(match, around), `${name}.zip`);
    this.tutorial.hear({ kind: 'download' });
  }

  async #saveReplay() {
    const { status, view, decisions } = this.played;
    const starts = await (await fetch('replay.json')).json();
    saveFile(await replayPage(starts, { title: scoreText(status), view, decisions }), 'match.html');
  }

  /** Keeps a version to compare with. */
  #keep(files = this.editor.files) {
    this.kept = { name: kKept, files };
    this.storage.kept = this.kept;
    this.#showSides();
    byId('compare-form').elements.base.value = kKept;
  }

  async compareTeams() {
    if (!this.sandbox || this.comparing) return;
    const { base, cycles, workers } = byId('compare-form').elements;
    const names = { candidate: this.team.name, base: base.selectedOptions[0].textContent.replace(/ \(.*/, '') };
    const task = {
      sandbox: this.sandbox, workers: Number(workers.value), seed: this.form.chosen.seed,
      cycles: cycles.value === '' ? null : Number(cycles.value), candidate: this.#sideOf(kMine), base: this.#sideOf(base.value),
    };
    this.comparing = new AbortController();
    this.playing?.abort();
    byId('compare').disabled = true;
    byId('stop').disabled = false;
    byId('compare-problem').hidden = true;
    let played = 0;
    try {
      task.engine = await (this.engine ??= Engine.create(this.bytes));
      let verdict = task.engine.verdict([]);
      this.verdict.show(verdict, { played, running: true, ...names });
      await compare(task, (now, matches) => {
        [verdict, played] = [now, matches];
        this.verdict.show(verdict, { played, running: true, ...names });
      }, this.comparing.signal).catch((error) => this.#tellComparison(error));
      this.verdict.show(verdict, { played, running: false, ...names });
      if (verdict.decision !== 'open') this.tutorial.hear({ kind: 'verdict', decision: verdict.decision, withKept: task.base === this.kept });
    } finally {
      this.comparing = null;
      byId('compare').disabled = false;
      byId('stop').disabled = true;
    }
  }

  #tellComparison(error) {
    if (this.comparing.signal.aborted) return;
    byId('compare-problem').hidden = false;
    setText(byId('compare-problem'), error.message);
  }

  async share() {
    if (!this.form.isValid()) return;
    const address = location.href.replace(/#.*$/, '') + await fragmentOf(this.chosenMatch());
    byId('share-link').value = address;
    setText(byId('copy-state'), '');
    byId('share-dialog').showModal();
    byId('share-link').select();
  }

  async #copyLink() {
    byId('share-link').select();
    try {
      await navigator.clipboard.writeText(byId('share-link').value);
      setText(byId('copy-state'), 'Copied');
    } catch {
      setText(byId('copy-state'), 'Copy the selected text');
    }
  }

  /** Shows what a link has. Nothing of it runs until the visitor says so. */
  async #openLink(hash) {
    this.playing?.abort();
    let match;
    try {
      match = await matchOf(hash);
    } catch (error) {
      return this.#showBanner(`This link is broken: ${error.message}.`, 'Play another match', () => {
        history.replaceState(null, '', location.pathname + location.search);
        this.playChosen();
      });
    }
    this.#borrow(match);
    const names = [match.left, match.right].map((side) => (typeof side === 'string' ? side.replace(/^mock:?/, '') || 'basic' : side.name));
    const coded = isCoded(match);
    const text = `A shared match: ${names.join(' against ')}, seed ${match.seed}${match.book === null ? '' : ', a situation'}${match.set.length > 0 ? ', with settings' : ''}. ${coded ? 'It has code of the person who made the link: it runs when you press the button, without access to your data or the network.' : ''}`;
    this.#showBanner(text, 'Play this match', () => this.playChosen());
    this.#showResult('Nothing is played yet.');
    byId('field').replaceChildren();
  }

  /** The teams of a link, in place of the own ones until the page is opened again without it. */
  #borrow({ left, right, ...rest }) {
    const teams = [left, right].filter((side) => typeof side !== 'string');
    if (teams.length > 0) {
      this.borrowed = true;
      this.team = { name: teams[0].name, files: { ...kTemplates[languageOf(teams[0].files)], ...teams[0].files } };
      this.kept = teams[1] ?? this.kept;
      this.#showTeam();
      this.#showSides();
    }
    const value = (side) => (typeof side === 'string' ? side : side === teams[0] ? kMine : kKept);
    this.form.choose({ left: value(left), right: value(right), ...rest });
  }

  #showBanner(text, label, run) {
    const button = element('button', { type: 'button', class: 'button text primary-text', onclick: () => {
      byId('banner').hidden = true;
      run();
    } }, label);
    byId('banner').replaceChildren(element('span', {}, text), button);
    byId('banner').hidden = false;
  }
}

/** @param {import('./team_files.js').Language} language */
const firstTeam = (language) => ({ name: 'mine', files: { ...kTemplates[language] } });

/** True if a team with code of its own plays. */
function isCoded({ left, right }) {
  return typeof left !== 'string' || typeof right !== 'string';
}

function scoreText({ left, right }) {
  return `${left.name} ${left.score} : ${right.score} ${right.name}`;
}

/** SHA-256 of match.rcg, where the browser has it. */
async function hashOf(pieces) {
  if (!crypto.subtle) return '';
  const digest = await crypto.subtle.digest('SHA-256', await new Blob(pieces).arrayBuffer());
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

const playground = new Playground();
// For scripts and tests.
Object.assign(window, { clsPlayground: playground });
playground.start();
