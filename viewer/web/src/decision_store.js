// The recorded decisions of both teams, loaded when they are first shown.
import {DecisionTrack} from './decision_track.js';
import {nearestToBall} from './moment.js';
import {sideOfSlot, unumOfSlot} from './sides.js';

export class DecisionStore {
  /** @param {import('./record.js').MatchRecord} record @param {string[]} sides that the page has decisions of
   * @param {(side: string) => Promise<import('./decisions.js').TeamDecisions>} read */
  constructor(record, sides, read) {
    this.record = record;
    this.sides = sides;
    this.read = read;
    /** Called when decisions have arrived. */
    this.onLoad = () => {};
    /** @type {Map<string, import('./decisions.js').TeamDecisions | Error | null>} null: on the way */
    this.teams = new Map();
    /** @type {Map<number, DecisionTrack | null>} */
    this.tracks = new Map();
  }

  /** @param {number} slot */
  has(slot) {
    return this.sides.includes(sideOfSlot(slot));
  }

  /** The nearest player to the ball of a team with decisions. @param {number} frame */
  nearest(frame) {
    return nearestToBall(this.record, frame, this.sides.length === 1 ? /** @type {'left' | 'right'} */ (this.sides[0]) : '');
  }

  /** The decisions of a player; null while they load or if there are none. @param {number} slot @returns {DecisionTrack | null} */
  track(slot) {
    if (!this.has(slot)) return null;
    const team = this.teams.get(sideOfSlot(slot));
    if (team === undefined) this.#load(sideOfSlot(slot));
    if (!team || team instanceof Error) return null;
    if (!this.tracks.has(slot)) {
      const player = team.player(unumOfSlot(slot));
      this.tracks.set(slot, player ? new DecisionTrack(this.record, slot, player) : null);
    }
    return this.tracks.get(slot) ?? null;
  }

  /** Why there is no track, in one sentence. @param {number} slot */
  problem(slot) {
    if (!this.has(slot)) return 'The page has no decisions of this team. cls match --record-world-models records them.';
    const team = this.teams.get(sideOfSlot(slot));
    if (team instanceof Error) return `${team.message}.`;
    return team ? 'The page has no decisions of this player.' : 'Reading the decisions.';
  }

  async #load(side) {
    this.teams.set(side, null);
    try {
      this.teams.set(side, await this.read(side));
    } catch (error) {
      this.teams.set(side, error instanceof Error ? error : new Error(String(error)));
    }
    this.onLoad();
  }
}
