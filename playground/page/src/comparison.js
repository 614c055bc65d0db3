// Pairs of matches on all cores until the test of `cls compare` decides.
import { element, setText } from '../../../viewer/web/src/dom.js';
import { playMatch } from './matches.js';

const kMostPairs = 300;
const kVerdicts = { H1: 'better', H0: 'not better', open: 'undecided' };

/** The points of NEW, 2 for a win and 1 for a draw. @param {any} status @param {'left' | 'right'} side of NEW */
export function pointsOf({ left, right }, side) {
  const ahead = Math.sign(left.score - right.score) * (side === 'left' ? 1 : -1);
  return 1 + ahead;
}

/** The points of the pairs from the first one on that are complete. @param {Map<string, number>} points by "PAIR SIDE" */
export function completePairs(points) {
  const pairs = [];
  for (let pair = 1; points.has(`${pair} left`) && points.has(`${pair} right`); ++pair) {
    pairs.push(points.get(`${pair} left`) + points.get(`${pair} right`));
  }
  return pairs;
}

/**
 * Plays until the verdict.
 * @param {{sandbox: any, engine: any, workers: number, seed: number, cycles: number | null, candidate: any, base: any, pairs?: number}} task
 * @param {(verdict: any, played: number) => void} onVerdict after each match
 * @param {AbortSignal} signal
 */
export async function compare(task, onVerdict, signal) {
  const { sandbox, engine, workers, seed, cycles, candidate, base, pairs = kMostPairs } = task;
  const done = new AbortController(); // the visitor stops, or the verdict is there
  signal.addEventListener('abort', () => done.abort(signal.reason));
  const points = new Map();
  let next = 0;
  let verdict = engine.verdict([]);

  const playNext = async () => {
    while (verdict.decision === 'open' && next < 2 * pairs) {
      const pair = 1 + Math.floor(next / 2);
      const side = next % 2 === 0 ? 'left' : 'right';
      next += 1;
      const [left, right] = side === 'left' ? [candidate, base] : [base, candidate];
      const match = { left, right, seed: engine.pairSeed(seed, pair), cycles };
      const { status } = await playMatch(sandbox, match, () => {}, done.signal);
      if (status.failure !== '') throw new Error(`Pair ${pair}: ${status.failure}`);
      points.set(`${pair} ${side}`, pointsOf(status, side));
      verdict = engine.verdict(completePairs(points));
      onVerdict(verdict, points.size);
    }
  };

  try {
    await Promise.all(Array.from({ length: workers }, async () => {
      try {
        await playNext();
      } catch (error) {
        if (verdict.decision === 'open') throw error;
      }
      if (verdict.decision !== 'open') done.abort();
    }));
  } finally {
    done.abort();
  }
  return verdict;
}

const signed = (value) => `${value < 0 ? '−' : '+'}${Math.abs(value).toFixed(0)}`;

/** The verdict as a panel. */
export class VerdictPanel {
  constructor() {
    this.headline = element('h2', { class: 'verdict', role: 'status' });
    this.strength = element('p', {});
    this.counts = element('tr', {});
    this.forH1 = element('meter', { min: 0, max: 1, 'aria-label': 'Evidence that it is better' });
    this.forH0 = element('meter', { min: 0, max: 1, 'aria-label': 'Evidence that it is not better' });
    this.progress = element('p', { class: 'hint' });
    const head = ['0', '½', '1', '1½', '2'].map((text) => element('th', { scope: 'col' }, text));
    this.table = element('table', { class: 'pair-table' },
      element('caption', {}, 'Points of your team in a pair of matches, and how many pairs had them'),
      element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, this.counts));
    this.root = element('div', { class: 'verdict-panel', hidden: true }, this.headline, this.strength, this.table,
      element('dl', { class: 'evidence' }, element('dt', {}, 'Better'), element('dd', {}, this.forH1),
        element('dt', {}, 'Not better'), element('dd', {}, this.forH0)), this.progress);
  }

  /** @param {any} verdict of the engine @param {{played: number, running: boolean, candidate: string, base: string}} facts */
  show(verdict, { played, running, candidate, base }) {
    this.root.hidden = false;
    this.root.dataset.decision = verdict.decision;
    const open = verdict.decision === 'open';
    const result = open ? (running ? 'playing' : 'undecided') : `${candidate} is ${kVerdicts[verdict.decision]} than ${base}`;
    setText(this.headline, result.charAt(0).toUpperCase() + result.slice(1));
    const [low, high] = verdict.eloInterval;
    setText(this.strength, verdict.pairs === 0 ? 'No pair is complete yet.'
      : `${signed(verdict.elo)} Elo (95 %: ${signed(low)} to ${signed(high)}), ${(100 * verdict.score).toFixed(0)} % of the points`);
    this.counts.replaceChildren(...verdict.outcomes.map((count) => element('td', {}, count)));
    // Evidence multiplies: its logarithm grows by about the same with each pair.
    const share = (wealth) => Math.max(0, Math.min(1, Math.log(Math.max(wealth, 1e-9)) / Math.log(verdict.needed)));
    this.forH1.value = share(verdict.forH1);
    this.forH0.value = share(verdict.forH0);
    setText(this.progress, `${verdict.pairs} pairs, ${played} matches. The test of cls compare: it stops when the evidence for more than `
      + `${verdict.elo0} Elo, or for less than ${verdict.elo1} Elo, is ${verdict.needed.toFixed(0)} to 1.`);
  }
}
