// What the layers draw from: one moment with its view, settings and selection.
import {clamp} from './geometry.js';

/**
 * @typedef {object} Scene
 * @property {CanvasRenderingContext2D} context scaled to CSS pixels
 * @property {import('./record.js').MatchRecord} record
 * @property {import('./interpolate.js').Pose} pose
 * @property {import('./camera.js').Camera} camera
 * @property {import('./theme.js').Theme} theme
 * @property {import('./settings.js').Layers} layers
 * @property {number[]} selected slots
 * @property {import('./decision_track.js').DecisionTrack | null} [track] decisions whose estimates to draw
 * @property {import('./drawing_store.js').Shown[]} [drawings] of Playmakers
 * @property {number} markFrames how many frames a mark of one frame stays visible
 */

/** Radius of a player's disc in pixels: large enough to read the number, the real size when zoomed in.
 * @param {import('./camera.js').Camera} camera */
export function discRadius(camera) {
  return Math.max(0.3 * camera.scale, clamp(1.08 * camera.scale, 6.5, 16));
}

/** @param {import('./camera.js').Camera} camera */
export function ballRadius(camera) {
  return Math.max(0.085 * camera.scale, clamp(0.42 * camera.scale, 3.2, 6.5));
}

/** A frame up to `count` frames back in which a player has one of the bits; -1 if there is none.
 * @param {Scene} scene @param {number} slot @param {number} bits */
export function lastFrameWith(scene, slot, bits) {
  const states = scene.record.column('state')[slot];
  const first = Math.max(0, scene.pose.frame - scene.markFrames + 1);
  for (let frame = scene.pose.frame; frame >= first; --frame) {
    if (states[frame] & bits) return frame;
  }
  return -1;
}

/** Traces a circle. */
export function traceDisc(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}
