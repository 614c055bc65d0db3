// The engine: matches in WebAssembly. Runs in Node and in pages and workers of browsers, needs no
// other module, and imports nothing that could reach files or the network.

const OK = 0;
const NOT_IMPLEMENTED = -52; // ENOSYS: for what the C library asks of an operating system
const UNKNOWN = 2; // status codes of gRPC
const UNIMPLEMENTED = 12;

/** The call of each kind of decision, by its number in the engine (proto/rpc.h). */
const DECISIONS = { 5: 'GetPlayerActions', 6: 'GetCoachActions', 7: 'GetTrainerActions' };

/**
 * An instance of the module. Its matches take turns on the caller's thread; another thread needs an
 * engine of its own.
 */
export class Engine {
  #exports;
  #deciders = []; // of the match that plays
  #encoder = new TextEncoder();
  #decoder = new TextDecoder();

  /** @param source the bytes of cls.wasm, or the module compiled from them */
  static async create(source) {
    const engine = new Engine();
    const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
    const instance = await WebAssembly.instantiate(module, engine.#imports(module));
    engine.#exports = instance.exports;
    instance.exports._initialize?.();
    return engine;
  }

  /**
   * Starts a match.
   * @param setup {left, right, leftName, rightName, seed, cycles, set, book, situations, view, decisions}
   * @param deciders for each side null or a function of (rpc name, bytes of a State) that returns the
   *   bytes of the reply, or undefined for a call that the team does not implement
   */
  start(setup, deciders = [null, null]) {
    this.#deciders = deciders;
    this.#write(this.#encoder.encode(JSON.stringify(setup)), this.#exports.input_buffer);
    const number = this.#exports.create_match();
    if (number === 0) throw new Error(this.#decoder.decode(this.#output(this.#exports.output_size())));
    return new Match(this, number, deciders);
  }

  /** The messages of the wire, for messages.js. */
  schema() {
    return JSON.parse(this.text('message_schema'));
  }

  /** The seed of a pair of matches, counted from 1, in `cls compare --seed SEED`. */
  pairSeed(seed, pair) {
    return this.#exports.pair_seed(seed, pair);
  }

  /**
   * The verdict of `cls compare` after pairs of matches, one on each side: the test stops at its decision.
   * @param points of each pair: 2 for a match that NEW won, 1 for a draw, 0
   * @returns {{pairs, decision, outcomes, score, elo, eloInterval, superiority, forH1, forH0, needed, elo0, elo1}}
   */
  verdict(points) {
    this.#write(this.#encoder.encode(JSON.stringify(points)), this.#exports.input_buffer);
    const judged = this.#exports.judge_pairs();
    const text = this.#decoder.decode(this.#output(this.#exports.output_size()));
    if (judged === 0) throw new Error(text);
    return JSON.parse(text);
  }

  /** For Match: calls an export whose result is an output. */
  bytes(name, ...numbers) {
    return this.#output(this.#exports[name](...numbers)).slice();
  }

  text(name, number) {
    return this.#decoder.decode(this.#output(this.#exports[name](number)));
  }

  play(number, steps, deciders) {
    this.#deciders = deciders;
    return this.#exports.play_match(number, steps) === 1;
  }

  destroy(number) {
    this.#exports.destroy_match(number);
  }

  #output(size) {
    return new Uint8Array(this.#exports.memory.buffer, this.#exports.output(), size);
  }

  #write(bytes, buffer) {
    const place = buffer(bytes.length);
    new Uint8Array(this.#exports.memory.buffer, place, bytes.length).set(bytes);
  }

  #decide(side, rpc, place, size) {
    const state = new Uint8Array(this.#exports.memory.buffer, place, size);
    let code = OK;
    let reply;
    try {
      reply = this.#deciders[side](DECISIONS[rpc], state);
      if (reply === undefined) {
        code = UNIMPLEMENTED;
        reply = this.#encoder.encode(`the team has no ${DECISIONS[rpc]}`);
      }
    } catch (error) {
      code = UNKNOWN;
      reply = this.#encoder.encode(lineOf(error));
    }
    this.#write(reply, this.#exports.reply_buffer);
    return code;
  }

  #imports(module) {
    const imports = {
      cls: { decide: (...call) => this.#decide(...call) },
      env: { emscripten_notify_memory_growth: () => {} },
      wasi_snapshot_preview1: {
        clock_time_get: (clock, precision, place) => {
          const now = BigInt(Math.round(performance.now() * 1e6));
          new DataView(this.#exports.memory.buffer).setBigUint64(place, now, true);
          return OK;
        },
        environ_sizes_get: (count, size) => {
          const view = new DataView(this.#exports.memory.buffer);
          view.setUint32(count, 0, true);
          view.setUint32(size, 0, true);
          return OK;
        },
        environ_get: () => OK,
        fd_write: (...call) => this.#print(...call),
        proc_exit: (code) => {
          throw new Error(`the engine has ended with code ${code}`);
        },
      },
    };
    // There are no files: other calls of the C library fail.
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      imports[from] ??= {};
      imports[from][name] ??= () => (from === 'env' ? NOT_IMPLEMENTED : -NOT_IMPLEMENTED);
    }
    return imports;
  }

  // Of assertions that fail.
  #print(file, vectors, count, written) {
    const view = new DataView(this.#exports.memory.buffer);
    let total = 0;
    let text = '';
    for (let i = 0; i < count; ++i) {
      const place = view.getUint32(vectors + 8 * i, true);
      const size = view.getUint32(vectors + 8 * i + 4, true);
      text += this.#decoder.decode(new Uint8Array(this.#exports.memory.buffer, place, size));
      total += size;
    }
    view.setUint32(written, total, true);
    if (text.trim() !== '') console.error(text.trimEnd());
    return OK;
  }
}

/** A match of an engine. */
export class Match {
  #engine;
  #number;
  #deciders;

  constructor(engine, number, deciders) {
    this.#engine = engine;
    this.#number = number;
    this.#deciders = deciders;
  }

  /** Plays up to `steps` steps; false once the match is over. */
  play(steps) {
    return this.#engine.play(this.#number, steps, this.#deciders);
  }

  /** The bytes since the last call: of the game log, the text log, the stream of the viewer. */
  takeGameLog() {
    return this.#engine.bytes('take_game_log', this.#number);
  }

  takeTextLog() {
    return this.#engine.bytes('take_text_log', this.#number);
  }

  takeView() {
    return this.#engine.bytes('take_view', this.#number);
  }

  /** The bytes since the last call of the decisions of the left side (0) or the right one (1). */
  takeDecisions(side) {
    return this.#engine.bytes('take_decisions', this.#number, side);
  }

  /** {cycle, mode, over, left: {name, score}, right, failure, warnings: those since the last call} */
  status() {
    return JSON.parse(this.#engine.text('match_status', this.#number));
  }

  /** Gives the memory of the match back; no call may follow. */
  close() {
    this.#engine.destroy(this.#number);
  }
}

/** One line: the error, and the place in the team's code. */
export function lineOf(error) {
  const place = /([\w.-]+\.m?js:\d+)/.exec(error?.stack ?? '');
  return place ? `${error} (${place[1]})` : `${error}`;
}
