// Plays one match in a worker and reports to the page through a port that the teams' code cannot reach.
import { Engine } from '../../web/engine.js';
import { startMatch } from '../../web/teams.js';
import { captureConsole } from './console.js';
import { loadPythonTeam } from './python_team.js';
import { loadTeam } from './team_modules.js';

const kPieceMs = 80; // between two reports
const kAliveMs = 100; // between two signs of life while a team thinks

self.onmessage = ({ data: { engine, port } }) => {
  self.onmessage = null;
  port.onmessage = ({ data }) => {
    play(engine, port, data).catch((error) => port.postMessage({ kind: 'failed', message: `${error?.message ?? error}` }));
  };
  port.postMessage({ kind: 'waiting' });
};

/** What the teams' code is doing now, for signs of life and lines of the console. */
class Activity {
  constructor(port) {
    this.port = port;
    this.last = performance.now();
    this.side = '';
  }

  /** Called before each decision. */
  decides(side, state) {
    this.side = side;
    const now = performance.now();
    if (now - this.last < kAliveMs) return;
    this.last = now;
    const { cycle = 0, self } = state?.world_model ?? {}; // a coach is not on the field; Python has bytes
    this.port.postMessage({ kind: 'alive', side, unum: self?.uniform_number ?? 0, cycle });
  }

  loads(side) {
    this.side = side;
    this.last = performance.now();
    this.port.postMessage({ kind: 'alive', side, unum: 0, cycle: 0 });
  }
}

/** The team of a side: the name of a bundled one, or what decides. */
async function teamOf(side, { sides, runtime }, engine, activity) {
  const given = sides[side];
  if (typeof given === 'string') return given;
  activity.loads(side);
  if (given.modules) return watched(await loadTeam(given.modules), side, activity);
  activity.port.postMessage({ kind: 'loading' });
  const { answer } = await loadPythonTeam(given.python, runtime, engine.schema(), () => activity.loads(side));
  return {
    answer(rpc, state) {
      activity.decides(side, null);
      return answer(rpc, state);
    },
  };
}

async function play(module, port, task) {
  const { setup, logs } = task;
  const engine = await Engine.create(module);
  const activity = new Activity(port);
  const lines = captureConsole(() => activity.side);
  const teams = {};
  for (const side of ['left', 'right']) teams[side] = await teamOf(side, task, engine, activity);
  activity.side = '';
  const match = startMatch(engine, { ...setup, ...teams });
  const post = port.postMessage.bind(port);
  const bytes = { game: [], text: [] };
  for (let plays = true; plays;) {
    plays = playPiece(match);
    activity.last = performance.now();
    const game = match.takeGameLog();
    const text = match.takeTextLog();
    if (logs) {
      bytes.game.push(game);
      bytes.text.push(text);
    }
    const view = match.takeView();
    post({ kind: 'piece', status: match.status(), lines: lines.take(), view }, [view.buffer]);
    await new Promise((resolve) => setTimeout(resolve));
  }
  const result = { kind: 'done', status: match.status(), lines: lines.take(), game: bytes.game, text: bytes.text };
  if (setup.decisions) result.decisions = [match.takeDecisions(0), match.takeDecisions(1)];
  // Without a copy: logs and decisions of a whole match are what the page needs most memory for.
  post(result, [...bytes.game, ...bytes.text, ...(result.decisions ?? [])].map(({ buffer }) => buffer));
}

function playPiece(match) {
  const until = performance.now() + kPieceMs;
  do {
    if (!match.play(2)) return false;
  } while (performance.now() < until);
  return true;
}

/** The team, which says before each decision that it lives. */
function watched(team, side, activity) {
  const watch = (decide) => (state) => {
    activity.decides(side, state);
    const reply = decide(state);
    if (typeof reply?.then === 'function') throw new TypeError('decide is async: it must return actions, not a promise');
    return reply;
  };
  return {
    decide: watch(team.decide),
    decideAsCoach: typeof team.decideAsCoach === 'function' ? watch(team.decideAsCoach) : undefined,
  };
}
