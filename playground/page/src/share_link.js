// A match as the fragment of a link: teams, seed and code, compressed. Nothing of it is sent anywhere.
import { isOneSituation } from './book.js';
import { areTeamFiles } from './team_files.js';

const kVersion = 2; // 1: without settings and book
const kKey = 'm=';
const kLargestText = 1_000_000; // characters when inflated
const kNamePattern = /^[A-Za-z0-9_+-]{1,15}$/;
const kMockPattern = /^mock(:[a-z]+(:\d{1,9})?)?$/;
const kSettingPattern = /^(server|player)::\w+=[\w.+~/-]{1,100}$/; // nothing that a shell would read in a project's README
const kMostSettings = 100;

/**
 * @typedef {{name: string, files: Record<string, string>}} Team a team with code of its own
 *
 * A match: `cycles` is its end in game time, or null for two halves; `set` has settings such as server::half_time=100. With
 * `book`, the text of a book with one situation, this situation is played for `cycles`.
 * @typedef {{left: string | Team, right: string | Team, seed: number, cycles: number | null, set: string[], book: string | null}}
 *   SharedMatch
 */

/** True if a fragment says that it has a match. @param {string} hash */
export function hasMatch(hash) {
  return hash.replace(/^#/, '').startsWith(kKey);
}

/** @param {SharedMatch} match @returns {Promise<string>} the fragment with its # */
export async function fragmentOf({ left, right, seed, cycles, set, book }) {
  // Pages of the first version play what they know.
  const more = { ...(set.length > 0 && { set }), ...(book !== null && { book }) };
  const v = Object.keys(more).length > 0 ? kVersion : 1;
  const text = JSON.stringify({ v, left, right, seed, cycles: cycles ?? undefined, ...more });
  const packed = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  const base64 = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''));
  return `#${kKey}${base64.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

/** @param {string} hash @returns {Promise<SharedMatch>} rejects with one sentence */
export async function matchOf(hash) {
  const text = await inflated(hash.replace(/^#/, '').slice(kKey.length));
  let match;
  try {
    match = JSON.parse(text);
  } catch {
    throw new Error('it was cut or changed on its way');
  }
  const problem = problemOf(match);
  if (problem) throw new Error(problem);
  const { left, right, seed, cycles = null, set = [], book = null } = match;
  return { left, right, seed, cycles, set, book };
}

/** True for a setting of the server or the players. @param {any} text */
export function isSetting(text) {
  return typeof text === 'string' && kSettingPattern.test(text);
}

function isSide(side) {
  if (typeof side === 'string') return kMockPattern.test(side);
  return typeof side?.name === 'string' && kNamePattern.test(side.name) && areTeamFiles(side.files);
}

function problemOf(match) {
  if (match?.v > kVersion) return 'a newer version of this page has made it';
  if (!(match?.v >= 1) || !isSide(match.left) || !isSide(match.right)) return 'it has no two teams';
  if (!Number.isSafeInteger(match.seed) || match.seed < 0) return 'its seed is not a whole number';
  if (match.cycles !== undefined && !(Number.isInteger(match.cycles) && match.cycles > 0 && match.cycles <= 6000)) return 'its length is not a number of cycles';
  if (match.set !== undefined && !(Array.isArray(match.set) && match.set.length <= kMostSettings && match.set.every(isSetting))) return 'its settings are not settings of a match';
  if (match.book !== undefined && !(isOneSituation(match.book) && match.cycles > 0)) return 'its situation is not one';
  return '';
}

async function inflated(text) {
  try {
    const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
    return new TextDecoder('utf-8', { fatal: true }).decode(await through(bytes, new DecompressionStream('deflate-raw')));
  } catch {
    throw new Error('it was cut or changed on its way');
  }
}

async function through(bytes, transform) {
  const pieces = [];
  let size = 0;
  const reader = new Blob([bytes]).stream().pipeThrough(transform).getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    pieces.push(value);
    size += value.length;
    if (size > kLargestText) throw new Error('too large');
  }
  return new Uint8Array(await new Blob(pieces).arrayBuffer());
}
