// Two matches side by side on one clock, and what differs.
import {Camera} from './camera.js';
import {Clock} from './clock.js';
import {commonAxis, distances, frameAtMoment, momentOfFrame} from './common_axis.js';
import {element, setAttribute, setText} from './dom.js';
import {kExtensions} from './extensions.js';
import {icon} from './icons.js';
import {keyName, needsKey} from './keys.js';
import {kPitch} from './pitch.js';
import {cycleLabel, frameOfCycle} from './record.js';
import {Renderer} from './renderer.js';
import {Scoreboard} from './scoreboard.js';
import {themeOf} from './theme.js';

const kStripHeight = 74;
const kLetters = ['A', 'B'];

/** What C++ found out: names, the first different frame, events of one match only, a table of figures.
 * @typedef {{names: string[], first: {frame: number, text: string} | null, events: {match: 0 | 1, cycle: number, text: string}[],
 *   columns: string[], rows: string[][]}} Differences */

export class Comparison {
  /** @param {HTMLElement} root @param {import('./record.js').MatchRecord[]} records @param {Differences} differences
   * @param {import('./settings.js').Settings} settings @param {{prefersLight: () => boolean}} host */
  constructor(root, records, differences, settings, host) {
    this.root = root;
    this.records = records;
    this.differences = differences;
    this.settings = settings;
    this.host = host;
    this.axis = commonAxis(records[0], records[1]);
    this.distances = distances(this.axis, records[0], records[1]);
    this.first = differences.first ? momentOfFrame(this.axis, 0, differences.first.frame) : -1;
    this.clock = new Clock(this.axis.length, records[0].parameter('simulator_step', 100));
    this.sides = records.map((record, index) => this.#side(record, index));
    this.strip = element('canvas', {class: 'strip-canvas', 'aria-hidden': 'true'});
    this.slider = element('div', {class: 'strip', role: 'slider', tabindex: 0, 'aria-label': 'Time', 'aria-valuemin': 0, 'aria-valuemax': this.clock.last}, this.strip);
    this.play = this.#button('Play (Space)', icon('play'), () => this.#toggle());
    this.speed = element('output', {class: 'speed', 'aria-label': 'Speed'});
    document.title = `${differences.names[0]} and ${differences.names[1]}`;
    root.classList.add('compare');
    const pair = element('div', {class: 'pair'}, ...this.sides.map((side) => side.root));
    root.replaceChildren(this.#head(), element('main', {class: 'compare-main'}, pair, this.#time(), this.#findings()));
    this.scheduled = false;
    this.lastTick = 0;
    this.#listen();
    this.restore(window.location.hash);
    this.resize();
    // A page whose drawings are cut still shows both matches.
    this.sides.forEach(({store}, index) => kExtensions.drawings.read('', store, () => this.#changed(), index === 0 ? '' : 'other-').catch(console.warn));
  }

  get themeName() {
    if (this.settings.theme !== 'auto') return this.settings.theme;
    return this.host.prefersLight() ? 'light' : 'dark';
  }

  #side(record, index) {
    const canvas = element('canvas', {class: 'field', role: 'img', 'aria-label': `Match ${kLetters[index]}`});
    const stage = element('div', {class: 'stage'}, canvas);
    const scoreboard = new Scoreboard();
    const name = element('h2', {class: 'match-name'}, `${kLetters[index]}: ${this.differences.names[index]}`);
    return {stage, scoreboard, canvas, store: kExtensions.drawings.makeStore(record), renderer: new Renderer(canvas, record, new Camera(kPitch)), root: element('section', {class: 'match'}, name, scoreboard.root, stage)};
  }

  #button(label, content, onclick) {
    return element('button', {type: 'button', class: 'button', 'aria-label': label, title: label, onclick}, content);
  }

  #head() {
    const {first} = this.differences;
    const text = first ? `First different frame: ${first.text}` : 'All frames are equal';
    const jump = first ? element('button', {type: 'button', class: 'button text', onclick: () => this.seek(this.first)}, 'Show it') : '';
    return element('header', {class: 'compare-head'}, element('h1', {}, 'Two matches'), element('p', {}, text), jump);
  }

  #time() {
    const step = (frames) => () => this.step(frames);
    return element('div', {class: 'compare-time'},
      element('p', {class: 'hint'}, 'Mean distance between the places of ball and players in both matches'),
      this.slider,
      element('div', {class: 'controls', role: 'toolbar', 'aria-label': 'Controls'},
        element('div', {class: 'group'}, this.#button('One cycle back (←)', icon('stepBack'), step(-1)), this.play, this.#button('One cycle (→)', icon('stepForward'), step(1))),
        element('div', {class: 'group'}, this.#button('Slower (,)', '−', () => this.#changeSpeed(-1)), this.speed, this.#button('Faster (.)', '+', () => this.#changeSpeed(1))),
        element('div', {class: 'group end'}, this.#button('Dark or light theme', icon('theme'), () => this.#toggleTheme()))));
  }

  #findings() {
    const {events, columns, rows} = this.differences;
    const buttons = events.map((event) => element('li', {}, element('button', {type: 'button', class: 'event', onclick: () => this.#showEvent(event)},
      element('span', {class: 'event-time'}, event.cycle), element('span', {class: 'event-text'}, event.text), element('span', {class: 'event-extra'}, `only ${kLetters[event.match]}`))));
    const heads = columns.map((text) => (text === '' ? element('td') : element('th', {scope: 'col'}, text)));
    const body = rows.map((row) => element('tr', {}, ...row.map((cell, index) => element(index === 0 ? 'th' : 'td', index === 0 ? {scope: 'row'} : {}, cell))));
    return element('div', {class: 'findings'},
      element('section', {class: 'panel'}, element('h2', {}, 'Figures'), element('div', {class: 'wide', tabindex: 0, role: 'region', 'aria-label': 'Figures of both matches'}, element('table', {class: 'pitch-table'}, element('thead', {}, element('tr', {}, ...heads)), element('tbody', {}, ...body)))),
      element('section', {class: 'panel'}, element('h2', {}, 'Goals, shots and fouls of one match only'), buttons.length > 0 ? element('ol', {class: 'events', tabindex: 0, 'aria-label': 'Events of one match only'}, ...buttons) : element('p', {class: 'hint'}, 'None')));
  }

  #showEvent(event) {
    this.seek(momentOfFrame(this.axis, event.match, frameOfCycle(this.records[event.match], event.cycle)));
  }

  #listen() {
    new ResizeObserver(() => this.resize()).observe(this.root);
    window.matchMedia('(prefers-color-scheme: light)').addEventListener('change', () => this.#changed());
    window.addEventListener('hashchange', () => this.restore(window.location.hash));
    document.addEventListener('keydown', (event) => this.#onKey(event));
    const toX = (event) => this.seek(Math.round(((event.clientX - this.slider.getBoundingClientRect().left) / Math.max(1, this.slider.clientWidth)) * this.clock.last));
    this.slider.addEventListener('pointerdown', (event) => {
      this.slider.setPointerCapture(event.pointerId);
      toX(event);
    });
    this.slider.addEventListener('pointermove', (event) => event.buttons > 0 && toX(event));
  }

  #onKey(event) {
    const name = keyName(event);
    const actions = {
      Space: () => this.#toggle(), ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1), 'Shift+ArrowLeft': () => this.step(-10), 'Shift+ArrowRight': () => this.step(10),
      Home: () => this.seek(0), End: () => this.seek(this.clock.last), ',': () => this.#changeSpeed(-1), '.': () => this.#changeSpeed(1),
    };
    const run = actions[name];
    if (!run || event.defaultPrevented || needsKey(event.target, name)) return;
    event.preventDefault();
    run();
  }

  #toggle() {
    this.clock.toggle();
    this.#changed();
  }

  #changeSpeed(direction) {
    this.clock.changeSpeed(direction);
    this.#changed();
  }

  #toggleTheme() {
    this.settings.theme = this.themeName === 'dark' ? 'light' : 'dark';
    this.settings.save();
    this.#changed();
  }

  /** @param {number} moment of the common axis */
  seek(moment) {
    this.clock.seek(moment);
    this.#changed();
  }

  step(frames) {
    this.clock.step(frames);
    this.#changed();
  }

  /** Shows the cycle of a hash, "#t=812". */
  restore(hash) {
    const match = /[#&]t=(\d{1,7})/.exec(hash);
    if (match) this.seek(momentOfFrame(this.axis, 0, frameOfCycle(this.records[0], Number(match[1]))));
  }

  resize() {
    this.ratio = window.devicePixelRatio || 1;
    for (const {renderer, stage} of this.sides) renderer.resize(stage.clientWidth, stage.clientHeight, this.ratio);
    this.strip.width = Math.max(1, Math.round(this.slider.clientWidth * this.ratio));
    this.strip.height = Math.round(kStripHeight * this.ratio);
    this.draw();
  }

  #changed() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((now) => this.#onPicture(now));
  }

  #onPicture(now) {
    this.scheduled = false;
    const {clock} = this;
    if (clock.playing && this.lastTick > 0) clock.tick(now - this.lastTick);
    this.lastTick = clock.playing ? now : 0;
    this.draw();
    if (clock.playing) this.#changed();
  }

  draw() {
    const {clock, axis, settings, records} = this;
    const theme = themeOf(this.themeName);
    document.documentElement.dataset.theme = this.themeName;
    this.sides.forEach(({renderer, scoreboard, store}, index) => {
      const at = frameAtMoment(axis, /** @type {0 | 1} */ (index), clock.at);
      renderer.draw({at, playing: clock.playing, framesPerSecond: clock.framesPerSecond}, {theme, layers: settings.layers, selected: [], smooth: clock.playing, drawings: settings.layers.drawings ? store.at(Math.floor(at + 1e-9), []) : []});
      scoreboard.show(records[index], Math.floor(at + 1e-9));
    });
    this.#drawStrip(theme);
    if (this.shownPlaying !== clock.playing) {
      this.shownPlaying = clock.playing;
      this.play.replaceChildren(icon(clock.playing ? 'pause' : 'play'));
      setAttribute(this.play, 'aria-label', clock.playing ? 'Pause (Space)' : 'Play (Space)');
    }
    setText(this.speed, `${clock.speed}×`);
    setAttribute(this.slider, 'aria-valuenow', String(clock.frame));
    setAttribute(this.slider, 'aria-valuetext', `cycle ${cycleLabel(records[0], axis.frames[0][clock.frame])}`);
  }

  #drawStrip(theme) {
    const context = this.strip.getContext('2d');
    const width = this.strip.width / this.ratio;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.fillStyle = theme.timeline.back;
    context.fillRect(0, 0, width, kStripHeight);
    const x = (moment) => (moment / Math.max(1, this.clock.last)) * width;
    const highest = this.distances.reduce((most, each) => Math.max(most, each), 1);
    context.beginPath();
    context.moveTo(0, kStripHeight);
    const step = Math.max(1, Math.floor(this.axis.length / (2 * width)));
    for (let at = 0; at < this.axis.length; at += step) context.lineTo(x(at), kStripHeight - (kStripHeight - 16) * (this.distances[at] / highest));
    context.lineTo(width, kStripHeight);
    context.fillStyle = theme.timeline.pause;
    context.fill();
    context.fillStyle = theme.timeline.text;
    context.font = '12px system-ui, sans-serif';
    context.fillText(`${highest.toFixed(1)} m`, 4, 12);
    if (this.first >= 0) {
      context.fillStyle = theme.warn;
      context.fillRect(x(this.first) - 1, 0, 2, kStripHeight);
    }
    context.fillStyle = theme.timeline.cursor;
    context.fillRect(Math.min(width - 2, x(this.clock.at)), 0, 2, kStripHeight);
  }
}

kExtensions.compare = (root, records, differences, settings, host) => new Comparison(root, records, differences, settings, host);
