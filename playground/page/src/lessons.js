// The steps of the tutorial in the page, as data. The `id` of a step is its heading in docs/tutorial.md, which links to it.
import changes from 'tutorial:changes';
import { placeIn } from './team_files.js';

/** The match of the tutorial, against the visitor's team. @type {Omit<import('./share_link.js').SharedMatch, 'left'>} */
export const kTutorialMatch = Object.freeze({ right: 'mock', seed: 4, cycles: 1500 });
const kKick = /^.*smart_?kick\(.*$/im;
const kBegin = /^(export function decide\(state\) \{|def decide\(.*:)$/m;
const kMistakes = {
  javascript: "  if (state.world_model.cycle === 5) throw new Error('no plan');",
  python: "    if state.world_model.cycle == 5: raise ValueError('no plan')",
};

/**
 * What the page tells a step.
 * @typedef {{kind: 'match', match: import('./share_link.js').SharedMatch, status: any, warnings: string[]}
 *   | {kind: 'verdict', decision: string, withKept: boolean} | {kind: 'download'}} LessonEvent
 * @typedef {{done: boolean, text: string}} LessonResult
 *
 * @typedef {object} Lesson
 * @property {string} id the heading in docs/tutorial.md
 * @property {string} title
 * @property {'write' | 'improve'} side what is below the text
 * @property {string[]} text paragraphs; `code` in backticks
 * @property {{label: string, keep?: boolean, edit: (code: string, language: import('./team_files.js').Language) => string}[]} [edits] of the file that decides, with `keep` after the
 *   version before it was kept; the same text: not possible
 * @property {{label: string, kind: 'match' | 'compare' | 'download', cycles?: number}} attempt the match of the tutorial, a
 *   comparison of matches of `cycles` with the kept version, or the download of the project
 * @property {(event: LessonEvent) => LessonResult | null} check null: the event is about something else
 */

/** True for the match of the tutorial, with code of the visitor's on the left side. */
function isTutorialMatch({ kind, match }) {
  return kind === 'match' && typeof match.left !== 'string'
    && Object.entries(kTutorialMatch).every(([key, value]) => match[key] === value) && match.set.length === 0;
}

const scoreOf = ({ left, right }) => `${left.score} : ${right.score}`;

/** @type {readonly Lesson[]} */
export const kLessons = Object.freeze([
  {
    id: 'the-first-match',
    title: 'The first match',
    side: 'write',
    text: [
      'Your team is the function `decide` below. It gets what one player knows in one cycle and returns actions; the first possible one is executed. It is called for each player and cycle.',
      'Play a quarter of a match against the bundled team. Your player with the ball has one rule, a kick toward the goal from anywhere: the ball goes forward, and to the opponent. The tab *Drawings* beside the field has the text that this player shows.',
    ],
    attempt: { label: 'Play the match', kind: 'match' },
    check(event) {
      if (!isTutorialMatch(event)) return null;
      const { status } = event;
      if (status.failure !== '') return { done: false, text: 'Your code could not play on: the line below says why.' };
      return { done: true, text: `Your team has played: ${scoreOf(status)}.` };
    },
  },
  {
    id: 'the-first-change-that-wins',
    title: 'The first change that wins',
    side: 'write',
    text: [
      'Shoot only if neither goalie nor defenders reach the ball, and else let the planner choose a pass or a dribble: in `decide`, replace the kick, `actions.smartKick(…)`, by `actions.shoot(), actions.planAttack()` (in Python `smart_kick` by `plan_attack`). The button does it, and keeps your version to compare with it later.',
      'Then play the same match again. The same seed and the same decisions give the same match, so what differs is your change.',
    ],
    edits: [{ label: 'Make the change', keep: true, edit: (code, language) => code.replace(kKick, () => changes[language].trimEnd()) }],
    attempt: { label: 'Play the match again', kind: 'match' },
    check(event) {
      if (!isTutorialMatch(event)) return null;
      const { left, right } = event.status;
      const score = scoreOf(event.status);
      if (left.score > right.score) return { done: true, text: `Your team wins the match, ${score}.` };
      return { done: false, text: `${score}: your team has not won this match yet.` };
    },
  },
  {
    id: 'is-it-better',
    title: 'Is it better?',
    side: 'improve',
    text: [
      'One match is luck. A comparison plays half matches of your team against the version that you kept, each seed from both sides, until one of them is better beyond doubt. It takes some minutes, and uses all cores.',
    ],
    attempt: { label: 'Compare', kind: 'compare', cycles: 3000 },
    check(event) {
      if (event.kind !== 'verdict' || !event.withKept) return null;
      if (event.decision === 'H1') return { done: true, text: 'Your team is better: not by luck.' };
      return { done: false, text: 'It is not better yet. Change your team, and compare again.' };
    },
  },
  {
    id: 'when-something-fails',
    title: 'When something fails',
    side: 'write',
    text: [
      'An exception costs the decision of one player, and the match continues. Add one to `decide` and play: the problem appears below the code, and leads to its line.',
      'Then take it back, and whenever a decision puzzles you: choose a player on the field, and the tab *Decision* shows what it knew, what your code asked for, and what came of it.',
    ],
    edits: [
      { label: 'Add a mistake', edit: (code, language) => (code.includes(kMistakes[language]) ? code : code.replace(kBegin, (line) => `${line}\n${kMistakes[language]}`)) },
      { label: 'Take it back', edit: (code, language) => code.replace(`${kMistakes[language]}\n`, '') },
    ],
    attempt: { label: 'Play the match', kind: 'match' },
    check(event) {
      if (!isTutorialMatch(event)) return null;
      const place = [...event.warnings, event.status.failure].map((text) => placeIn(text)).find(Boolean);
      if (place) return { done: true, text: `The mistake is found: ${place.file}, line ${place.line}.` };
      return { done: false, text: 'No decision has failed in this match.' };
    },
  },
  {
    id: 'a-project',
    title: 'A project of your own',
    side: 'write',
    text: [
      'Your team leaves the page as a project: the same files, with a Playmaker around them. With `cls` and Node.js on your computer it plays the same match to the bit, and meets teams in all languages: `cls match` plays, `cls test tests/` plays short situations, `cls dev` plays them after each change.',
    ],
    attempt: { label: 'Download the project', kind: 'download' },
    check: ({ kind }) => (kind === 'download' ? { done: true, text: 'Unpack the project; its README.md has the next steps.' } : null),
  },
]);
