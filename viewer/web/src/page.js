// The page: puts the parts together, draws when something changed, and keeps the address at the shown moment.
import {Announcer} from './announcer.js';
import {Clip} from './clip.js';
import {actionButton, Controls} from './controls.js';
import {element, setAttribute, setText} from './dom.js';
import {copyLink, saveImage, writeHash} from './export.js';
import {Help} from './help.js';
import {listenToKeys} from './keys.js';
import {momentText} from './moment.js';
import {Panel} from './panel.js';
import {listenToPointers} from './pointer.js';
import {Renderer} from './renderer.js';
import {Scoreboard} from './scoreboard.js';
import {Timeline} from './timeline.js';

const kPanelMs = 120;
const kAddressMs = 400;
const kBriefMs = 5000;

export class Page {
  /** @param {HTMLElement} root @param {import('./viewer.js').Viewer} viewer */
  constructor(root, viewer) {
    this.viewer = viewer;
    this.canvas = element('canvas', {class: 'field', role: 'img'});
    this.renderer = new Renderer(this.canvas, viewer.record, viewer.camera);
    this.clip = new Clip(viewer, this.canvas);
    this.scoreboard = new Scoreboard();
    this.timeline = new Timeline(viewer);
    this.controls = new Controls(viewer);
    this.panel = new Panel(viewer);
    this.help = new Help(viewer);
    this.announcer = new Announcer(viewer);
    this.bigPlay = actionButton(viewer, 'play', 'play', 'big-play');
    this.notice = element('p', {class: 'notice', hidden: true});
    this.brief = element('p', {class: 'brief', hidden: true, 'aria-hidden': 'true'});
    this.stage = element('div', {class: 'stage'}, this.canvas, this.bigPlay, this.notice, this.brief);
    this.root = root;
    root.replaceChildren(this.scoreboard.root, element('main', {class: 'player', 'aria-label': 'Replay'}, this.stage, this.timeline.root, this.controls.root), this.panel.root, this.announcer.root, this.help.dialog);
    this.scheduled = false;
    this.lastTick = 0;
    this.lastPanel = 0;
    this.addressTimer = 0;
    this.briefTimer = 0;
    if (viewer.decisions) viewer.decisions.onLoad = () => this.#onChange('moment');
    viewer.say = (text) => this.announcer.say(text);
    viewer.tell = (text) => this.#tell(text);
    viewer.listeners.add((what) => this.#onChange(what));
    listenToKeys(viewer, () => this.help.dialog.open);
    listenToPointers(this.canvas, viewer, this.renderer.pose);
    this.#listenToHost();
    this.#applySettings();
    this.#resize();
  }

  #listenToHost() {
    const observer = new ResizeObserver(() => this.#resize());
    observer.observe(this.stage);
    observer.observe(this.timeline.root);
    window.matchMedia('(prefers-color-scheme: light)').addEventListener('change', () => this.#onChange('settings'));
    window.addEventListener('hashchange', () => this.viewer.restore(window.location.hash));
  }

  #resize() {
    const ratio = window.devicePixelRatio || 1;
    this.renderer.resize(this.stage.clientWidth, this.stage.clientHeight, ratio);
    this.timeline.resize(ratio);
    this.draw();
  }

  #onChange(what) {
    const {viewer} = this;
    if (what === 'settings') this.#applySettings();
    if (what === 'selection' && viewer.selected.length > 0 && this.panel.current === 'statistics') this.panel.open('player');
    if (what === 'decisions') this.#showDecisions();
    if (what === 'describe') viewer.say(momentText(viewer.record, viewer.frame, viewer.selected));
    if (what === 'help') this.help.open();
    if (what === 'link') copyLink(viewer);
    if (what === 'clip') this.clip.toggle();
    if (what === 'image') saveImage(viewer, this.canvas, this.renderer.ratio);
    this.lastPanel = 0;
    this.requestDraw();
  }

  #showDecisions() {
    const {viewer, panel} = this;
    if (viewer.debugging && !viewer.settings.panel) viewer.togglePanel();
    if (viewer.debugging !== (panel.current === 'decision')) panel.open(viewer.debugging ? 'decision' : 'player');
  }

  #applySettings() {
    const {viewer} = this;
    document.documentElement.dataset.theme = viewer.themeName;
    this.root.classList.toggle('without-panel', !viewer.settings.panel);
    this.panel.root.hidden = !viewer.settings.panel;
  }

  /** Draws with the next picture of the browser. */
  requestDraw() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((now) => this.#onPicture(now));
  }

  #onPicture(now) {
    this.scheduled = false;
    const {clock} = this.viewer;
    if (clock.playing) {
      if (this.lastTick > 0) clock.tick(now - this.lastTick);
      this.lastTick = now;
    } else {
      this.lastTick = 0;
    }
    this.announcer.followClock();
    this.clip.followClock();
    this.draw(now);
    if (clock.playing && !clock.waiting) this.requestDraw();
    else this.lastTick = 0;
  }

  /** One line over the field, until it is ''. @param {string} text */
  showNotice(text) {
    setText(this.notice, text);
    this.notice.hidden = text === '';
    if (text !== '') this.announcer.say(text);
  }

  /** One line over the field for some seconds. @param {string} text */
  #tell(text) {
    setText(this.brief, text);
    this.brief.hidden = false;
    clearTimeout(this.briefTimer);
    this.briefTimer = setTimeout(() => (this.brief.hidden = true), kBriefMs);
    this.announcer.say(text);
  }

  /** Draws the moment. @param {number} [now] milliseconds */
  draw(now = performance.now()) {
    const {viewer} = this;
    const {clock, settings} = viewer;
    this.renderer.draw(clock, {theme: viewer.theme, layers: settings.layers, selected: viewer.selected, smooth: clock.playing, track: viewer.track, drawings: viewer.shownDrawings});
    this.scoreboard.show(viewer.record, clock.frame);
    this.timeline.draw();
    this.controls.show();
    this.bigPlay.hidden = clock.playing || clock.at > 0;
    if (clock.playing && now - this.lastPanel < kPanelMs) return;
    this.lastPanel = now;
    if (settings.panel) this.panel.show();
    if (!clock.playing) this.#onRest();
  }

  /** While the match rests, the field has a description, and the address shows the moment. */
  #onRest() {
    const {viewer} = this;
    setAttribute(this.canvas, 'aria-label', momentText(viewer.record, viewer.frame, viewer.selected));
    clearTimeout(this.addressTimer);
    this.addressTimer = setTimeout(() => writeHash(viewer), kAddressMs);
  }
}
