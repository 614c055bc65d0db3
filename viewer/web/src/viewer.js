// The state of the page: one match, one clock, one view. Actions change it, views read it.
import {Camera} from './camera.js';
import {Clock} from './clock.js';
import {kExtensions, kNothingShown} from './extensions.js';
import {eventsOf, highlightsOf, nextEvent} from './events.js';
import {formatHash, parseHash} from './hash.js';
import {nearestToBall} from './moment.js';
import {kPitch} from './pitch.js';
import {frameOfCycle} from './record.js';
import {kLayers} from './settings.js';
import {themeOf} from './theme.js';

const kMaxSelected = 4;
const kNormalHalves = 2;
const kCyclesPerSecond = 10;

/** Frames of a match without extra time, if the clock never stops. */
function expectedFrames(record) {
  return kNormalHalves * kCyclesPerSecond * Math.max(0, record.parameter('half_time', 300));
}

export class Viewer {
  /** @param {import('./record.js').MatchRecord} record @param {import('./settings.js').Settings} settings
   * @param {{prefersLight: () => boolean, reducedMotion: boolean}} host what the browser prefers */
  constructor(record, settings, host) {
    this.record = record;
    this.settings = settings;
    this.host = host;
    this.clock = new Clock(record.frames, record.parameter('simulator_step', 100));
    this.clock.grow(record.frames, record.isLive);
    this.clock.expected = record.isLive ? expectedFrames(record) : 0;
    this.camera = new Camera(kPitch);
    /** Slots, the first one leads. @type {number[]} */
    this.selected = [];
    /** Recorded decisions, or null. */
    this.decisions = kExtensions.decisions?.makeStore(record) ?? null;
    /** What Playmakers showed, with decisions or without; null in pages without. */
    this.teamDrawings = kExtensions.drawings?.makeStore(record) ?? null;
    /** The field shows what the selected player estimates. */
    this.debugging = false;
    /** A clip is being recorded. */
    this.recording = false;
    this.#findEvents();
    /** @type {Set<(what: string) => void>} */
    this.listeners = new Set();
    /** What the last action did, for people who do not see it. */
    this.say = (/** @type {string} */ text) => void text;
    /** Why nothing happened, for everyone. */
    this.tell = (/** @type {string} */ text) => this.say(text);
  }

  #findEvents() {
    const {record} = this;
    this.events = eventsOf(record);
    this.highlights = highlightsOf(this.events, record.frames);
    this.notesSeen = record.notes.length;
    this.statisticsSeen = record.statistics;
  }

  /** The record has more frames, or its end. Each event comes with a note. */
  grow() {
    const {record, clock} = this;
    const wasLive = clock.live;
    clock.grow(record.frames, record.isLive);
    if (record.notes.length !== this.notesSeen || record.statistics !== this.statisticsSeen) this.#findEvents();
    if (wasLive && !clock.live) this.say('The match is over');
    this.changed('moment');
  }

  /** Shows what happens now, in a live match. */
  follow() {
    if (!this.clock.live) return this.tell('The match is over');
    this.clock.follow();
    this.say('Live');
    this.changed('moment');
  }

  get frame() {
    return this.clock.frame;
  }

  /** @returns {'dark' | 'light'} */
  get themeName() {
    const {theme} = this.settings;
    if (theme !== 'auto') return theme;
    return this.host.prefersLight() ? 'light' : 'dark';
  }

  get theme() {
    return themeOf(this.themeName);
  }

  /** Calls listeners: 'moment', 'selection', 'view' or 'settings' changed. @param {string} what */
  changed(what) {
    for (const listener of this.listeners) listener(what);
  }

  /** @param {number} frame */
  seek(frame) {
    this.clock.segments = [];
    this.clock.seek(frame);
    this.changed('moment');
  }

  /** @param {number} frames */
  step(frames) {
    this.clock.step(frames);
    this.changed('moment');
  }

  togglePlay() {
    this.clock.toggle();
    this.say(this.clock.playing ? 'Playing' : 'Paused');
    this.changed('moment');
  }

  /** @param {1 | -1} direction */
  changeSpeed(direction) {
    this.clock.changeSpeed(direction);
    this.say(`Speed ${this.clock.speed}`);
    this.changed('moment');
  }

  reverse() {
    this.clock.reverse();
    this.say(this.clock.backwards ? 'Backwards' : 'Forwards');
    this.changed('moment');
  }

  /** Jumps to an event. @param {1 | -1} direction @param {string[]} [kinds] */
  jump(direction, kinds) {
    const event = nextEvent(this.events, this.frame, direction, kinds);
    if (!event) return this.tell(direction > 0 ? 'No later event of this kind' : 'No earlier event of this kind');
    this.seek(event.frame);
    this.say(event.text);
  }

  playHighlights() {
    if (this.highlights.length === 0) return this.tell('The match has no goals and no good shots');
    this.clock.playSegments(this.highlights);
    this.say(`Highlights: ${this.highlights.length}`);
    this.changed('moment');
  }

  /** @param {number} slot @param {boolean} [add] keeps the others */
  select(slot, add = false) {
    if (slot < 0) this.selected = [];
    else if (add) this.selected = [slot, ...this.selected.filter((other) => other !== slot)].slice(0, kMaxSelected);
    else this.selected = [slot];
    if (this.selected.length === 0 && this.camera.follow === 'player') this.camera.follow = '';
    this.changed('selection');
  }

  /** @param {'' | 'left' | 'right'} side */
  selectNearest(side) {
    this.select(nearestToBall(this.record, this.frame, side));
  }

  /** Shows what the selected player estimates. @param {boolean} on */
  setDebugging(on) {
    if (on === this.debugging) return;
    this.debugging = on;
    if (on && (this.selected.length === 0 || !this.decisions.has(this.selected[0]))) this.select(this.decisions.nearest(this.frame));
    this.changed('decisions');
  }

  toggleDecisions() {
    if (!this.decisions) return this.tell('The page has no decisions; cls match --record-world-models records them');
    this.setDebugging(!this.debugging);
    this.say(this.debugging ? 'Decisions' : 'No decisions');
  }

  /** The decisions to draw, or null. */
  get track() {
    return this.debugging && this.selected.length > 0 ? this.decisions.track(this.selected[0]) : null;
  }

  /** Texts and shapes of the frame on the field: of the decision to draw, of the selected players, or of all.
   * @returns {import('./drawing_store.js').Shown[]} */
  get shownDrawings() {
    const {track, frame, teamDrawings: store} = this;
    if (!store || !this.settings.layers.drawings) return [];
    const all = track ? track.drawings(frame) : store.at(frame, this.selected);
    return all.filter(({drawing}) => store.filter.shows(drawing));
  }

  /** Jumps to a frame with texts or drawings. @param {1 | -1} direction */
  jumpToDrawings(direction) {
    const frame = this.teamDrawings.next(this.frame, direction, this.selected);
    if (frame < 0) return this.tell(`No ${direction > 0 ? 'later' : 'earlier'} texts or drawings`);
    this.seek(frame);
  }

  /** @param {'ball' | 'player'} what */
  toggleFollow(what) {
    if (what === 'player' && this.selected.length === 0) this.selectNearest('');
    const {camera} = this;
    camera.follow = camera.follow === what ? '' : what;
    if (camera.follow !== '' && camera.zoom < 1.5) camera.zoomBy(2.5 / camera.zoom);
    this.say(camera.follow === '' ? 'Not following' : `Following the ${what}`);
    this.changed('view');
  }

  /** @param {number} factor @param {number} [x] @param {number} [y] pixels */
  zoom(factor, x, y) {
    this.camera.zoomBy(factor, x, y);
    this.changed('view');
  }

  fit() {
    this.camera.fit();
    this.changed('view');
  }

  /** @param {string} name of a layer */
  toggleLayer(name) {
    const {settings} = this;
    settings.layers[name] = !settings.layers[name];
    settings.save();
    if (name === 'drawings' && (this.teamDrawings?.empty ?? true) && !this.decisions) this.tell(kNothingShown);
    else this.say(`${kLayers.find((layer) => layer.name === name).label}: ${settings.layers[name] ? 'on' : 'off'}`);
    this.changed('settings');
  }

  toggleTheme() {
    this.settings.theme = this.themeName === 'dark' ? 'light' : 'dark';
    this.settings.save();
    this.say(`${this.settings.theme === 'dark' ? 'Dark' : 'Light'} theme`);
    this.changed('settings');
  }

  togglePanel() {
    this.settings.panel = !this.settings.panel;
    this.settings.save();
    this.changed('settings');
  }

  /** Singles out the keys switch: typing then moves nothing. @param {boolean} on */
  setKeys(on) {
    this.settings.keys = on;
    this.settings.save();
    this.changed('settings');
  }

  /** @returns {string} the moment as a hash of the page's address */
  get hash() {
    const {record, frame, clock, camera} = this;
    return formatHash({
      time: record.time(frame),
      stopped: record.stopped(frame),
      selected: this.selected,
      speed: clock.speed,
      view: {zoom: camera.zoom, x: camera.x, y: camera.y},
      follow: camera.follow,
      debugging: this.debugging,
      play: false,
    });
  }

  /** Shows the moment of a hash. @param {string} hash */
  restore(hash) {
    const moment = parseHash(hash);
    if (moment.selected) this.selected = moment.selected;
    if (moment.speed !== null) this.clock.setSpeed(moment.speed);
    if (moment.view) {
      this.camera.fit();
      this.camera.zoomBy(moment.view.zoom);
      this.camera.center(moment.view.x, moment.view.y);
    }
    if (moment.follow !== '') this.camera.follow = /** @type {'ball' | 'player'} */ (moment.follow);
    if (moment.time !== null) this.clock.seek(frameOfCycle(this.record, moment.time, moment.stopped));
    if (moment.play && !this.host.reducedMotion) this.clock.play();
    if (moment.debugging && this.decisions) this.setDebugging(true);
    this.changed('moment');
    this.changed('selection');
  }
}
