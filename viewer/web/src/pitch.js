// The pitch: grass, lines, goals. Drawn again only when the view or the theme changes.

/** Measures of the pitch in meters; only the goal differs between servers. */
export const kPitch = Object.freeze({
  length: 105,
  width: 68,
  penaltyLength: 16.5,
  penaltyWidth: 40.32,
  goalAreaLength: 5.5,
  goalAreaWidth: 18.32,
  spot: 11,
  circle: 9.15,
  corner: 1,
  goalDepth: 2.44,
});

const kStripes = 14;
const kNetMesh = 0.61;

/** @param {CanvasRenderingContext2D} context scaled to CSS pixels @param {import('./camera.js').Camera} camera
 * @param {import('./theme.js').Theme} theme @param {number} goalWidth */
export function drawPitch(context, camera, theme, goalWidth) {
  drawGrass(context, camera, theme);
  context.strokeStyle = theme.line;
  context.lineWidth = Math.max(1, 0.12 * camera.scale);
  context.lineJoin = 'round';
  context.beginPath();
  traceLines(context, camera);
  context.stroke();
  drawSpots(context, camera, theme);
  for (const end of [-1, 1]) drawGoal(context, camera, theme, goalWidth, end);
}

function drawGrass(context, camera, theme) {
  context.fillStyle = theme.surround;
  context.fillRect(0, 0, camera.width, camera.height);
  const edge = 2;
  const left = -kPitch.length / 2;
  const top = camera.screenY(-kPitch.width / 2 - edge);
  const height = (kPitch.width + 2 * edge) * camera.scale;
  context.fillStyle = theme.grass;
  context.fillRect(camera.screenX(left - edge), top, (kPitch.length + 2 * edge) * camera.scale, height);
  context.fillStyle = theme.stripe;
  const width = kPitch.length / kStripes;
  for (let i = 0; i < kStripes; i += 2) context.fillRect(camera.screenX(left + i * width), top, width * camera.scale, height);
}

function traceLines(context, camera) {
  const {scale} = camera;
  const box = (x, y, width, height) => context.rect(camera.screenX(x), camera.screenY(y), width * scale, height * scale);
  const arc = (x, y, radius, from, to) => {
    context.moveTo(camera.screenX(x) + radius * scale * Math.cos(from), camera.screenY(y) + radius * scale * Math.sin(from));
    context.arc(camera.screenX(x), camera.screenY(y), radius * scale, from, to);
  };
  const halfLength = kPitch.length / 2;
  const halfWidth = kPitch.width / 2;
  box(-halfLength, -halfWidth, kPitch.length, kPitch.width);
  context.moveTo(camera.screenX(0), camera.screenY(-halfWidth));
  context.lineTo(camera.screenX(0), camera.screenY(halfWidth));
  arc(0, 0, kPitch.circle, 0, 2 * Math.PI);
  const bow = Math.acos((kPitch.penaltyLength - kPitch.spot) / kPitch.circle);
  for (const end of [-1, 1]) {
    const line = end * halfLength;
    box(line, -kPitch.penaltyWidth / 2, -end * kPitch.penaltyLength, kPitch.penaltyWidth);
    box(line, -kPitch.goalAreaWidth / 2, -end * kPitch.goalAreaLength, kPitch.goalAreaWidth);
    const facing = end < 0 ? 0 : Math.PI;
    arc(line - end * kPitch.spot, 0, kPitch.circle, facing - bow, facing + bow);
    const inward = end < 0 ? [0, Math.PI / 2, -Math.PI / 2, 0] : [Math.PI / 2, Math.PI, Math.PI, 1.5 * Math.PI];
    arc(line, -halfWidth, kPitch.corner, inward[0], inward[1]);
    arc(line, halfWidth, kPitch.corner, inward[2], inward[3]);
  }
}

function drawSpots(context, camera, theme) {
  context.fillStyle = theme.line;
  const radius = Math.max(1.5, 0.22 * camera.scale);
  for (const x of [0, kPitch.spot - kPitch.length / 2, kPitch.length / 2 - kPitch.spot]) {
    context.beginPath();
    context.arc(camera.screenX(x), camera.screenY(0), radius, 0, 2 * Math.PI);
    context.fill();
  }
}

function drawGoal(context, camera, theme, goalWidth, end) {
  const line = (end * kPitch.length) / 2;
  const back = line + end * kPitch.goalDepth;
  const half = goalWidth / 2;
  const left = camera.screenX(Math.min(line, back));
  const top = camera.screenY(-half);
  const width = kPitch.goalDepth * camera.scale;
  const height = goalWidth * camera.scale;
  context.strokeStyle = theme.net;
  context.lineWidth = 1;
  context.beginPath();
  for (let x = kNetMesh; x < kPitch.goalDepth; x += kNetMesh) {
    context.moveTo(left + x * camera.scale, top);
    context.lineTo(left + x * camera.scale, top + height);
  }
  for (let y = kNetMesh; y < goalWidth; y += kNetMesh) {
    context.moveTo(left, top + y * camera.scale);
    context.lineTo(left + width, top + y * camera.scale);
  }
  context.stroke();
  context.strokeStyle = theme.line;
  context.lineWidth = Math.max(1.5, 0.2 * camera.scale);
  context.beginPath();
  context.moveTo(camera.screenX(line), top);
  context.lineTo(camera.screenX(back), top);
  context.lineTo(camera.screenX(back), top + height);
  context.lineTo(camera.screenX(line), top + height);
  context.stroke();
}
