// Matches in the sandboxed frame: starts them, follows them, and ends those whose teams do not come back.
import { element } from '../../../viewer/web/src/dom.js';
import { CodeError, languageOf, mainFileOf, modulesOf, syntaxErrorLine } from './team_files.js';

const kSilentMs = 5000; // a decision takes this long at most
const kLoadMs = 60_000; // and the interpreter of Python, which is no fault of a team
const kMatchMs = 300_000; // and a match this long
const kCheckMs = 250;
const kEndMs = 2000; // until the frame says that it has ended a worker

/** Why a match has ended early, in one sentence. */
export class MatchProblem extends Error {
  /** @param {string} text @param {string} [side] whose fault it is */
  constructor(text, side = '') {
    super(text);
    this.side = side;
  }
}

/** The frame that the workers live in. */
export class Sandbox {
  #bytes;
  #next = 1;
  #running = new Map();
  #ended = new Map(); // what waits for the end of a worker

  /** @param {Uint8Array} bytes of the engine */
  constructor(bytes) {
    this.#bytes = bytes;
    window.addEventListener('message', (event) => {
      if (event.source === this.frame?.contentWindow) this.#hear(event.data);
    });
    this.#open();
  }

  #open() {
    this.frame?.remove();
    this.frame = element('iframe', { sandbox: 'allow-scripts', src: 'sandbox.html', title: 'Matches', hidden: true });
    this.ready = new Promise((resolve) => {
      this.onReady = resolve;
    });
    document.body.append(this.frame);
  }

  #hear({ kind, number, message }) {
    if (kind === 'waiting') this.#post({ kind: 'engine', bytes: this.#bytes });
    if (kind === 'ready') this.onReady();
    if (kind === 'died') this.#running.get(number)?.(message);
    if (kind === 'ended') this.#ended.get(number)?.();
  }

  #post(message, transfer = []) {
    this.frame.contentWindow?.postMessage(message, '*', transfer);
  }

  /** A worker of its own for a match. @param {(message: string) => void} onDeath */
  async start(onDeath) {
    await this.ready;
    const number = this.#next++;
    const { port1, port2 } = new MessageChannel();
    this.#running.set(number, onDeath);
    this.#post({ kind: 'start', number, port: null }, [port2]);
    return { number, port: port1 };
  }

  /** Ends a worker. A frame that does not answer, because its memory is full, is replaced. */
  end(number) {
    if (!this.#running.delete(number)) return;
    const timer = setTimeout(() => {
      this.#ended.delete(number);
      this.#restart();
    }, kEndMs);
    this.#ended.set(number, () => {
      clearTimeout(timer);
      this.#ended.delete(number);
    });
    this.#post({ kind: 'end', number });
  }

  #restart() {
    for (const died of [...this.#running.values()]) died('the frame of the matches was replaced');
    this.#running.clear();
    this.#open();
  }
}

/** The sides as the worker gets them: names of bundled teams, or modules. Throws a CodeError. */
function sideOf(side) {
  if (typeof side === 'string') return side;
  return languageOf(side.files) === 'python' ? { python: side.files } : { modules: modulesOf(side.files) };
}

const kRuntimeFiles = ['pyodide.mjs', 'pyodide.asm.mjs', 'pyodide.asm.wasm', 'python_stdlib.zip', 'pyodide-lock.json'];
let runtime = null; // of Python: loaded for the first team that needs it

/** The files of Pyodide by name, if a team is in Python. */
async function runtimeFor(sides) {
  if (!Object.values(sides).some((side) => side.python)) return null;
  runtime ??= Promise.all(kRuntimeFiles.map(async (name) => {
    const response = await fetch(name);
    if (!response.ok) throw new MatchProblem(`Python cannot be read: ${name}: ${response.status}.`);
    return [name, new Uint8Array(await response.arrayBuffer())];
  })).then(Object.fromEntries);
  return runtime.catch((error) => {
    runtime = null;
    throw error;
  });
}

/**
 * Plays a match.
 * @param {Sandbox} sandbox
 * @param {import('./share_link.js').SharedMatch & {view?: boolean, decisions?: boolean, logs?: boolean}} match
 * @param {(piece: {status: any, lines: any[], view: Uint8Array}) => void} onPiece
 * @param {AbortSignal} signal
 * @returns {Promise<any>} status, lines, game, text and decisions; rejects with a MatchProblem or a CodeError
 */
export async function playMatch(sandbox, match, onPiece, signal) {
  const { left, right, seed, cycles, set = [], book = null, view = false, decisions = false, logs = false } = match;
  const sides = { left: sideOf(left), right: sideOf(right) };
  const setup = { seed, view, set, ...(decisions && { decisions }), ...(cycles && { cycles }), ...(book && { book, situations: 1 }) };
  if (typeof left !== 'string') setup.leftName = left.name;
  if (typeof right !== 'string') setup.rightName = right.name;

  const python = await runtimeFor(sides);
  const fault = {};
  const { number, port } = await sandbox.start((message) => fault.died?.(message));
  const guard = new Guard(match);
  try {
    signal.throwIfAborted();
    return await new Promise((resolve, reject) => {
      fault.died = (message) => reject(new MatchProblem(deathText(message, guard), guard.side));
      signal.addEventListener('abort', () => reject(signal.reason));
      guard.watch(reject);
      port.onmessage = ({ data }) => {
        guard.hear(data);
        if (data.kind === 'waiting') port.postMessage({ setup, sides, logs, runtime: python });
        if (data.kind === 'piece') onPiece(data);
        if (data.kind === 'done') resolve(data);
        if (data.kind === 'failed') reject(problemOf(data.message, match, guard.side));
      };
    });
  } finally {
    guard.stop();
    port.close();
    sandbox.end(number);
  }
}

function deathText(message, guard) {
  const why = /memory/i.test(message) || message === '' ? 'the memory is full' : message;
  return `The match was ended: ${why}${guard.where()}.`;
}

/** A module that does not parse has no line in all browsers: the page finds it. */
function problemOf(message, match, side) {
  const place = /\(([\w.-]+\.(?:js|py))(?::(\d+))?\)$/.exec(message);
  if (!place) return new MatchProblem(message, side);
  const files = match[side]?.files ?? {};
  const text = message.slice(0, place.index).trim();
  if (place[2]) return new CodeError(place[1], Number(place[2]), text);
  for (const [file, code] of Object.entries(files)) {
    const line = syntaxErrorLine(code);
    if (line > 0) return new CodeError(file, line, text);
  }
  return new CodeError(mainFileOf(files), 1, text);
}

/** Ends a match whose worker is silent, or that takes too long. */
class Guard {
  constructor(match) {
    this.match = match;
    this.side = '';
    this.unum = 0;
    this.cycle = 0;
    this.began = performance.now();
    this.heard = this.began;
    this.patience = kSilentMs;
  }

  hear({ kind, side, unum, cycle, status }) {
    this.heard = performance.now();
    this.patience = kind === 'loading' ? kLoadMs : kSilentMs;
    if (kind === 'alive') Object.assign(this, { side, unum, cycle });
    if (kind === 'piece') this.cycle = status.cycle;
  }

  watch(reject) {
    let checked = performance.now();
    this.timer = setInterval(() => {
      const now = performance.now();
      const asleep = now - checked > 4 * kCheckMs; // this page, not the worker
      checked = now;
      if (asleep) this.heard = Math.max(this.heard, now - this.patience / 2);
      else if (now - this.heard > this.patience) reject(new MatchProblem(this.#silentText(), this.#suspect()));
      else if (now - this.began > kMatchMs) reject(new MatchProblem(`The match was ended: it has taken ${kMatchMs / 60_000} minutes.`));
    }, kCheckMs);
  }

  stop() {
    clearInterval(this.timer);
  }

  #suspect() {
    const coded = ['left', 'right'].filter((side) => typeof this.match[side] !== 'string');
    return coded.length === 1 ? coded[0] : this.side;
  }

  #silentText() {
    const name = this.match[this.#suspect()]?.name;
    const who = name ? `the code of ${name}` : 'the team';
    return `The match was ended: ${who} has not returned for ${kSilentMs / 1000} s${this.where()}. A loop without an end?`;
  }

  where() {
    return this.cycle > 0 || this.unum > 0 ? `, at cycle ${this.cycle}` : '';
  }
}
