//! The team's decisions: the place for your own ideas. examples/TEAM.md of cls describes the team.
use crate::actions;
use crate::protos::{
    CoachActions, GameModeType, PlayerAction, PlayerActions, State, TrainerActions,
};
use crate::situation::{at, distance, point, Point, Situation, GOAL};

/// A position with the ball at the center mark, and how much of the ball's way it follows.
struct Home {
    base: Point,
    follow: Point,
    x: (f64, f64),
    kick_off: Point,
}

const fn home(base: (f64, f64), follow: (f64, f64), x: (f64, f64), kick_off: (f64, f64)) -> Home {
    Home {
        base: at(base.0, base.1),
        follow: at(follow.0, follow.1),
        x,
        kick_off: at(kick_off.0, kick_off.1),
    }
}

/// 4-3-3 by uniform number; 1 is the goalie.
const FORMATION: [Home; 11] = [
    home((-50.0, 0.0), (0.0, 0.0), (-50.0, -50.0), (-50.0, 0.0)),
    home((-20.0, -7.0), (0.60, 0.25), (-45.0, 14.0), (-20.0, -7.0)),
    home((-20.0, 7.0), (0.60, 0.25), (-45.0, 14.0), (-20.0, 7.0)),
    home((-17.0, -20.0), (0.65, 0.25), (-43.0, 28.0), (-18.0, -20.0)),
    home((-17.0, 20.0), (0.65, 0.25), (-43.0, 28.0), (-18.0, 20.0)),
    home((-7.0, 0.0), (0.70, 0.45), (-38.0, 32.0), (-11.0, 0.0)),
    home((1.0, -12.0), (0.75, 0.35), (-34.0, 40.0), (-8.0, -11.0)),
    home((1.0, 12.0), (0.75, 0.35), (-34.0, 40.0), (-8.0, 11.0)),
    home((15.0, -25.0), (0.75, 0.15), (-24.0, 47.0), (-1.5, -22.0)),
    home((15.0, 25.0), (0.75, 0.15), (-24.0, 47.0), (-1.5, 22.0)),
    home((18.0, 0.0), (0.75, 0.30), (-16.0, 47.0), (-0.8, 0.0)),
];
/// 0, 37, -37, 53 and -53 degrees: exact sides of a right triangle.
const DRIBBLE_DIRECTIONS: [Point; 5] =
    [at(1.0, 0.0), at(0.8, 0.6), at(0.8, -0.6), at(0.6, 0.8), at(0.6, -0.8)];

struct Pass {
    target: Point,
    speed: f64,
    value: f64,
}

/// The actions of one player for one cycle; the first possible body action is executed.
pub fn decide(state: &State) -> PlayerActions {
    let Some(now) = Situation::new(state) else { return PlayerActions::default() };
    if now.world.is_penalty_kick_mode {
        return reply(vec![actions::penalty()]);
    }
    match now.world.game_mode_type() {
        GameModeType::BeforeKickOff | GameModeType::AfterGoal => PlayerActions {
            ignore_preprocess: true,
            ..reply(vec![
                actions::before_kick_off(own_home(&now).kick_off),
                actions::watch_ball(0),
            ])
        },
        GameModeType::PlayOn if now.own.is_goalie => reply(vec![actions::goalie()]),
        GameModeType::PlayOn if now.own.is_kickable => reply(with_ball(&now)),
        GameModeType::PlayOn => reply(without_ball(&now)),
        _ => reply(vec![actions::set_play()]),
    }
}

fn reply(actions: Vec<PlayerAction>) -> PlayerActions {
    PlayerActions { actions, ..Default::default() }
}

/// Substitutions, and the opponents' player types for the players.
pub fn decide_as_coach(_state: &State) -> CoachActions {
    CoachActions { actions: vec![actions::substitute(), actions::say_player_types()] }
}

/// A trainer may move ball and players: a place for exercises. This one watches.
pub fn decide_as_trainer(_state: &State) -> TrainerActions {
    TrainerActions::default()
}

fn own_home(now: &Situation) -> &'static Home {
    &FORMATION[(now.own.uniform_number.clamp(1, 11) - 1) as usize]
}

fn with_ball(now: &Situation) -> Vec<PlayerAction> {
    let mut chosen = vec![actions::shoot()];
    let corner = shot(now);
    if let Some(corner) = corner {
        chosen.push(actions::smart_kick(corner, 3.0, 2.0, 2));
    }
    let pressed = now.room(now.ball) < 3.0;
    if let Some(best) = best_pass(now) {
        if pressed || best.value > value(now, now.ball) + 2.0 {
            chosen.push(actions::smart_kick(best.target, best.speed, best.speed * 0.8, 3));
        }
    }
    if pressed && now.ball.x < -20.0 {
        chosen.push(actions::clear_ball());
    }
    chosen.push(actions::dribble(dribble_target(now), 90.0, if pressed { 2 } else { 4 }));
    chosen.push(actions::hold_ball(GOAL));
    chosen.push(match corner {
        Some(_) => actions::watch_goalie(),
        None => actions::watch_ball(0),
    });
    chosen
}

/// The place between the posts that opponents are farthest from.
fn shot(now: &Situation) -> Option<Point> {
    if distance(now.ball, GOAL) > 20.0 {
        return None;
    }
    let mut best = None;
    let mut widest = 0.0;
    for y in [-6.0, -3.0, 0.0, 3.0, 6.0] {
        let target = at(GOAL.x, y);
        let margin = now.lane(now.ball, target);
        if margin > widest {
            best = Some(target);
            widest = margin;
        }
    }
    best
}

/// Of the ball at a place: forward, near the goal, away from opponents.
fn value(now: &Situation, place: Point) -> f64 {
    place.x - 0.2 * distance(place, GOAL) + 0.6 * now.room(place).min(8.0)
}

fn best_pass(now: &Situation) -> Option<Pass> {
    let mut best: Option<Pass> = None;
    for mate in &now.world.teammates {
        if mate.pos_count > 8 || mate.is_goalie || mate.is_tackling {
            continue;
        }
        let place = point(&mate.position);
        let line = f64::from(now.world.offside_line_x) - 0.3;
        if place.x > 0.0 && place.x > line && place.x > now.ball.x {
            continue; // offside
        }
        let ahead = if place.x < 36.0 { 3.0 } else { 0.0 };
        let run = point(&mate.velocity);
        let target = at(
            (place.x + 2.0 * run.x + ahead).clamp(-50.0, 50.0),
            (place.y + 2.0 * run.y).clamp(-32.0, 32.0),
        );
        let length = distance(now.ball, target);
        if !(5.0..=32.0).contains(&length) || (target.x < -25.0 && target.x < now.ball.x) {
            continue; // too short, too long, or toward the own goal
        }
        if now.lane(now.ball, target) < 0.0 {
            continue;
        }
        let value = value(now, target);
        if best.as_ref().is_none_or(|best| value > best.value) {
            best = Some(Pass { target, speed: (1.2 + 0.06 * length).min(2.7), value });
        }
    }
    best
}

/// 8 m ahead toward the goal, past the opponents in the way.
fn dribble_target(now: &Situation) -> Point {
    let away = distance(now.me, GOAL);
    if away < 0.1 {
        return GOAL;
    }
    let (dx, dy) = ((GOAL.x - now.me.x) / away, (GOAL.y - now.me.y) / away);
    let mut best = GOAL;
    let mut best_room = -1000.0;
    for (index, turn) in DRIBBLE_DIRECTIONS.iter().enumerate() {
        let target = at(
            now.me.x + 8.0 * (dx * turn.x - dy * turn.y),
            now.me.y + 8.0 * (dx * turn.y + dy * turn.x),
        );
        if target.y < -32.0 || target.y > 32.0 || target.x > 51.0 {
            continue;
        }
        let room = now.lane(now.me, target).min(4.0) - 0.5 * index as f64;
        if room > best_room {
            best = target;
            best_room = room;
        }
    }
    best
}

fn without_ball(now: &Situation) -> Vec<PlayerAction> {
    let first = now.my_steps <= now.our_steps;
    if first && now.my_steps <= now.their_steps + 1 {
        return vec![actions::intercept(GOAL), actions::turn_to_ball(), actions::watch_ball(0)];
    }
    if now.their_steps <= now.our_steps || first {
        return vec![actions::basic_move(), actions::watch_ball(1)];
    }
    let place = home_position(now);
    vec![
        actions::go_to(place, 0.8, dash_power(now, place)),
        actions::turn_to_ball(),
        actions::watch_ball(2),
    ]
}

/// The formation moves with the ball; forwards wait on the offside line.
fn home_position(now: &Situation) -> Point {
    let own = own_home(now);
    let line = f64::from(now.world.offside_line_x) - 0.5;
    let mut x = (own.base.x + own.follow.x * now.ball.x).clamp(own.x.0, own.x.1);
    if now.own.uniform_number >= 9 {
        x = x.max(line.min(now.ball.x + 22.0).min(46.0));
    }
    x = x.min(line.max(0.0));
    at(x, (own.base.y + own.follow.y * now.ball.y).clamp(-32.0, 32.0))
}

/// Stamina must last for a half.
fn dash_power(now: &Situation, target: Point) -> f64 {
    if now.own.stamina < 3500.0 {
        35.0
    } else if now.me.x > target.x + 3.0 || distance(now.ball, target) < 15.0 {
        100.0
    } else {
        65.0
    }
}
