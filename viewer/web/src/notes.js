// Notes of a match: play modes, teams and scores, messages, unknown lines (chunk N).

/**
 * @typedef {{name: string, score: number, scored: number, missed: number}} Team
 * @typedef {{frame: number, time: number, stopped: number, kind: 'mode', mode: number}
 *   | {frame: number, time: number, stopped: number, kind: 'teams', teams: [Team, Team]}
 *   | {frame: number, time: number, stopped: number, kind: 'message', board: number, text: string}
 *   | {frame: number, time: number, stopped: number, kind: 'unknown', text: string}} Note
 */

const kUtf8 = new TextDecoder();

function readString(reader) {
  return kUtf8.decode(reader.take(reader.varint()));
}

function readTeam(reader) {
  return {name: readString(reader), score: reader.zigzag(), scored: reader.zigzag(), missed: reader.zigzag()};
}

/** @param {import('./varint.js').ByteReader} reader @returns {Note[]} */
export function readNotes(reader) {
  const notes = [];
  const count = reader.varint();
  for (let i = 0; i < count; ++i) {
    const at = {frame: reader.varint(), time: reader.zigzag(), stopped: reader.zigzag()};
    const kind = reader.byte();
    if (kind === 0) notes.push({...at, kind: 'mode', mode: reader.byte()});
    else if (kind === 1) notes.push({...at, kind: 'teams', teams: [readTeam(reader), readTeam(reader)]});
    else if (kind === 2) notes.push({...at, kind: 'message', board: reader.zigzag(), text: readString(reader)});
    else if (kind === 3) notes.push({...at, kind: 'unknown', text: readString(reader)});
    else throw new Error(`note of kind ${kind}: the page needs a newer viewer`);
  }
  return notes;
}
