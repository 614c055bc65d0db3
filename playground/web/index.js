// Matches in Node and in browsers: `import { playMatch } from "cls-match"`.
import { Engine } from './engine.js';
import { startMatch } from './teams.js';

export { Engine } from './engine.js';
export { startMatch } from './teams.js';

const STEPS = 50; // between two looks at the signal and at other work of the program

let shared; // the engine of this thread

/** The engine from the file beside this module. Made once. */
export function loadEngine() {
  shared ??= readEngine(new URL('./cls.wasm', import.meta.url)).then((bytes) => Engine.create(bytes));
  return shared;
}

async function readEngine(url) {
  if (url.protocol === 'file:' && globalThis.process?.versions?.node) {
    const { readFile } = await import('node:fs/promises');
    return readFile(url);
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** Plays a match to its end. index.d.ts describes options and result. */
export async function playMatch({ signal, onProgress, ...setup }) {
  const match = startMatch(await loadEngine(), setup);
  try {
    return await finish(match, signal, onProgress);
  } finally {
    match.close();
  }
}

async function finish(match, signal, onProgress) {
  const pieces = { gameLog: [], textLog: [], view: [] };
  const warnings = [];
  let plays = true;
  let status;
  while (plays) {
    signal?.throwIfAborted();
    plays = match.play(STEPS);
    pieces.gameLog.push(match.takeGameLog());
    pieces.textLog.push(match.takeTextLog());
    pieces.view.push(match.takeView());
    status = match.status();
    warnings.push(...status.warnings);
    onProgress?.(status);
    await new Promise((resolve) => setTimeout(resolve));
  }
  const { cycle, left, right, failure } = status;
  return { cycle, left, right, failure, warnings, ...joined(pieces) };
}

function joined(pieces) {
  return Object.fromEntries(Object.entries(pieces).map(([name, all]) => [name, join(all)]));
}

function join(pieces) {
  const whole = new Uint8Array(pieces.reduce((size, piece) => size + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    whole.set(piece, at);
    at += piece.length;
  }
  return whole;
}
