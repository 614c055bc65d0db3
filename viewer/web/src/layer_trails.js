// Where ball and players were in the frames before.
import {ballGlides, isContinuous, playerGlides} from './interpolate.js';
import {teamColors} from './theme.js';
import {kSlots} from './sides.js';

const kBallTrail = 40;
const kPlayerTrail = 60;
const kPieces = 5;

/** @param {import('./scene.js').Scene} scene */
export function drawTrails(scene) {
  const {layers, selected, pose, theme} = scene;
  if (!layers.trails && !layers.allTrails) return;
  for (let slot = 0; slot < kSlots; ++slot) {
    if (!pose.isEnabled(slot) || !(layers.allTrails || selected.includes(slot))) continue;
    drawTrail(scene, {
      x: scene.record.column('x')[slot],
      y: scene.record.column('y')[slot],
      end: [pose.x[slot], pose.y[slot]],
      frames: kPlayerTrail,
      color: teamColors(theme, slot).glow,
      width: 1.6,
      glides: (frame) => playerGlides(scene.record, slot, frame),
    });
  }
  drawTrail(scene, {
    x: scene.record.column('ball_x')[0],
    y: scene.record.column('ball_y')[0],
    end: [pose.ballX, pose.ballY],
    frames: kBallTrail,
    color: 'rgba(255, 255, 255, ',
    width: 2.2,
    glides: (frame) => ballGlides(scene.record, frame),
  });
}

/** The first frame of a path that leads to the shown frame without a jump. */
function pathStart(scene, frames, glides) {
  const last = scene.pose.frame;
  let frame = last;
  while (frame > 0 && frame > last - frames && isContinuous(scene.record, frame - 1) && glides(frame - 1)) --frame;
  return frame;
}

/** A line in pieces that fade towards the past. */
function drawTrail(scene, trail) {
  const {context, camera, pose} = scene;
  const {x, y, end} = trail;
  const first = pathStart(scene, trail.frames, trail.glides);
  const length = pose.frame - first;
  if (length < 1) return;
  context.lineWidth = trail.width;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  for (let piece = 0; piece < kPieces; ++piece) {
    const from = first + Math.floor((length * piece) / kPieces);
    const to = first + Math.floor((length * (piece + 1)) / kPieces);
    const age = pose.frame - (from + to) / 2;
    context.strokeStyle = `${trail.color}${(0.75 * (1 - age / trail.frames)).toFixed(3)})`;
    context.beginPath();
    context.moveTo(camera.screenX(x[from]), camera.screenY(y[from]));
    for (let frame = from + 1; frame <= to; ++frame) context.lineTo(camera.screenX(x[frame]), camera.screenY(y[frame]));
    if (piece === kPieces - 1) context.lineTo(camera.screenX(end[0]), camera.screenY(end[1]));
    context.stroke();
  }
  context.lineCap = 'butt';
}
