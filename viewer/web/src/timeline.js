// The timeline: play modes as bands, events as marks, possession, and the cursor. A slider for keyboard and screen readers.
import {element, setAttribute, setText} from './dom.js';
import {possessionChanges} from './events.js';
import {clamp} from './geometry.js';
import {playModeClass, playModeText, splitPlayMode} from './play_modes.js';
import {cycleLabel} from './record.js';

const kHeight = 62;
const kBandTop = 22;
const kBandHeight = 16;
const kPossessionTop = 40;
const kPossessionHeight = 4;
const kAxisTop = 59;
const kSnapPixels = 6;

export class Timeline {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.width = 1;
    this.back = document.createElement('canvas');
    this.backKey = '';
    this.canvas = element('canvas', {class: 'timeline-canvas', 'aria-hidden': 'true'});
    this.tip = element('div', {class: 'timeline-tip', hidden: true, 'aria-hidden': 'true'});
    this.root = element('div', {class: 'timeline', role: 'slider', tabindex: 0, 'aria-label': 'Time', 'aria-valuemin': 0}, this.canvas, this.tip);
    this.#listen();
  }

  /** @param {number} frame @returns {number} pixels from the left */
  xOf(frame) {
    return (frame / Math.max(1, this.viewer.clock.span)) * this.width;
  }

  #frameOfX(x) {
    const {clock} = this.viewer;
    return Math.min(clock.last, Math.round(clamp(x / this.width, 0, 1) * clock.span));
  }

  #frameAt(event) {
    const x = event.clientX - this.root.getBoundingClientRect().left;
    const near = this.#eventNear(x);
    if (near && event.pointerType !== 'touch') return near.frame;
    return this.#frameOfX(x);
  }

  /** The most important mark at the pointer. */
  #eventNear(x) {
    const near = this.viewer.events.filter((event) => kMarks[event.kind] && Math.abs(this.xOf(event.frame) - x) <= kSnapPixels);
    return near.sort((a, b) => kMarks[a.kind].rank - kMarks[b.kind].rank)[0];
  }

  #listen() {
    let dragging = false;
    this.root.addEventListener('pointerdown', (event) => {
      dragging = true;
      this.root.setPointerCapture(event.pointerId);
      this.viewer.seek(this.#frameAt(event));
    });
    this.root.addEventListener('pointermove', (event) => {
      if (dragging) {
        const x = event.clientX - this.root.getBoundingClientRect().left;
        this.viewer.seek(this.#frameOfX(x));
      }
      this.#showTip(event);
    });
    this.root.addEventListener('pointerup', () => (dragging = false));
    this.root.addEventListener('pointercancel', () => (dragging = false));
    this.root.addEventListener('pointerleave', () => (this.tip.hidden = true));
  }

  #showTip(event) {
    const {record} = this.viewer;
    const x = event.clientX - this.root.getBoundingClientRect().left;
    const frame = this.#frameAt(event);
    const near = this.#eventNear(x);
    const [left, right] = record.teamsAt(frame);
    const text = near ? near.text : playModeText(record.modeName(frame), left.name || 'left', right.name || 'right');
    setText(this.tip, `cycle ${cycleLabel(record, frame)} · ${text}`);
    this.tip.hidden = false;
    this.tip.style.left = `${clamp(x, this.tip.offsetWidth / 2, this.width - this.tip.offsetWidth / 2)}px`;
  }

  resize(ratio) {
    this.width = Math.max(1, this.root.clientWidth);
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(kHeight * ratio);
    this.ratio = ratio;
  }

  draw() {
    const {viewer, canvas, ratio} = this;
    const {theme, clock, record} = viewer;
    const key = [canvas.width, ratio, viewer.themeName, record.frames, clock.span, viewer.events.length].join(' ');
    if (key !== this.backKey) {
      this.backKey = key;
      this.#drawBack(theme);
    }
    const context = canvas.getContext('2d');
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(this.back, 0, 0);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const x = this.xOf(clock.at);
    context.fillStyle = theme.timeline.cursor;
    context.fillRect(clamp(x - 1, 0, this.width - 2), 2, 2, kPossessionTop + kPossessionHeight);
    context.beginPath();
    context.arc(clamp(x, 5, this.width - 5), kBandTop + kBandHeight / 2, 6, 0, 2 * Math.PI);
    context.fill();
    setAttribute(this.root, 'aria-valuemax', String(clock.last));
    setAttribute(this.root, 'aria-valuenow', String(clock.frame));
    setAttribute(this.root, 'aria-valuetext', `cycle ${cycleLabel(record, clock.frame)}`);
  }

  #drawBack(theme) {
    const {back, canvas, ratio} = this;
    back.width = canvas.width;
    back.height = canvas.height;
    const context = back.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.width, kHeight);
    this.#drawModes(context, theme);
    this.#drawPossession(context, theme);
    this.#drawAxis(context, theme);
    const byRank = [...this.viewer.events].sort((a, b) => (kMarks[b.kind]?.rank ?? 9) - (kMarks[a.kind]?.rank ?? 9));
    for (const event of byRank) kMarks[event.kind]?.draw(context, this.xOf(event.frame), theme, event, (frame) => this.xOf(frame));
  }

  #drawModes(context, theme) {
    const {record} = this.viewer;
    const modes = record.column('mode')[0];
    context.save();
    context.beginPath();
    context.roundRect(0, kBandTop, this.width, kBandHeight, 4);
    context.clip();
    context.globalAlpha = 0.35;
    context.fillStyle = theme.timeline.pause;
    context.fillRect(0, kBandTop, this.width, kBandHeight);
    context.globalAlpha = 1;
    let start = 0;
    for (let frame = 1; frame <= record.frames; ++frame) {
      if (frame < record.frames && modes[frame] === modes[start]) continue;
      context.fillStyle = modeColor(record.modeName(start), theme);
      context.fillRect(this.xOf(start), kBandTop, Math.max(1, this.xOf(frame) - this.xOf(start)), kBandHeight);
      start = frame;
    }
    context.restore();
  }

  #drawPossession(context, theme) {
    const changes = possessionChanges(this.viewer.record);
    changes.forEach((change, index) => {
      const end = changes[index + 1]?.frame ?? this.viewer.clock.last;
      context.fillStyle = change.side === 'left' ? theme.left.fill : theme.right.fill;
      context.fillRect(this.xOf(change.frame), kPossessionTop, Math.max(0.5, this.xOf(end) - this.xOf(change.frame)), kPossessionHeight);
    });
  }

  /** Cycle numbers at round distances. */
  #drawAxis(context, theme) {
    const {record} = this.viewer;
    const times = record.column('time')[0];
    const last = Math.max(times[record.frames - 1], this.viewer.clock.expected);
    const wanted = last / Math.max(2, this.width / 90);
    const step = [10, 20, 50, 100, 200, 500, 1000, 2000, 5000].find((each) => each >= wanted) ?? 10000;
    context.fillStyle = theme.timeline.text;
    context.font = '11px system-ui, sans-serif';
    context.textBaseline = 'alphabetic';
    let next = 0;
    for (let frame = 0; frame < record.frames; ++frame) {
      if (times[frame] < next) continue;
      const x = this.xOf(frame);
      context.textAlign = x < 20 ? 'left' : x > this.width - 20 ? 'right' : 'center';
      context.fillText(String(next), x, kAxisTop);
      context.fillRect(clamp(x, 0, this.width - 1), kPossessionTop + kPossessionHeight + 1, 1, 3);
      next = (Math.floor(times[frame] / step) + 1) * step;
    }
  }
}

function modeColor(name, theme) {
  const {side} = splitPlayMode(name);
  const team = side === 'left' ? theme.left : theme.right;
  switch (playModeClass(name)) {
    case 'play': return theme.timeline.play;
    case 'goal': return team.fill;
    case 'set_play': return `${team.glow}0.55)`;
    case 'offense': return `${team.glow}0.3)`;
    default: return theme.timeline.pause;
  }
}

/** Marks above the band. Those of a lower rank are drawn on top. */
const kMarks = {
  goal: {rank: 0, draw: drawGoalMark},
  card: {rank: 1, draw: drawCardMark},
  shot: {rank: 2, draw: drawShotMark},
  turnover: {rank: 3, draw: drawTurnoverMark},
  missed: {rank: 4, draw: drawMissedMark},
  costly: {rank: 1, draw: drawCostlyMark},
};

function sideColor(theme, event) {
  return event.side === 'right' ? theme.right.fill : theme.left.fill;
}

function drawGoalMark(context, x, theme, event) {
  context.fillStyle = sideColor(theme, event);
  context.strokeStyle = theme.timeline.cursor;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, 11, 6.5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.fillRect(x - 0.75, 17, 1.5, kBandTop - 17 + kBandHeight);
}

/** The area of the triangle grows with the expected goals. */
function drawShotMark(context, x, theme, event) {
  const size = 4 + 5 * Math.sqrt(event.expectedGoals ?? 0.1);
  context.fillStyle = sideColor(theme, event);
  context.beginPath();
  context.moveTo(x - size, 19 - size * 1.6);
  context.lineTo(x + size, 19 - size * 1.6);
  context.lineTo(x, 19);
  context.closePath();
  context.fill();
}

function drawCardMark(context, x, theme, event) {
  context.fillStyle = event.red ? '#e5383b' : '#ffd60a';
  context.strokeStyle = sideColor(theme, event);
  context.lineWidth = 1.5;
  context.beginPath();
  context.rect(x - 3.5, 6, 7, 11);
  context.fill();
  context.stroke();
}

/** Below the band, as wide as the decisions were missed for. */
function drawMissedMark(context, x, theme, event, xOf) {
  context.fillStyle = theme.warn;
  context.fillRect(x - 1, kPossessionTop, Math.max(2, xOf(event.end) - x), kPossessionHeight + 5);
}

/** A diamond across the band. */
function drawCostlyMark(context, x, theme, event) {
  const middle = kBandTop + kBandHeight / 2;
  context.fillStyle = sideColor(theme, event);
  context.strokeStyle = theme.timeline.cursor;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, middle - 7);
  context.lineTo(x + 5, middle);
  context.lineTo(x, middle + 7);
  context.lineTo(x - 5, middle);
  context.closePath();
  context.fill();
  context.stroke();
}

function drawTurnoverMark(context, x, theme, event) {
  context.fillStyle = sideColor(theme, event);
  context.fillRect(x - 0.75, kBandTop - 4, 1.5, 4);
}
