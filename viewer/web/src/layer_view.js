// Where players look and point: view cones, focus points, arms.
import {radians} from './geometry.js';
import {teamColors} from './theme.js';
import {traceDisc} from './scene.js';
import {kSlots} from './sides.js';

const kConeLength = 22;

/** @param {import('./scene.js').Scene} scene */
export function drawView(scene) {
  const {layers, selected, pose} = scene;
  for (let slot = 0; slot < kSlots; ++slot) {
    if (!pose.isEnabled(slot)) continue;
    const chosen = selected.includes(slot);
    if (layers.view || chosen) drawCone(scene, slot, chosen);
    if (layers.focus) drawFocus(scene, slot);
    if (layers.pointing || chosen) drawArm(scene, slot);
  }
}

function drawCone(scene, slot, chosen) {
  const {context, camera, pose, record, theme} = scene;
  const x = camera.screenX(pose.x[slot]);
  const y = camera.screenY(pose.y[slot]);
  const middle = pose.body[slot] + pose.neck[slot];
  const half = record.column('view_width')[slot][pose.frame] / 2;
  const radius = kConeLength * camera.scale;
  const {glow} = teamColors(theme, slot);
  const fade = context.createRadialGradient(x, y, 0, x, y, radius);
  fade.addColorStop(0, `${glow}${chosen ? 0.42 : 0.2})`);
  fade.addColorStop(1, `${glow}0)`);
  context.fillStyle = fade;
  context.beginPath();
  context.moveTo(x, y);
  context.arc(x, y, radius, radians(middle - half), radians(middle + half));
  context.closePath();
  context.fill();
  if (!chosen) return;
  context.strokeStyle = `${glow}0.55)`;
  context.lineWidth = 1;
  traceDisc(context, x, y, record.parameter('visible_distance', 3) * camera.scale);
  context.stroke();
}

function drawFocus(scene, slot) {
  const {context, camera, pose, record, theme} = scene;
  const distance = record.column('focus_distance')[slot][pose.frame];
  const direction = radians(pose.body[slot] + pose.neck[slot] + record.column('focus_direction')[slot][pose.frame]);
  const x = camera.screenX(pose.x[slot] + distance * Math.cos(direction));
  const y = camera.screenY(pose.y[slot] + distance * Math.sin(direction));
  context.strokeStyle = teamColors(theme, slot).fill;
  context.lineWidth = 1.25;
  context.beginPath();
  context.moveTo(x - 4, y - 4);
  context.lineTo(x + 4, y + 4);
  context.moveTo(x + 4, y - 4);
  context.lineTo(x - 4, y + 4);
  context.stroke();
}

function drawArm(scene, slot) {
  const {context, camera, pose, record, theme} = scene;
  const pointX = record.column('point_x')[slot][pose.frame];
  const pointY = record.column('point_y')[slot][pose.frame];
  if (Number.isNaN(pointX)) return;
  context.strokeStyle = teamColors(theme, slot).fill;
  context.lineWidth = 1.25;
  context.setLineDash([5, 4]);
  context.beginPath();
  context.moveTo(camera.screenX(pose.x[slot]), camera.screenY(pose.y[slot]));
  context.lineTo(camera.screenX(pointX), camera.screenY(pointY));
  context.stroke();
  context.setLineDash([]);
}
