// Positions between two frames. Nothing glides where the match jumps.
import {angleBetween} from './geometry.js';
import {PlayerState} from './player_state.js';
import {kSlots} from './sides.js';

/** A step longer than this times the top speed is a move, not a run. */
const kJumpFactor = 1.5;
const kDefaultTopSpeed = 1.05;

/** What is drawn: the ball and 22 slots at a moment. Reused from picture to picture. */
export class Pose {
  constructor() {
    this.frame = 0;
    this.fraction = 0;
    this.ballX = 0;
    this.ballY = 0;
    /** Meters above the ground; 0 in all logs but those of the 2.5D server. */
    this.ballZ = 0;
    this.x = new Float64Array(kSlots);
    this.y = new Float64Array(kSlots);
    this.body = new Float64Array(kSlots);
    this.neck = new Float64Array(kSlots);
    /** State bits of the frame. */
    this.state = new Int32Array(kSlots);
  }

  isEnabled(slot) {
    return (this.state[slot] & PlayerState.enabled) !== 0;
  }
}

/** True if the clock runs on from `frame` to the next frame without a gap.
 * @param {import('./record.js').MatchRecord} record @param {number} frame */
export function isContinuous(record, frame) {
  if (frame + 1 >= record.frames) return false;
  const cycles = record.time(frame + 1) - record.time(frame);
  return cycles === 1 || (cycles === 0 && record.stopped(frame + 1) - record.stopped(frame) <= 1);
}

/** True if a player of `slot` moves to the next frame on its feet.
 * @param {import('./record.js').MatchRecord} record @param {number} slot @param {number} frame */
export function playerGlides(record, slot, frame) {
  const state = record.column('state')[slot];
  if ((state[frame] & state[frame + 1] & PlayerState.enabled) === 0) return false;
  const x = record.column('x')[slot];
  const y = record.column('y')[slot];
  const top = record.playerType(slot, frame).player_speed_max ?? kDefaultTopSpeed;
  return Math.hypot(x[frame + 1] - x[frame], y[frame + 1] - y[frame]) <= kJumpFactor * top;
}

/** True if the ball rolls to the next frame.
 * @param {import('./record.js').MatchRecord} record @param {number} frame */
export function ballGlides(record, frame) {
  const x = record.column('ball_x')[0];
  const y = record.column('ball_y')[0];
  const longest = record.parameter('ball_speed_max', 3) + record.parameter('ball_accel_max', 2.7);
  return Math.hypot(x[frame + 1] - x[frame], y[frame + 1] - y[frame]) <= longest;
}

/** Fills `pose` with the moment `at`; `smooth` false shows whole frames only.
 * @param {import('./record.js').MatchRecord} record @param {number} at @param {Pose} pose @param {boolean} [smooth] */
export function poseAt(record, at, pose, smooth = true) {
  const frame = Math.min(Math.floor(at + 1e-9), record.frames - 1);
  const fraction = Math.max(0, at - frame);
  const between = smooth && fraction > 1e-6 && isContinuous(record, frame);
  pose.frame = frame;
  pose.fraction = between ? fraction : 0;

  const glide = between && ballGlides(record, frame) ? fraction : 0;
  pose.ballX = mixed(record.column('ball_x')[0], frame, glide);
  pose.ballY = mixed(record.column('ball_y')[0], frame, glide);
  pose.ballZ = mixed(record.column('ball_z')[0], frame, glide);
  for (let slot = 0; slot < kSlots; ++slot) posePlayer(record, slot, frame, between ? fraction : 0, pose);
}

function posePlayer(record, slot, frame, fraction, pose) {
  const moving = fraction > 0 && playerGlides(record, slot, frame) ? fraction : 0;
  const body = record.column('body')[slot];
  const neck = record.column('neck')[slot];
  pose.state[slot] = record.column('state')[slot][frame];
  pose.x[slot] = mixed(record.column('x')[slot], frame, moving);
  pose.y[slot] = mixed(record.column('y')[slot], frame, moving);
  pose.body[slot] = moving > 0 ? angleBetween(body[frame], body[frame + 1], moving) : body[frame];
  pose.neck[slot] = moving > 0 ? angleBetween(neck[frame], neck[frame + 1], moving) : neck[frame];
}

function mixed(values, frame, fraction) {
  return fraction > 0 ? values[frame] + (values[frame + 1] - values[frame]) * fraction : values[frame];
}
