// Types of cls-match.

/** A State of proto/playmaker.proto as a plain object: enums are their names, unset messages null. */
export type State = Record<string, any>;
/** A PlayerActions of proto/playmaker.proto: {actions: [{dash: {power: 100}}], ignore_preprocess: true}. */
export type PlayerActions = Record<string, any>;
/** A CoachActions of proto/playmaker.proto. */
export type CoachActions = Record<string, any>;

/** A team in JavaScript, such as the module src/decide.js of a project of `cls new javascript`. */
export interface Team {
  /** The actions of one player for one cycle. An exception is a decision missed. */
  decide(state: State): PlayerActions;
  /** The actions of the coach; without it the coach acts by default. */
  decideAsCoach?(state: State): CoachActions;
}

/** 'mock', 'mock:NAME' (a bundled team, such as 'mock:planner' and 'mock:simple'), or a team. */
export type Side = string | Team;

export interface MatchSetup {
  left: Side;
  right: Side;
  /** At most 15 letters, digits, '-', '+' and '_'; by default from the side. */
  leftName?: string;
  rightName?: string;
  /** 0 to 2^53 - 1, by default 0. Equal seeds and teams give equal bytes. */
  seed?: number;
  /** End of the match in game time; by default two halves. With a book the length of each situation. */
  cycles?: number;
  /**
   * The text of a book of situations (docs/formats/book.md), not compressed, that are played in place of a whole match.
   * It needs `situations`, their number, and `cycles`.
   */
  book?: string;
  situations?: number;
  /** Settings such as 'server::half_time=100' and 'player::pt_max=2'. */
  set?: string[];
  /** With the stream of the viewer (docs/formats/view.md). */
  view?: boolean;
  /** With the decisions of all players, for the decision debugger (docs/formats/decisions.md). */
  decisions?: boolean;
}

export interface TeamStatus {
  name: string;
  score: number;
}

export interface MatchStatus {
  cycle: number;
  /** The play mode, such as 'play_on'. */
  mode: string;
  over: boolean;
  left: TeamStatus;
  right: TeamStatus;
  /** Why a team could not play on; empty: none. */
  failure: string;
  /** Since the last status. */
  warnings: string[];
}

export interface MatchResult {
  cycle: number;
  left: TeamStatus;
  right: TeamStatus;
  failure: string;
  warnings: string[];
  /** match.rcg and match.rcl, with the bytes of `cls match`. */
  gameLog: Uint8Array;
  textLog: Uint8Array;
  /** Empty without `view`. */
  view: Uint8Array;
}

/** A match that the caller plays in pieces. */
export interface Match {
  /** Plays up to `steps` steps; false once the match is over. */
  play(steps: number): boolean;
  takeGameLog(): Uint8Array;
  takeTextLog(): Uint8Array;
  takeView(): Uint8Array;
  /** Of the left side (0) or the right one (1). */
  takeDecisions(side: 0 | 1): Uint8Array;
  status(): MatchStatus;
  /** Gives the memory of the match back; no call may follow. */
  close(): void;
}

/** An instance of the WebAssembly module. */
export class Engine {
  static create(source: BufferSource | WebAssembly.Module): Promise<Engine>;
}

/** The engine of this thread. */
export function loadEngine(): Promise<Engine>;

/** Starts a match; an Error says in one line what is wrong with the setup. */
export function startMatch(engine: Engine, setup: MatchSetup): Match;

/** Plays a match to its end. */
export function playMatch(
  options: MatchSetup & { signal?: AbortSignal; onProgress?: (status: MatchStatus) => void },
): Promise<MatchResult>;
