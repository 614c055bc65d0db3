// Offside lines of both attacks.
import {kPitch} from './pitch.js';
import {kPlayersPerTeam} from './sides.js';

/** How far the left team (direction 1) or the right team (-1) may stand up the pitch: the second last opponent, the
 * ball or the halfway line, whichever is farthest.
 * @param {import('./interpolate.js').Pose} pose @param {1 | -1} direction @returns {number} x in meters */
export function offsideLineX(pose, direction) {
  let last = -Infinity;
  let second = -Infinity;
  const firstSlot = direction > 0 ? kPlayersPerTeam : 0;
  for (let slot = firstSlot; slot < firstSlot + kPlayersPerTeam; ++slot) {
    if (!pose.isEnabled(slot)) continue;
    const x = pose.x[slot] * direction;
    if (x > last) {
      second = last;
      last = x;
    } else if (x > second) {
      second = x;
    }
  }
  const line = Math.max(second, pose.ballX * direction, 0);
  return Math.min(line, kPitch.length / 2) * direction;
}

/** @param {import('./scene.js').Scene} scene */
export function drawOffsideLines(scene) {
  if (!scene.layers.offside) return;
  const {context, camera, theme, pose} = scene;
  for (const [direction, colors] of [[1, theme.left], [-1, theme.right]]) {
    const x = camera.screenX(offsideLineX(pose, direction));
    context.strokeStyle = colors.fill;
    context.lineWidth = 1.5;
    context.setLineDash(direction > 0 ? [7, 4] : [2, 4]);
    context.beginPath();
    context.moveTo(x, camera.screenY(-kPitch.width / 2));
    context.lineTo(x, camera.screenY(kPitch.width / 2));
    context.stroke();
    context.setLineDash([]);
  }
}
