// Matches of `cls match` and of the engine, as files and as bytes.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Engine } from '../../../playground/web/engine.js';

export const makeEngine = () => Engine.create(readFileSync(process.env.CLS_ENGINE));

/** The logs that `cls match` writes. */
export function logsOfCls(left, right, options) {
  const folder = mkdtempSync(join(tmpdir(), 'cls-playground-'));
  try {
    const match = join(folder, 'match');
    execFileSync(process.env.CLS, ['match', left, right, ...options, '--dir', match],
      { stdio: ['ignore', 'ignore', 'pipe'] });
    return {
      game: readFileSync(join(match, 'match.rcg')),
      text: readFileSync(join(match, 'match.rcl')),
    };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Plays to the end and takes everything in pieces of `steps` steps. */
export function playOut(match, steps = 100) {
  const pieces = { game: [], text: [], view: [] };
  let plays = true;
  while (plays) {
    plays = match.play(steps);
    pieces.game.push(match.takeGameLog());
    pieces.text.push(match.takeTextLog());
    pieces.view.push(match.takeView());
  }
  return Object.fromEntries(Object.entries(pieces).map(([name, all]) => [name, Buffer.concat(all)]));
}
