// The decisions in the page: base64 of gzip of a stream for each team.
import {TeamDecisions} from './decisions.js';
import {inflatedBytes, takeData} from './embedded.js';

/** Sides whose decisions are in the page. @returns {string[]} */
export function sidesWithDecisions() {
  return ['left', 'right'].filter((side) => document.getElementById(`decisions-${side}`));
}

/** The decisions of a side; takes them from the page. @param {string} side @returns {Promise<TeamDecisions>} rejects with one sentence */
export async function readDecisions(side) {
  return new TeamDecisions(await inflatedBytes(takeData(`decisions-${side}`, 'the decisions')));
}
