// What a player reaches: kickable area, tackle area, and the goalie's catch area.
import {PlayerState} from './player_state.js';
import {radians} from './geometry.js';
import {teamColors} from './theme.js';
import {traceDisc} from './scene.js';
import {kSlots} from './sides.js';

/** @param {import('./scene.js').Scene} scene */
export function drawAreas(scene) {
  const {layers, selected, pose} = scene;
  for (let slot = 0; slot < kSlots; ++slot) {
    if (!pose.isEnabled(slot)) continue;
    const chosen = selected.includes(slot);
    if (layers.kick || chosen) drawKickableArea(scene, slot);
    if (layers.tackle) drawTackleArea(scene, slot);
    if (layers.catch && pose.state[slot] & PlayerState.goalie) drawCatchArea(scene, slot);
  }
}

function prepare(scene, slot, alpha) {
  const {context, theme} = scene;
  const colors = teamColors(theme, slot);
  context.fillStyle = `${colors.glow}${alpha})`;
  context.strokeStyle = `${colors.glow}0.8)`;
  context.lineWidth = 1;
}

function drawKickableArea(scene, slot) {
  const {context, camera, pose, record} = scene;
  const type = record.playerType(slot, pose.frame);
  const reach = (type.player_size ?? 0.3) + (type.kickable_margin ?? 0.7) + record.parameter('ball_size', 0.085);
  prepare(scene, slot, 0.16);
  traceDisc(context, camera.screenX(pose.x[slot]), camera.screenY(pose.y[slot]), reach * camera.scale);
  context.fill();
  context.stroke();
}

function drawTackleArea(scene, slot) {
  const {context, camera, pose, record} = scene;
  const front = record.parameter('tackle_dist', 2);
  const back = record.parameter('tackle_back_dist', 0);
  const width = record.parameter('tackle_width', 1.25);
  prepare(scene, slot, 0.13);
  context.save();
  context.translate(camera.screenX(pose.x[slot]), camera.screenY(pose.y[slot]));
  context.rotate(radians(pose.body[slot]));
  context.beginPath();
  context.rect(-back * camera.scale, -width * camera.scale, (front + back) * camera.scale, 2 * width * camera.scale);
  context.fill();
  context.stroke();
  context.restore();
}

/** The farthest points that a catch reaches in any direction: half the width beside, the length ahead. */
function drawCatchArea(scene, slot) {
  const {context, camera, pose, record} = scene;
  const stretch = record.playerType(slot, pose.frame).catchable_area_l_stretch ?? 1;
  const length = record.parameter('catchable_area_l', 1.2) * stretch;
  const reach = Math.hypot(length, record.parameter('catchable_area_w', 1) / 2);
  prepare(scene, slot, 0.12);
  context.setLineDash([4, 3]);
  traceDisc(context, camera.screenX(pose.x[slot]), camera.screenY(pose.y[slot]), reach * camera.scale);
  context.fill();
  context.stroke();
  context.setLineDash([]);
}
