// Constructors of the actions that the team uses. docs/actions.md of cls describes all actions.

/** @param {import('./situation.js').Point} place */
function vector(place) {
  return { x: place.x + 0, y: place.y + 0 }; // + 0: never a negative zero
}

export function beforeKickOff(place) {
  return { bhv_before_kick_off: { point: vector(place) } };
}

export function smartKick(target, speed, minSpeed, kicks) {
  return {
    body_smart_kick: {
      target_point: vector(target), first_speed: speed, first_speed_threshold: minSpeed,
      max_steps: kicks,
    },
  };
}

export function dribble(target, dashPower, dashes) {
  return {
    body_dribble: {
      target_point: vector(target), distance_threshold: 1, dash_power: dashPower,
      dash_count: dashes, dodge: true,
    },
  };
}

export function goTo(target, within, dashPower) {
  return {
    body_go_to_point: {
      target_point: vector(target), distance_threshold: within, max_dash_power: dashPower,
    },
  };
}

export function intercept(face) {
  return { body_intercept: { face_point: vector(face) } };
}

export function holdBall(face) {
  return {
    body_hold_ball: {
      do_turn: true, turn_target_point: vector(face), kick_target_point: vector(face),
    },
  };
}

export const clearBall = () => ({ body_clear_ball: {} });

export const turnToBall = () => ({ body_turn_to_ball: { cycle: 1 } });

/** Beside the player in the page of the match; moves nothing. */
export function showText(text) {
  return { log: { add_text: { level: 'TEAM', message: text } } };
}

/** On the field in the page of the match; moves nothing. */
export function showLine(start, end, color) {
  return { log: { add_line: { level: 'TEAM', start: vector(start), end: vector(end), color } } };
}

/** With the ball: the best of the passes and dribbles that the proxy finds. */
export const planAttack = () => ({
  helios_offensive_planner: {
    direct_pass: true, lead_pass: true, through_pass: true, short_dribble: true,
    long_dribble: true, cross: true, simple_pass: true, simple_dribble: true,
  },
});

/** The neck: to the ball if its estimate is older than maxAge cycles, else around. */
export function watchBall(maxAge) {
  return { neck_turn_to_ball_or_scan: { count_threshold: maxAge } };
}

export const watchGoalie = () => ({ neck_turn_to_goalie_or_scan: {} });

export const shoot = () => ({ helios_shoot: {} });

/** Without the ball: tackle, block, mark, or move to the proxy's own formation. */
export const basicMove = () => ({ helios_basic_move: {} });

export const goalie = () => ({ helios_goalie: {} });

export const setPlay = () => ({ helios_set_play: {} });

export const penalty = () => ({ helios_penalty: {} });

export const substitute = () => ({ do_helios_substitute: {} });

export const sayPlayerTypes = () => ({ do_helios_say_player_types: {} });
