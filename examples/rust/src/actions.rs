//! Constructors of the actions that the team uses. docs/actions.md of cls describes all actions.
use crate::protos::coach_action::Action as Coach;
use crate::protos::player_action::Action;
use crate::protos::*;
use crate::situation::Point;

fn player(action: Action) -> PlayerAction {
    PlayerAction { action: Some(action) }
}

fn coach(action: Coach) -> CoachAction {
    CoachAction { action: Some(action) }
}

fn vector(place: Point) -> Option<RpcVector2D> {
    // + 0.0: never a negative zero
    Some(RpcVector2D { x: (place.x + 0.0) as f32, y: (place.y + 0.0) as f32, ..Default::default() })
}

pub fn before_kick_off(place: Point) -> PlayerAction {
    player(Action::BhvBeforeKickOff(BhvBeforeKickOff { point: vector(place) }))
}

pub fn smart_kick(target: Point, speed: f64, min_speed: f64, kicks: i32) -> PlayerAction {
    player(Action::BodySmartKick(BodySmartKick {
        target_point: vector(target),
        first_speed: speed as f32,
        first_speed_threshold: min_speed as f32,
        max_steps: kicks,
    }))
}

pub fn dribble(target: Point, dash_power: f64, dashes: i32) -> PlayerAction {
    player(Action::BodyDribble(BodyDribble {
        target_point: vector(target),
        distance_threshold: 1.0,
        dash_power: dash_power as f32,
        dash_count: dashes,
        dodge: true,
    }))
}

pub fn go_to(target: Point, within: f64, dash_power: f64) -> PlayerAction {
    player(Action::BodyGoToPoint(BodyGoToPoint {
        target_point: vector(target),
        distance_threshold: within as f32,
        max_dash_power: dash_power as f32,
    }))
}

pub fn intercept(face: Point) -> PlayerAction {
    player(Action::BodyIntercept(BodyIntercept {
        save_recovery: false,
        face_point: vector(face),
    }))
}

pub fn hold_ball(face: Point) -> PlayerAction {
    player(Action::BodyHoldBall(BodyHoldBall {
        do_turn: true,
        turn_target_point: vector(face),
        kick_target_point: vector(face),
    }))
}

pub fn clear_ball() -> PlayerAction {
    player(Action::BodyClearBall(BodyClearBall {}))
}

pub fn turn_to_ball() -> PlayerAction {
    player(Action::BodyTurnToBall(BodyTurnToBall { cycle: 1 }))
}

/// The neck: to the ball if its estimate is older than max_age cycles, else around.
pub fn watch_ball(max_age: i32) -> PlayerAction {
    player(Action::NeckTurnToBallOrScan(NeckTurnToBallOrScan { count_threshold: max_age }))
}

pub fn watch_goalie() -> PlayerAction {
    player(Action::NeckTurnToGoalieOrScan(NeckTurnToGoalieOrScan::default()))
}

pub fn shoot() -> PlayerAction {
    player(Action::HeliosShoot(HeliosShoot {}))
}

/// Without the ball: tackle, block, mark, or move to the proxy's own formation.
pub fn basic_move() -> PlayerAction {
    player(Action::HeliosBasicMove(HeliosBasicMove {}))
}

pub fn goalie() -> PlayerAction {
    player(Action::HeliosGoalie(HeliosGoalie {}))
}

pub fn set_play() -> PlayerAction {
    player(Action::HeliosSetPlay(HeliosSetPlay {}))
}

pub fn penalty() -> PlayerAction {
    player(Action::HeliosPenalty(HeliosPenalty {}))
}

pub fn substitute() -> CoachAction {
    coach(Coach::DoHeliosSubstitute(DoHeliosSubstitute {}))
}

pub fn say_player_types() -> CoachAction {
    coach(Coach::DoHeliosSayPlayerTypes(DoHeliosSayPlayerTypes {}))
}

#[allow(dead_code)] // not every template shows something
fn shown(log: log::Log) -> PlayerAction {
    player(Action::Log(Log { log: Some(log) }))
}

/// In the page of the match, tab Drawings; moves nothing.
#[allow(dead_code)]
pub fn show_text(text: &str) -> PlayerAction {
    let level = LoggerLevel::Team as i32;
    shown(log::Log::AddText(AddText { level, message: text.to_string() }))
}

/// On the field in the page of the match; moves nothing.
#[allow(dead_code)]
pub fn show_line(start: Point, end: Point, color: &str) -> PlayerAction {
    shown(log::Log::AddLine(AddLine {
        level: LoggerLevel::Team as i32,
        start: vector(start),
        end: vector(end),
        color: color.to_string(),
    }))
}

/// With the ball: the best of the passes and dribbles that the proxy finds.
#[allow(dead_code)]
pub fn plan_attack() -> PlayerAction {
    player(Action::HeliosOffensivePlanner(HeliosOffensivePlanner {
        direct_pass: true,
        lead_pass: true,
        through_pass: true,
        short_dribble: true,
        long_dribble: true,
        cross: true,
        simple_pass: true,
        simple_dribble: true,
        ..Default::default()
    }))
}
