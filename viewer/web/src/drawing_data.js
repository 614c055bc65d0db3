// Debug logs of Playmakers: in the page, or from the server of a running match.
import {inflatedBytes, takeData} from './embedded.js';

const kSides = ['left', 'right'];
const kPollMs = 500;

/** Adds the debug logs in the page. @param {import('./drawing_store.js').DrawingStore} store @param {() => void} onChange
 * @param {string} prefix of their elements: "other-" for those of a second match */
export async function readDrawings(store, onChange, prefix) {
  for (const side of kSides) {
    const id = `${prefix}drawings-${side}`;
    if (!document.getElementById(id)) continue;
    store.add(side, new TextDecoder().decode(await inflatedBytes(takeData(id, 'the drawings'))));
    onChange();
  }
}

/** The debug log of a side, as far as it was read. */
class GrowingLog {
  constructor(path, side) {
    this.path = path;
    this.side = side;
    this.received = 0;
    this.rest = new Uint8Array(0);
  }

  /** Reads what is new. @param {import('./drawing_store.js').DrawingStore} store @returns {Promise<boolean>} true if something was */
  async read(store) {
    const response = await fetch(`${this.path}-${this.side}?from=${this.received}`, {cache: 'no-store'});
    if (!response.ok) return false;
    const fresh = new Uint8Array(await response.arrayBuffer());
    if (fresh.length === 0) return false;
    this.received += fresh.length;
    const bytes = new Uint8Array([...this.rest, ...fresh]);
    // A line may be cut.
    const end = bytes.lastIndexOf(10) + 1;
    store.add(this.side, new TextDecoder().decode(bytes.subarray(0, end)));
    this.rest = bytes.slice(end);
    return true;
  }
}

/** Follows the debug logs of a running match until it is over. @param {string} path without the side
 * @param {import('./drawing_store.js').DrawingStore} store @param {() => void} onChange */
export async function followDrawings(path, store, onChange) {
  const logs = kSides.map((side) => new GrowingLog(path, side));
  for (let last = false; ;) {
    const news = await Promise.all(logs.map((log) => log.read(store).catch(() => false)));
    if (news.includes(true)) onChange();
    else if (last) return;
    else last = !store.record.isLive;
    if (!news.includes(true)) await new Promise((resolve) => setTimeout(resolve, kPollMs));
  }
}
