// Shapes and texts that Playmakers show on the pitch.
import {radians} from './geometry.js';
import {traceDisc} from './scene.js';
import {teamColors} from './theme.js';

/** Colors are those of style sheets; a Playmaker may send anything. */
const kColor = /^(#[0-9a-f]{3,8}|[a-z]{3,30})$/i;

/** @param {import('./scene.js').Scene} scene */
export function drawDrawings(scene) {
  const {context, drawings} = scene;
  if (!drawings || drawings.length === 0) return;
  context.save();
  context.lineWidth = 1.5;
  for (const {slot, drawing} of drawings) drawOne(scene, slot, drawing);
  context.restore();
}

function drawOne(scene, slot, drawing) {
  const {context, theme} = scene;
  const own = teamColors(theme, slot).fill;
  context.strokeStyle = own;
  if (kColor.test(drawing.color)) context.strokeStyle = drawing.color;
  context.fillStyle = context.strokeStyle;
  if (drawing.kind === 'message') return drawMessage(scene, drawing);
  if (drawing.kind === 'text') return;
  trace(scene, drawing);
  context.globalAlpha = 0.3;
  if (drawing.filled) context.fill();
  context.globalAlpha = 1;
  context.stroke();
}

/** The outline as the current path. */
function trace({context, camera}, {kind, numbers}) {
  const x = (i) => camera.screenX(numbers[i]);
  const y = (i) => camera.screenY(numbers[i]);
  const length = (i) => Math.max(0, numbers[i]) * camera.scale;
  context.beginPath();
  switch (kind) {
    case 'point': traceDisc(context, x(0), y(1), 3); break;
    case 'circle': traceDisc(context, x(0), y(1), length(2)); break;
    case 'arc': context.arc(x(0), y(1), length(2), radians(numbers[3]), radians(numbers[3] + numbers[4]), numbers[4] < 0); break;
    case 'rectangle': context.rect(x(0), y(1), x(2) - x(0), y(3) - y(1)); break;
    case 'sector': traceSector(context, x(0), y(1), length(2), length(3), radians(numbers[4]), radians(numbers[5])); break;
    default:
      context.moveTo(x(0), y(1));
      for (let i = 2; i < numbers.length; i += 2) context.lineTo(x(i), y(i + 1));
      if (kind === 'triangle') context.closePath();
  }
}

function traceSector(context, x, y, inner, outer, from, sweep) {
  context.arc(x, y, outer, from, from + sweep, sweep < 0);
  context.arc(x, y, inner, from + sweep, from, sweep > 0);
  context.closePath();
}

function drawMessage({context, camera, theme}, {numbers, text}) {
  const x = camera.screenX(numbers[0]);
  const y = camera.screenY(numbers[1]);
  context.font = '600 12px system-ui, sans-serif';
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = theme.halo;
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
  context.lineWidth = 1.5;
}
