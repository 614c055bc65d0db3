// The team's decisions: the place for your own ideas. examples/TEAM.md of cls describes the team.
import * as actions from './actions.js';
import { GOAL, Situation, clamp, distance, point } from './situation.js';

/** A position with the ball at the center mark, and how much of the ball's way it follows. */
function home(x, y, followX, followY, minX, maxX, kickOffX, kickOffY) {
  return { x, y, followX, followY, minX, maxX, kickOff: { x: kickOffX, y: kickOffY } };
}

const FORMATION = [ // 4-3-3 by uniform number; 1 is the goalie
  home(-50, 0, 0, 0, -50, -50, -50, 0),
  home(-20, -7, 0.60, 0.25, -45, 14, -20, -7),
  home(-20, 7, 0.60, 0.25, -45, 14, -20, 7),
  home(-17, -20, 0.65, 0.25, -43, 28, -18, -20),
  home(-17, 20, 0.65, 0.25, -43, 28, -18, 20),
  home(-7, 0, 0.70, 0.45, -38, 32, -11, 0),
  home(1, -12, 0.75, 0.35, -34, 40, -8, -11),
  home(1, 12, 0.75, 0.35, -34, 40, -8, 11),
  home(15, -25, 0.75, 0.15, -24, 47, -1.5, -22),
  home(15, 25, 0.75, 0.15, -24, 47, -1.5, 22),
  home(18, 0, 0.75, 0.30, -16, 47, -0.8, 0),
];
const DRIBBLE_DIRECTIONS = [
  // 0, 37, -37, 53 and -53 degrees: exact sides of a right triangle
  { x: 1, y: 0 }, { x: 0.8, y: 0.6 }, { x: 0.8, y: -0.6 }, { x: 0.6, y: 0.8 }, { x: 0.6, y: -0.8 }];

/**
 * The actions of one player for one cycle; the first possible body action is executed. State and
 * actions are plain objects with the field names of proto/playmaker.proto.
 */
export function decide(state) {
  const now = new Situation(state);
  const mode = now.world.game_mode_type;
  if (now.world.is_penalty_kick_mode) return { actions: [actions.penalty()] };
  if (mode === 'BeforeKickOff' || mode === 'AfterGoal_') {
    const own = FORMATION[now.self.uniform_number - 1];
    return {
      ignore_preprocess: true,
      actions: [actions.beforeKickOff(own.kickOff), actions.watchBall(0)],
    };
  }
  if (mode !== 'PlayOn') return { actions: [actions.setPlay()] };
  if (now.self.is_goalie) return { actions: [actions.goalie()] };
  return { actions: now.self.is_kickable ? withBall(now) : withoutBall(now) };
}

/** Substitutions, and the opponents' player types for the players. */
export function decideAsCoach(_state) {
  return { actions: [actions.substitute(), actions.sayPlayerTypes()] };
}

/** A trainer may move ball and players: a place for exercises. This one watches. */
export function decideAsTrainer(_state) {
  return {};
}

function withBall(now) {
  const chosen = [actions.shoot()];
  const corner = shot(now);
  if (corner) chosen.push(actions.smartKick(corner, 3, 2, 2));
  const pressed = now.room(now.ball) < 3;
  const best = bestPass(now);
  if (best && (pressed || best.value > value(now, now.ball) + 2)) {
    chosen.push(actions.smartKick(best.target, best.speed, best.speed * 0.8, 3));
  }
  if (pressed && now.ball.x < -20) chosen.push(actions.clearBall());
  chosen.push(actions.dribble(dribbleTarget(now), 90, pressed ? 2 : 4));
  chosen.push(actions.holdBall(GOAL));
  chosen.push(corner ? actions.watchGoalie() : actions.watchBall(0));
  return chosen;
}

/** The place between the posts that opponents are farthest from. */
function shot(now) {
  if (distance(now.ball, GOAL) > 20) return undefined;
  let best;
  let widest = 0;
  for (const y of [-6, -3, 0, 3, 6]) {
    const target = { x: GOAL.x, y };
    const margin = now.lane(now.ball, target);
    if (margin > widest) {
      best = target;
      widest = margin;
    }
  }
  return best;
}

/** Of the ball at a place: forward, near the goal, away from opponents. */
function value(now, place) {
  return place.x - 0.2 * distance(place, GOAL) + 0.6 * Math.min(now.room(place), 8);
}

function bestPass(now) {
  let best;
  for (const mate of now.world.teammates) {
    if (mate.pos_count > 8 || mate.is_goalie || mate.is_tackling) continue;
    const place = point(mate.position);
    if (place.x > 0 && place.x > now.world.offside_line_x - 0.3 && place.x > now.ball.x) {
      continue; // offside
    }
    const ahead = place.x < 36 ? 3 : 0;
    const run = point(mate.velocity);
    const target = {
      x: clamp(place.x + 2 * run.x + ahead, -50, 50),
      y: clamp(place.y + 2 * run.y, -32, 32),
    };
    const length = distance(now.ball, target);
    if (length < 5 || length > 32 || (target.x < -25 && target.x < now.ball.x)) {
      continue; // too short, too long, or toward the own goal
    }
    if (now.lane(now.ball, target) < 0) continue;
    const found = { target, speed: Math.min(1.2 + 0.06 * length, 2.7), value: value(now, target) };
    if (!best || found.value > best.value) best = found;
  }
  return best;
}

/** 8 m ahead toward the goal, past the opponents in the way. */
function dribbleTarget(now) {
  const away = distance(now.me, GOAL);
  if (away < 0.1) return GOAL;
  const dx = (GOAL.x - now.me.x) / away;
  const dy = (GOAL.y - now.me.y) / away;
  let best = GOAL;
  let bestRoom = -1000;
  DRIBBLE_DIRECTIONS.forEach((turn, index) => {
    const target = {
      x: now.me.x + 8 * (dx * turn.x - dy * turn.y),
      y: now.me.y + 8 * (dx * turn.y + dy * turn.x),
    };
    if (target.y < -32 || target.y > 32 || target.x > 51) return;
    const room = Math.min(now.lane(now.me, target), 4) - 0.5 * index;
    if (room > bestRoom) {
      best = target;
      bestRoom = room;
    }
  });
  return best;
}

function withoutBall(now) {
  const first = now.mySteps <= now.ourSteps;
  if (first && now.mySteps <= now.theirSteps + 1) {
    return [actions.intercept(GOAL), actions.turnToBall(), actions.watchBall(0)];
  }
  if (now.theirSteps <= now.ourSteps || first) {
    return [actions.basicMove(), actions.watchBall(1)];
  }
  const place = homePosition(now);
  return [actions.goTo(place, 0.8, dashPower(now, place)), actions.turnToBall(),
    actions.watchBall(2)];
}

/** The formation moves with the ball; forwards wait on the offside line. */
function homePosition(now) {
  const own = FORMATION[now.self.uniform_number - 1];
  const line = now.world.offside_line_x - 0.5;
  let x = clamp(own.x + own.followX * now.ball.x, own.minX, own.maxX);
  if (now.self.uniform_number >= 9) x = Math.max(x, Math.min(line, now.ball.x + 22, 46));
  x = Math.min(x, Math.max(line, 0));
  return { x, y: clamp(own.y + own.followY * now.ball.y, -32, 32) };
}

/** Stamina must last for a half. */
function dashPower(now, target) {
  if (now.self.stamina < 3500) return 35;
  if (now.me.x > target.x + 3 || distance(now.ball, target) < 15) return 100;
  return 65;
}
