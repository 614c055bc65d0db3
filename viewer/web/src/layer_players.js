// Players: a disc with number, body, neck, stamina, marks of actions, cards. The left team's discs are plain, the right
// team's have an inner ring, goalies are light with a colored edge, so color is never the only difference.
import {PlayerState} from './player_state.js';
import {clamp, radians} from './geometry.js';
import {discRadius, lastFrameWith, traceDisc} from './scene.js';
import {teamColors} from './theme.js';
import {kPlayersPerTeam, kSlots, unumOfSlot} from './sides.js';

/** @param {import('./scene.js').Scene} scene */
export function drawPlayers(scene) {
  for (let slot = 0; slot < kSlots; ++slot) {
    if (scene.pose.isEnabled(slot) && !scene.selected.includes(slot)) drawPlayer(scene, slot, false);
  }
  for (const slot of scene.selected) {
    if (scene.pose.isEnabled(slot)) drawPlayer(scene, slot, true);
  }
}

function drawPlayer(scene, slot, chosen) {
  const {context, camera, pose} = scene;
  const x = camera.screenX(pose.x[slot]);
  const y = camera.screenY(pose.y[slot]);
  const radius = discRadius(camera);
  if (x < -40 || y < -40 || x > camera.width + 40 || y > camera.height + 40) return;
  if (chosen) drawSelection(scene, x, y, radius);
  drawDirection(scene, slot, x, y, radius);
  drawDisc(scene, slot, x, y, radius);
  drawActionMark(scene, slot, x, y, radius);
  if (scene.layers.stamina) drawStamina(scene, slot, x, y, radius);
  drawLabel(scene, slot, x, y, radius);
  drawCard(scene, slot, x, y, radius);
  context.globalAlpha = 1;
}

function drawSelection(scene, x, y, radius) {
  const {context, theme} = scene;
  context.strokeStyle = theme.text;
  context.lineWidth = 2;
  traceDisc(context, x, y, radius + 6);
  context.stroke();
}

/** The nose shows the body, the thin line the neck. */
function drawDirection(scene, slot, x, y, radius) {
  const {context, pose, theme} = scene;
  const colors = teamColors(theme, slot);
  const body = radians(pose.body[slot]);
  const neck = radians(pose.body[slot] + pose.neck[slot]);
  context.strokeStyle = theme.text;
  context.lineWidth = 1.25;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + Math.cos(neck) * radius * 1.75, y + Math.sin(neck) * radius * 1.75);
  context.stroke();
  const tip = radius * 1.5;
  context.fillStyle = colors.fill;
  context.strokeStyle = theme.ballEdge;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(x + Math.cos(body) * tip, y + Math.sin(body) * tip);
  context.lineTo(x + Math.cos(body + 0.75) * radius, y + Math.sin(body + 0.75) * radius);
  context.lineTo(x + Math.cos(body - 0.75) * radius, y + Math.sin(body - 0.75) * radius);
  context.closePath();
  context.fill();
  context.stroke();
}

function drawDisc(scene, slot, x, y, radius) {
  const {context, pose, theme} = scene;
  const colors = teamColors(theme, slot);
  const goalie = (pose.state[slot] & PlayerState.goalie) !== 0;
  context.fillStyle = goalie ? theme.ball : colors.fill;
  context.strokeStyle = goalie ? colors.fill : theme.ballEdge;
  context.lineWidth = goalie ? Math.max(2, radius * 0.22) : 1.25;
  traceDisc(context, x, y, goalie ? radius - context.lineWidth / 2 : radius);
  context.fill();
  context.stroke();
  if (slot >= kPlayersPerTeam) {
    context.strokeStyle = goalie ? colors.fill : colors.ring;
    context.lineWidth = Math.max(1, radius * 0.12);
    traceDisc(context, x, y, radius * (goalie ? 0.62 : 0.86));
    context.stroke();
  }
  if (pose.state[slot] & PlayerState.charged) {
    context.strokeStyle = theme.warn;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(x - radius * 0.7, y + radius * 0.7);
    context.lineTo(x + radius * 0.7, y - radius * 0.7);
    context.stroke();
  }
}

/** A ring for kick, tackle and catch; dashed where the action failed. */
function drawActionMark(scene, slot, x, y, radius) {
  const {context, theme} = scene;
  const {kick, kickFailed, tackle, tackleFailed, catch: caught, catchFailed} = PlayerState;
  const frame = lastFrameWith(scene, slot, kick | kickFailed | tackle | tackleFailed | caught | catchFailed);
  if (frame < 0) return;
  const state = scene.record.column('state')[slot][frame];
  if (state & (caught | catchFailed)) context.strokeStyle = theme.catch;
  else context.strokeStyle = state & (tackle | tackleFailed) ? theme.tackle : theme.mark;
  context.lineWidth = Math.max(2, radius * 0.26);
  context.setLineDash(state & (kickFailed | tackleFailed | catchFailed) ? [3, 3] : []);
  traceDisc(context, x, y, radius + context.lineWidth / 2 + 1);
  context.stroke();
  context.setLineDash([]);
}

/** An arc that shrinks with the stamina. */
function drawStamina(scene, slot, x, y, radius) {
  const {context, pose, record, theme} = scene;
  const most = record.parameter('stamina_max', 8000);
  const share = clamp(record.column('stamina')[slot][pose.frame] / most, 0, 1);
  const width = Math.max(1.5, radius * 0.18);
  const start = -Math.PI / 2;
  context.lineWidth = width;
  context.strokeStyle = theme.shadow;
  traceDisc(context, x, y, radius - width / 2 - 0.5);
  context.stroke();
  context.strokeStyle = share < 0.3 ? theme.warn : theme.ball;
  context.beginPath();
  context.arc(x, y, radius - width / 2 - 0.5, start, start + 2 * Math.PI * share);
  context.stroke();
}

function drawLabel(scene, slot, x, y, radius) {
  const {context, pose, record, theme, layers} = scene;
  const goalie = (pose.state[slot] & PlayerState.goalie) !== 0;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  if (layers.numbers) {
    context.fillStyle = goalie ? theme.ballEdge : teamColors(theme, slot).ink;
    const unum = unumOfSlot(slot);
    context.font = `700 ${Math.round(radius * (unum < 10 ? 1.16 : 0.98))}px system-ui, sans-serif`;
    context.fillText(String(unum), x, y + radius * 0.06);
  }
  if (layers.types) {
    context.font = `600 ${Math.round(clamp(radius * 0.9, 9, 13))}px system-ui, sans-serif`;
    context.lineWidth = 3;
    context.strokeStyle = theme.halo;
    context.fillStyle = theme.text;
    const text = `t${record.column('type')[slot][pose.frame]}`;
    context.strokeText(text, x, y + radius * 2.1);
    context.fillText(text, x, y + radius * 2.1);
  }
}

function drawCard(scene, slot, x, y, radius) {
  const {context, pose, theme} = scene;
  const state = pose.state[slot];
  if (!(state & (PlayerState.yellowCard | PlayerState.redCard))) return;
  const height = Math.max(7, radius * 0.9);
  context.fillStyle = state & PlayerState.redCard ? '#e5383b' : '#ffd60a';
  context.strokeStyle = theme.ballEdge;
  context.lineWidth = 1;
  context.beginPath();
  context.rect(x + radius * 0.62, y - radius * 1.25, height * 0.68, height);
  context.fill();
  context.stroke();
}
