// Curves of a player's decisions over the match: errors, age of the ball, latency. A click shows the moment.
import {element, setText} from './dom.js';
import {missText} from './decision_track.js';
import {clamp} from './geometry.js';

const kDecisionStripHeight = 38;

/** Label, unit, values of a decision, and the least value of the top of the strip. */
const kStrips = [
  {label: 'Error of the ball', unit: 'm', top: 5, value: (track, i) => track.ballErrors[i]},
  {label: 'Error of its own position', unit: 'm', top: 1, value: (track, i) => track.selfErrors[i]},
  {label: 'Age of the ball', unit: 'cycles', top: 10, value: (track, i) => Math.max(0, track.decisions.value('ball_age', i))},
  {label: 'Latency of the reply', unit: 'ms', top: 1, value: (track, i) => (track.decisions.latencies[i] ?? 0) / 1000},
];

export class DecisionStrips {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.strips = kStrips.map((strip) => this.#makeStrip(strip));
    this.root = element('div', {class: 'decision-strips'}, ...this.strips.map(({root}) => root));
    this.track = null;
  }

  #makeStrip(strip) {
    const canvas = element('canvas', {class: 'decision-strip', 'aria-hidden': 'true', onpointerdown: (event) => this.#seek(event, canvas)});
    const output = element('span', {class: 'strip-value'});
    const root = element('div', {}, element('p', {class: 'strip-label'}, element('span', {}, strip.label), output), canvas);
    return {...strip, canvas, output, root, key: ''};
  }

  #seek(event, canvas) {
    const share = clamp((event.clientX - canvas.getBoundingClientRect().left) / Math.max(1, canvas.clientWidth), 0, 1);
    this.viewer.seek(Math.round(share * (this.viewer.record.frames - 1)));
  }

  /** @param {import('./decision_track.js').DecisionTrack} track @param {number} decision -1: none in this frame */
  show(track, decision) {
    for (const strip of this.strips) {
      const value = decision < 0 ? NaN : strip.value(track, decision);
      setText(strip.output, Number.isNaN(value) ? 'unknown' : `${value.toFixed(strip.unit === 'cycles' ? 0 : 2)} ${strip.unit}`);
      this.#draw(strip, track);
    }
  }

  #draw(strip, track) {
    const {viewer} = this;
    const {canvas} = strip;
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, canvas.clientWidth);
    const key = [track.slot, width, ratio, viewer.themeName, viewer.frame].join(' ');
    if (key === strip.key) return;
    strip.key = key;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(kDecisionStripHeight * ratio);
    const context = canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = viewer.theme.timeline.back;
    context.fillRect(0, 0, width, kDecisionStripHeight);
    drawPeaks(context, strip, track, width, viewer.theme.left.fill);
    drawMisses(context, track, width, viewer.theme.warn);
    context.fillStyle = viewer.theme.timeline.cursor;
    context.fillRect((viewer.frame / Math.max(1, viewer.record.frames - 1)) * (width - 1), 0, 1, kDecisionStripHeight);
  }
}

/** The largest value of each column of pixels. */
function drawPeaks(context, strip, track, width, color) {
  const peaks = new Float32Array(Math.ceil(width));
  const frames = Math.max(1, track.record.frames - 1);
  let top = strip.top;
  for (let i = 0; i < track.decisions.count; ++i) {
    const frame = track.frames[i];
    const value = strip.value(track, i);
    if (frame < 0 || !(value > 0)) continue;
    const x = Math.min(peaks.length - 1, Math.floor((frame / frames) * width));
    if (value > peaks[x]) peaks[x] = value;
  }
  for (const peak of peaks) top = Math.max(top, Math.min(peak, 10 * strip.top));
  context.fillStyle = color;
  peaks.forEach((peak, x) => {
    const height = Math.min(1, peak / top) * kDecisionStripHeight;
    context.fillRect(x, kDecisionStripHeight - height, 1, height);
  });
}

/** Ticks where a decision was missed. */
function drawMisses(context, track, width, color) {
  const frames = Math.max(1, track.record.frames - 1);
  context.fillStyle = color;
  for (let i = 0; i < track.decisions.count; ++i) {
    if (track.frames[i] < 0 || missText(track.decisions.value('call', i)) === '') continue;
    context.fillRect((track.frames[i] / frames) * (width - 1), 0, 2, 6);
  }
}
