// One time axis for two matches: the clock of the log, cycle and stopped cycles.

/**
 * @typedef {{length: number, frames: [Int32Array, Int32Array]}} CommonAxis frames of both matches by moment of the axis
 */

/** Order of two moments. */
function compareMoments(a, i, b, j) {
  return a.time(i) - b.time(j) || a.stopped(i) - b.stopped(j);
}

/** Each moment that one of the records has; the other then shows its last frame before it.
 * @param {import('./record.js').MatchRecord} a @param {import('./record.js').MatchRecord} b @returns {CommonAxis} */
export function commonAxis(a, b) {
  const room = a.frames + b.frames;
  const frames = /** @type {[Int32Array, Int32Array]} */ ([new Int32Array(room), new Int32Array(room)]);
  let length = 0;
  for (let i = 0, j = 0; i < a.frames || j < b.frames; ++length) {
    const order = i >= a.frames ? 1 : j >= b.frames ? -1 : compareMoments(a, i, b, j);
    frames[0][length] = order <= 0 ? i++ : Math.max(0, i - 1);
    frames[1][length] = order >= 0 ? j++ : Math.max(0, j - 1);
  }
  return {length, frames: [frames[0].slice(0, length), frames[1].slice(0, length)]};
}

/** Frame of a match at a moment between two of the axis, with its fraction. Nothing moves where it has one frame for both.
 * @param {CommonAxis} axis @param {0 | 1} match @param {number} at */
export function frameAtMoment(axis, match, at) {
  const index = Math.min(axis.length - 1, Math.floor(at + 1e-9));
  const frame = axis.frames[match][index];
  const next = axis.frames[match][Math.min(axis.length - 1, index + 1)];
  return frame + Math.max(0, at - index) * Math.min(1, next - frame);
}

/** The first moment at which a match shows a frame. @param {CommonAxis} axis @param {0 | 1} match @param {number} frame */
export function momentOfFrame(axis, match, frame) {
  const index = axis.frames[match].findIndex((each) => each >= frame);
  return index < 0 ? axis.length - 1 : index;
}

/** Mean distance in meters between the places of ball and players in both matches, by moment.
 * @param {CommonAxis} axis @param {import('./record.js').MatchRecord} a @param {import('./record.js').MatchRecord} b */
export function distances(axis, a, b) {
  const means = new Float32Array(axis.length);
  for (let at = 0; at < axis.length; ++at) {
    const i = axis.frames[0][at];
    const j = axis.frames[1][at];
    let sum = Math.hypot(a.column('ball_x')[0][i] - b.column('ball_x')[0][j], a.column('ball_y')[0][i] - b.column('ball_y')[0][j]);
    let count = 1;
    for (let slot = 0; slot < 22; ++slot) {
      if (!(a.column('state')[slot][i] & b.column('state')[slot][j] & 1)) continue;
      sum += Math.hypot(a.column('x')[slot][i] - b.column('x')[slot][j], a.column('y')[slot][i] - b.column('y')[slot][j]);
      ++count;
    }
    means[at] = Number.isFinite(sum) ? sum / count : 0;
  }
  return means;
}
