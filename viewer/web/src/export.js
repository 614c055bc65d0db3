// Images of the field and links to a moment.
import {element} from './dom.js';
import {scoreText} from './moment.js';
import {cycleLabel} from './record.js';

const kCaptionHeight = 34;

/** The browser saves a file. @param {Blob} blob @param {string} name */
export function saveFile(blob, name) {
  const address = URL.createObjectURL(blob);
  element('a', {href: address, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/** The field with a caption, as a PNG file that the browser saves.
 * @param {import('./viewer.js').Viewer} viewer @param {HTMLCanvasElement} field @param {number} ratio */
export async function saveImage(viewer, field, ratio) {
  const {record, frame, theme} = viewer;
  const [left, right] = record.teamsAt(frame);
  const canvas = document.createElement('canvas');
  const caption = Math.round(kCaptionHeight * ratio);
  canvas.width = field.width;
  canvas.height = field.height + caption;
  const context = canvas.getContext('2d');
  context.fillStyle = theme.timeline.back;
  context.fillRect(0, 0, canvas.width, caption);
  context.drawImage(field, 0, caption);
  context.fillStyle = theme.timeline.cursor;
  context.textBaseline = 'middle';
  context.font = `600 ${Math.round(15 * ratio)}px system-ui, sans-serif`;
  context.fillText(`${left.name} ${scoreText(record, frame).replace(' to ', ' : ')} ${right.name}`, 14 * ratio, caption / 2);
  context.textAlign = 'right';
  context.fillText(`cycle ${cycleLabel(record, frame)}`, canvas.width - 14 * ratio, caption / 2);
  const blob = await new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (!blob) return viewer.say('The browser could not make the image');
  saveFile(blob, `cycle-${cycleLabel(record, frame).replace('+', '-')}.png`);
  viewer.say('Image saved');
}

/** Copies the address of the moment, and puts it into the address bar.
 * @param {import('./viewer.js').Viewer} viewer */
export async function copyLink(viewer) {
  const address = window.location.href.replace(/#.*$/, '') + viewer.hash;
  writeHash(viewer);
  try {
    await navigator.clipboard.writeText(address);
    viewer.say('Link copied');
  } catch {
    viewer.say('The link is in the address bar');
  }
}

/** Makes the address that of the moment, without a new entry in the history.
 * The address of a live page that follows the match stays, so that a reload follows it, too.
 * @param {import('./viewer.js').Viewer} viewer */
export function writeHash(viewer) {
  if (viewer.clock.following) return;
  try {
    window.history.replaceState(null, '', viewer.hash);
  } catch {
    // Some browsers refuse this for files or when it happens often; the next pause tries again.
  }
}
