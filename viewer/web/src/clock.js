// The clock of the page: the only owner of the shown moment. The time axis is frames, so stopped clocks are visible.
import {clamp} from './geometry.js';

export const kSpeeds = Object.freeze([0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50]);

/** A hidden or busy tab must not skip minutes of play. */
const kMaxTickMs = 250;

/** A live match is shown this much behind its newest frame, so that frames that arrive unevenly move evenly. */
const kLiveDelayMs = 150;

export class Clock {
  /** @param {number} frames @param {number} [frameMs] length of a cycle in real time */
  constructor(frames, frameMs = 100) {
    this.frames = frames;
    this.frameMs = frameMs;
    /** The shown moment: frame and fraction of the step to the next one. */
    this.at = 0;
    this.playing = false;
    this.speed = 1;
    this.backwards = false;
    /** @type {[number, number][]} pairs of first and last frame, while highlights play */
    this.segments = [];
    /** More frames will come. */
    this.live = false;
    /** Shows the newest frame as frames come. */
    this.following = false;
    /** Frames that the whole match may have; of a live match. */
    this.expected = 0;
    /** Counts changes, so that views know when to draw. */
    this.version = 0;
  }

  get last() {
    return Math.max(0, this.frames - 1);
  }

  /** Frames that a time axis has room for. */
  get span() {
    return this.live ? Math.max(this.last, this.expected) : this.last;
  }

  /** True if nothing changes until the match grows. */
  get waiting() {
    return this.following && this.live && this.at >= this.last;
  }

  get frame() {
    return Math.floor(this.at + 1e-9);
  }

  get direction() {
    return this.backwards ? -1 : 1;
  }

  /** Frames of the log that pass in one second. */
  get framesPerSecond() {
    return (1000 / this.frameMs) * this.speed;
  }

  /** Shows a frame. Keeps playing if it plays. */
  seek(at) {
    this.following = false;
    this.at = clamp(at, 0, this.last);
    ++this.version;
  }

  play() {
    if (this.live && !this.backwards && this.at >= this.last) return this.follow();
    if (!this.backwards && this.at >= this.last) this.at = 0;
    if (this.backwards && this.at <= 0) this.at = this.last;
    this.playing = true;
    ++this.version;
  }

  /** Shows the newest frame from now on. */
  follow() {
    this.segments = [];
    this.backwards = false;
    this.following = true;
    this.playing = true;
    ++this.version;
  }

  /** @param {number} frames @param {boolean} live whether more will come */
  grow(frames, live) {
    this.frames = frames;
    this.live = live;
    ++this.version;
  }

  /** Stops on a whole frame: a paused page shows the numbers of the log. */
  pause() {
    this.playing = false;
    this.segments = [];
    this.seek(Math.round(this.at));
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Pauses and moves by whole frames. */
  step(frames) {
    this.playing = false;
    this.segments = [];
    this.seek(Math.round(this.at) + frames);
  }

  setSpeed(speed) {
    this.speed = clamp(speed, kSpeeds[0], kSpeeds[kSpeeds.length - 1]);
    ++this.version;
  }

  /** The next faster or slower speed. @param {1 | -1} direction */
  changeSpeed(direction) {
    const faster = kSpeeds.filter((speed) => speed > this.speed);
    const slower = kSpeeds.filter((speed) => speed < this.speed);
    this.setSpeed(direction > 0 ? (faster[0] ?? this.speed) : (slower[slower.length - 1] ?? this.speed));
  }

  reverse() {
    this.following = false;
    this.backwards = !this.backwards;
    ++this.version;
  }

  /** Plays pieces of the match in sequence, then pauses. @param {[number, number][]} segments */
  playSegments(segments) {
    if (segments.length === 0) return;
    this.following = false;
    this.segments = segments;
    this.backwards = false;
    this.at = segments[0][0];
    this.playing = true;
    ++this.version;
  }

  /** Advances by real time. @param {number} elapsedMs @returns {boolean} true if the moment changed */
  tick(elapsedMs) {
    if (!this.playing) return false;
    if (this.following) return this.#tickLive(elapsedMs);
    this.at += (this.direction * Math.min(elapsedMs, kMaxTickMs) * this.speed) / this.frameMs;
    this.#leaveSegment();
    if (this.at >= this.last || this.at <= 0) {
      const ended = this.backwards ? this.at <= 0 : this.at >= this.last;
      this.at = clamp(this.at, 0, this.last);
      if (ended && this.live && !this.backwards) this.follow();
      else if (ended) this.pause();
    }
    ++this.version;
    return true;
  }

  /** The farther behind, the faster: in the mean the delay above, at any speed of the match. */
  #tickLive(elapsedMs) {
    const before = this.at;
    const behind = this.last - this.at;
    this.at = behind < 0.02 ? this.last : this.at + behind * (1 - Math.exp(-elapsedMs / kLiveDelayMs));
    if (!this.live && this.at >= this.last) this.pause();
    ++this.version;
    return this.at !== before;
  }

  #leaveSegment() {
    if (this.segments.length === 0) return;
    const index = this.segments.findIndex(([, end]) => end >= this.at);
    if (index < 0) {
      this.at = this.segments[this.segments.length - 1][1];
      this.pause();
    } else if (this.at < this.segments[index][0]) {
      this.at = this.segments[index][0];
    }
  }
}
