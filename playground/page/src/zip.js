// A ZIP archive of texts, stored as they are.
import { crc32 } from '../../../viewer/web/src/crc32.js';

const kLocalSize = 30;
const kCentralSize = 46;
const kEndSize = 22;
const kFirstDay = 0x21; // 1 January 1980
const kUnix = 3 << 8; // who made it: then there are permissions
const kFile = 0o100644;
const kProgram = 0o100755;

/** @param {Record<string, string>} files texts by path @param {(path: string) => boolean} isProgram @returns {Blob} */
export function zipOf(files, isProgram) {
  const parts = [];
  const directory = [];
  let at = 0;
  for (const [path, text] of Object.entries(files)) {
    const name = new TextEncoder().encode(path);
    const bytes = new TextEncoder().encode(text);
    const mode = isProgram(path) ? kProgram : kFile;
    const facts = { crc: crc32(bytes, 0) >>> 0, size: bytes.length, name, at, mode };
    parts.push(localHeader(facts), name, bytes);
    directory.push(centralHeader(facts), name);
    at += kLocalSize + name.length + bytes.length;
  }
  const size = directory.reduce((sum, part) => sum + part.length, 0);
  return new Blob([...parts, ...directory, endOf(Object.keys(files).length, size, at)], { type: 'application/zip' });
}

function localHeader(facts) {
  const view = new DataView(new ArrayBuffer(kLocalSize));
  view.setUint32(0, 0x04034b50, true);
  view.setUint16(4, 20, true);
  setFacts(view, 10, facts);
  return new Uint8Array(view.buffer);
}

function centralHeader(facts) {
  const view = new DataView(new ArrayBuffer(kCentralSize));
  view.setUint32(0, 0x02014b50, true);
  view.setUint16(4, kUnix | 20, true);
  view.setUint16(6, 20, true);
  setFacts(view, 12, facts);
  view.setUint32(38, facts.mode * 0x10000, true);
  view.setUint32(42, facts.at, true);
  return new Uint8Array(view.buffer);
}

function setFacts(view, offset, { crc, size, name }) {
  view.setUint16(offset + 2, kFirstDay, true);
  view.setUint32(offset + 4, crc, true);
  view.setUint32(offset + 8, size, true);
  view.setUint32(offset + 12, size, true);
  view.setUint16(offset + 16, name.length, true);
}

function endOf(count, size, at) {
  const view = new DataView(new ArrayBuffer(kEndSize));
  view.setUint32(0, 0x06054b50, true);
  view.setUint16(8, count, true);
  view.setUint16(10, count, true);
  view.setUint32(12, size, true);
  view.setUint32(16, at, true);
  return new Uint8Array(view.buffer);
}
