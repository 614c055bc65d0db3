// Where a player estimates ball and players: broken outlines, with a line to where they are.
import {kUnknownAge} from './decisions.js';
import {clamp} from './geometry.js';
import {ballRadius, discRadius, traceDisc} from './scene.js';
import {kPlayersPerTeam, kSlots, unumOfSlot} from './sides.js';
import {teamColors} from './theme.js';

/** Estimates fade to this with their age. */
const kOldest = 30;
const kFaintest = 0.35;

/** @param {import('./scene.js').Scene} scene */
export function drawEstimates(scene) {
  const {track, pose} = scene;
  const decision = track ? track.at(pose.frame) : -1;
  if (!track || decision < 0) return;
  const {context} = scene;
  context.save();
  for (let slot = 0; slot < kSlots; ++slot) {
    if (slot === track.slot || !pose.isEnabled(slot)) continue;
    drawPlayerEstimate(scene, track.playerRow(decision, slot));
  }
  for (const other of track.unnumbered(decision)) drawGhost(scene, other.x, other.y, sideSlot(other.side), '?', other.age);
  drawBallEstimate(scene, track.ballRow(decision));
  drawPlayerEstimate(scene, track.selfRow(decision));
  context.restore();
}

/** A slot with the colors of a side; -1: of no team. */
function sideSlot(side) {
  if (side === 0) return -1;
  return side > 0 ? 0 : kPlayersPerTeam;
}

function drawPlayerEstimate(scene, row) {
  if (!row) return;
  if (!row.estimated) return drawUnknown(scene, row);
  const [x, y] = row.estimated;
  drawError(scene, row);
  const apart = row.error * scene.camera.scale > discRadius(scene.camera);
  drawGhost(scene, x, y, row.slot, apart ? String(unumOfSlot(row.slot)) : '', row.age);
}

/** A line from the estimate to the full state. */
function drawError(scene, row) {
  const {context, camera, theme} = scene;
  context.globalAlpha = 0.9;
  context.strokeStyle = theme.warn;
  context.lineWidth = 1.5;
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(camera.screenX(row.estimated[0]), camera.screenY(row.estimated[1]));
  context.lineTo(camera.screenX(row.actual[0]), camera.screenY(row.actual[1]));
  context.stroke();
}

function drawGhost(scene, x, y, slot, text, age) {
  const {context, camera, theme} = scene;
  const radius = discRadius(camera);
  context.globalAlpha = age === kUnknownAge ? kFaintest : clamp(1 - age / kOldest, kFaintest, 1);
  context.strokeStyle = slot < 0 ? theme.text : teamColors(theme, slot).fill;
  context.lineWidth = 2;
  context.setLineDash([4, 3]);
  traceDisc(context, camera.screenX(x), camera.screenY(y), radius + 1);
  context.stroke();
  context.setLineDash([]);
  if (text === '') return;
  context.font = `700 ${Math.round(radius * 0.95)}px system-ui, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = theme.halo;
  context.strokeText(text, camera.screenX(x), camera.screenY(y));
  context.fillStyle = theme.text;
  context.fillText(text, camera.screenX(x), camera.screenY(y));
}

/** A player of whom nothing is known: a dotted ring where it is. */
function drawUnknown(scene, row) {
  const {context, camera, theme} = scene;
  context.globalAlpha = 0.8;
  context.strokeStyle = theme.text;
  context.lineWidth = 1.5;
  context.setLineDash([1.5, 4]);
  traceDisc(context, camera.screenX(row.actual[0]), camera.screenY(row.actual[1]), discRadius(camera) + 5);
  context.stroke();
}

function drawBallEstimate(scene, row) {
  if (!row) return;
  if (!row.estimated) return drawUnknown(scene, row);
  const {context, camera, theme} = scene;
  drawError(scene, row);
  context.globalAlpha = clamp(1 - row.age / kOldest, kFaintest, 1);
  context.strokeStyle = theme.ball;
  context.lineWidth = 2;
  context.setLineDash([3, 2]);
  traceDisc(context, camera.screenX(row.estimated[0]), camera.screenY(row.estimated[1]), ballRadius(camera) + 2.5);
  context.stroke();
}
