// What a player knows in one cycle: geometry and facts derived from a State.
// Only + - * / and sqrt, in a fixed order: every language computes the same bits.

/** @typedef {{x: number, y: number}} Point */

export const FAR = 1000; // meters or cycles: no player is there
const MAX_AGE = 20; // cycles; older estimates of players are ignored

/** @type {Readonly<Point>} */
export const GOAL = { x: 52.5, y: 0 }; // every team attacks toward +x

export function point(vector) {
  return { x: vector?.x ?? 0, y: vector?.y ?? 0 };
}

export function distance(a, b) {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}

export function clamp(value, low, high) {
  return value < low ? low : value > high ? high : value;
}

/** The State of one player, with the facts that most decisions begin with. */
export class Situation {
  constructor(state) {
    this.world = state.world_model;
    this.self = this.world.self;
    this.me = point(this.self.position);
    this.ball = point(this.world.ball?.position);
    this.opponents = this.world.opponents
      .filter((player) => player.pos_count <= MAX_AGE)
      .map((player) => point(player.position));
    const table = this.world.intercept_table;
    // Cycles to the ball: of this player, its fastest teammate, the fastest opponent.
    this.mySteps = this.self.is_kickable ? 0 : table.self_reach_steps;
    this.ourSteps = steps(this.world.kickable_teammate_existance, table.first_teammate_id,
      table.first_teammate_reach_steps);
    this.theirSteps = steps(this.world.kickable_opponent_existance, table.first_opponent_id,
      table.first_opponent_reach_steps);
  }

  /** The distance of the nearest opponent. */
  room(place) {
    let nearest = FAR;
    for (const opponent of this.opponents) {
      nearest = Math.min(nearest, distance(opponent, place));
    }
    return nearest;
  }

  /**
   * How far opponents stay away from a ball that rolls from start to end; below 0: they reach it.
   * An opponent reaches 0.8 m, and 0.2 m more for each meter that the ball rolls.
   */
  lane(start, end) {
    const dx = end.x - start.x;
    const dy = end.y - start.y;
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length < 0.1) return FAR;
    let free = FAR;
    for (const opponent of this.opponents) {
      let along = ((opponent.x - start.x) * dx + (opponent.y - start.y) * dy) / length;
      if (along < 0) continue;
      along = Math.min(along, length);
      const share = along / length;
      const passed = { x: start.x + dx * share, y: start.y + dy * share };
      free = Math.min(free, distance(opponent, passed) - 0.8 - 0.2 * along);
    }
    return free;
  }
}

/** Cycles to the ball; a player id of 0 means that no such player is known. */
function steps(kickable, playerId, cycles) {
  if (kickable) return 0;
  return playerId !== 0 ? cycles : FAR;
}
