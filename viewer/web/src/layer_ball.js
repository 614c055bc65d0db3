// The ball, and its shadow on the ground below it.
import {ballRadius, traceDisc} from './scene.js';

/** @param {import('./scene.js').Scene} scene */
export function drawBall(scene) {
  const {context, camera, pose, theme} = scene;
  const x = camera.screenX(pose.ballX);
  const ground = camera.screenY(pose.ballY);
  const y = ground - pose.ballZ * camera.scale;
  const radius = ballRadius(camera);
  context.fillStyle = theme.shadow;
  traceDisc(context, x + 1, ground + 1.5, radius + 1.5);
  context.fill();
  context.fillStyle = theme.ball;
  context.strokeStyle = theme.ballEdge;
  context.lineWidth = 1.5;
  traceDisc(context, x, y, radius);
  context.fill();
  context.stroke();
}
