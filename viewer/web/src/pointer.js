// Mouse, pen and fingers on the field: click selects, drag moves, wheel and pinch zoom.
import {discRadius} from './scene.js';
import {kSlots} from './sides.js';

const kClickPixels = 5;
const kMinTouchPixels = 18;

/** The player at a point of the canvas; -1 if there is none. @param {import('./viewer.js').Viewer} viewer
 * @param {import('./interpolate.js').Pose} pose @param {number} x @param {number} y */
export function slotAt(viewer, pose, x, y) {
  let nearest = -1;
  let shortest = Math.max(discRadius(viewer.camera) + 3, kMinTouchPixels);
  for (let slot = 0; slot < kSlots; ++slot) {
    if (!pose.isEnabled(slot)) continue;
    const distance = Math.hypot(viewer.camera.screenX(pose.x[slot]) - x, viewer.camera.screenY(pose.y[slot]) - y);
    if (distance < shortest) {
      shortest = distance;
      nearest = slot;
    }
  }
  return nearest;
}

/** @param {HTMLCanvasElement} canvas @param {import('./viewer.js').Viewer} viewer @param {import('./interpolate.js').Pose} pose */
export function listenToPointers(canvas, viewer, pose) {
  /** @type {Map<number, {x: number, y: number}>} */
  const down = new Map();
  let moved = 0;

  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, place(event));
    if (down.size === 1) moved = 0;
  });

  canvas.addEventListener('pointermove', (event) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    if (down.size === 2) pinch(viewer, down, event.pointerId, now);
    else if (down.size === 1) drag(viewer, before, now);
    moved += Math.hypot(now.x - before.x, now.y - before.y);
    down.set(event.pointerId, now);
  });

  canvas.addEventListener('pointerup', (event) => {
    const start = down.get(event.pointerId);
    down.delete(event.pointerId);
    if (start && down.size === 0 && moved < kClickPixels) viewer.select(slotAt(viewer, pose, start.x, start.y), event.shiftKey);
  });
  canvas.addEventListener('pointercancel', (event) => down.delete(event.pointerId));

  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const {x, y} = place(event);
    viewer.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0016)), x, y);
  }, {passive: false});

  canvas.addEventListener('dblclick', (event) => {
    const {x, y} = place(event);
    if (viewer.camera.zoom > 1.01) viewer.fit();
    else viewer.zoom(2.5, x, y);
  });
}

function drag(viewer, before, now) {
  if (viewer.camera.zoom <= 1) return;
  viewer.camera.panBy(now.x - before.x, now.y - before.y);
  viewer.changed('view');
}

/** The two fingers hold on to their points of the pitch. */
function pinch(viewer, down, id, now) {
  const [otherId] = [...down.keys()].filter((key) => key !== id);
  const other = down.get(otherId);
  const before = down.get(id);
  const spread = Math.hypot(before.x - other.x, before.y - other.y);
  if (spread < 1) return;
  const {camera} = viewer;
  camera.zoomBy(Math.hypot(now.x - other.x, now.y - other.y) / spread, (now.x + other.x) / 2, (now.y + other.y) / 2);
  camera.panBy((now.x - before.x) / 2, (now.y - before.y) / 2);
  viewer.changed('view');
}
