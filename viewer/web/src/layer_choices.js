// Where the ball would have gone with each choice of a decision that was played again.
import {replayedAt} from './replayed.js';
import {traceDisc} from './scene.js';
import {teamColors} from './theme.js';

const kDash = [5, 5];

/** @param {import('./scene.js').Scene} scene */
export function drawChoices(scene) {
  const {context, record, pose} = scene;
  const replayed = replayedAt(record, pose.frame);
  if (!replayed) return;
  const from = [record.column('ball_x')[0][replayed.frame], record.column('ball_y')[0][replayed.frame]];
  context.save();
  replayed.choices.forEach((choice, index) => {
    if (choice.target && index !== replayed.best) drawChoicePath(scene, replayed, from, choice.target, false);
  });
  const best = replayed.choices[replayed.best];
  if (best.target) drawChoicePath(scene, replayed, from, best.target, true);
  // To hold the ball, and to clear it, has no aim: then the ball itself bears the label.
  drawChoiceLabel(scene, best.target ?? from, `${best.text} ${signed(best.mean - replayed.choices[0].mean)}`);
  context.restore();
}

/** @param {number} value @returns {string} '+0.14' */
export function signed(value) {
  return `${value < 0 ? '\u2212' : '+'}${Math.abs(value).toFixed(2)}`;
}

/** A line that ends in a disc. @param {import('./scene.js').Scene} scene */
export function drawChoicePath({context, camera, theme}, {slot}, from, to, best) {
  context.strokeStyle = best ? theme.timeline.cursor : teamColors(theme, slot).fill;
  context.fillStyle = context.strokeStyle;
  context.globalAlpha = best ? 1 : 0.6;
  context.lineWidth = best ? 2.5 : 1.5;
  context.setLineDash(best ? [] : kDash);
  context.beginPath();
  context.moveTo(camera.screenX(from[0]), camera.screenY(from[1]));
  context.lineTo(camera.screenX(to[0]), camera.screenY(to[1]));
  context.stroke();
  traceDisc(context, camera.screenX(to[0]), camera.screenY(to[1]), best ? 4 : 2.5);
  context.fill();
  context.globalAlpha = 1;
}

/** @param {import('./scene.js').Scene} scene @param {number[]} at */
export function drawChoiceLabel({context, camera, theme}, at, text) {
  const x = camera.screenX(at[0]);
  const y = camera.screenY(at[1]) - 12;
  context.setLineDash([]);
  context.font = '600 12px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = theme.halo;
  context.strokeText(text, x, y);
  context.fillStyle = theme.timeline.cursor;
  context.fillText(text, x, y);
}
