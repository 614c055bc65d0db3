// Constructors of the actions that the team uses. docs/actions.md of cls describes all actions.
import { CoachAction } from './wire/protos/CoachAction';
import { PlayerAction } from './wire/protos/PlayerAction';
import { RpcVector2D } from './wire/protos/RpcVector2D';
import { Point } from './situation';

function vector(place: Point): RpcVector2D {
  return { x: place.x + 0, y: place.y + 0 }; // + 0: never a negative zero
}

export function beforeKickOff(place: Point): PlayerAction {
  return { bhv_before_kick_off: { point: vector(place) } };
}

export function smartKick(target: Point, speed: number, minSpeed: number,
  kicks: number): PlayerAction {
  return {
    body_smart_kick: {
      target_point: vector(target), first_speed: speed, first_speed_threshold: minSpeed,
      max_steps: kicks,
    },
  };
}

export function dribble(target: Point, dashPower: number, dashes: number): PlayerAction {
  return {
    body_dribble: {
      target_point: vector(target), distance_threshold: 1, dash_power: dashPower,
      dash_count: dashes, dodge: true,
    },
  };
}

export function goTo(target: Point, within: number, dashPower: number): PlayerAction {
  return {
    body_go_to_point: {
      target_point: vector(target), distance_threshold: within, max_dash_power: dashPower,
    },
  };
}

export function intercept(face: Point): PlayerAction {
  return { body_intercept: { face_point: vector(face) } };
}

export function holdBall(face: Point): PlayerAction {
  return {
    body_hold_ball: {
      do_turn: true, turn_target_point: vector(face), kick_target_point: vector(face),
    },
  };
}

export const clearBall = (): PlayerAction => ({ body_clear_ball: {} });

export const turnToBall = (): PlayerAction => ({ body_turn_to_ball: { cycle: 1 } });

/** The neck: to the ball if its estimate is older than maxAge cycles, else around. */
export function watchBall(maxAge: number): PlayerAction {
  return { neck_turn_to_ball_or_scan: { count_threshold: maxAge } };
}

export const watchGoalie = (): PlayerAction => ({ neck_turn_to_goalie_or_scan: {} });

export const shoot = (): PlayerAction => ({ helios_shoot: {} });

/** Without the ball: tackle, block, mark, or move to the proxy's own formation. */
export const basicMove = (): PlayerAction => ({ helios_basic_move: {} });

export const goalie = (): PlayerAction => ({ helios_goalie: {} });

export const setPlay = (): PlayerAction => ({ helios_set_play: {} });

export const penalty = (): PlayerAction => ({ helios_penalty: {} });

export const substitute = (): CoachAction => ({ do_helios_substitute: {} });

export const sayPlayerTypes = (): CoachAction => ({ do_helios_say_player_types: {} });

/** In the page of the match, tab Drawings; moves nothing. */
export function showText(text: string): PlayerAction {
  return { log: { add_text: { level: 'TEAM', message: text } } };
}

/** On the field in the page of the match; moves nothing. */
export function showLine(start: Point, end: Point, color: string): PlayerAction {
  return { log: { add_line: { level: 'TEAM', start: vector(start), end: vector(end), color } } };
}

/** With the ball: the best of the passes and dribbles that the proxy finds. */
export const planAttack = (): PlayerAction => ({
  helios_offensive_planner: {
    direct_pass: true, lead_pass: true, through_pass: true, short_dribble: true,
    long_dribble: true, cross: true, simple_pass: true, simple_dribble: true,
  },
});
