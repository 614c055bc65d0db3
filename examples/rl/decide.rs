//! The team's decisions: a policy chooses what to do with the ball, the proxy does the rest.
use std::sync::LazyLock;

use crate::actions;
use crate::protos::player_action::Action;
use crate::protos::*;
use crate::situation::{at, distance, Situation, GOAL};

struct Row {
    action: String,
    weights: Vec<f64>,
}

/// The weights of each action.
static POLICY: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let path = std::env::var("POLICY").unwrap_or_else(|_| "policy.txt".into());
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let lines = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    lines
        .map(|line| {
            let mut words = line.split_whitespace();
            let action = words.next().unwrap_or_default().to_string();
            let parse = |word: &str| word.parse().unwrap_or_else(|_| panic!("{path}: {word}"));
            Row { action, weights: words.map(parse).collect() }
        })
        .collect()
});

/// What the policy sees, each about 0 to 1: bias, goal, room, lane, own_half.
fn features(now: &Situation) -> [f64; 5] {
    let ahead = at(now.me.x + 8.0, now.me.y);
    [
        1.0,
        (1.0 - distance(now.ball, GOAL) / 50.0).max(0.0),
        now.room(now.ball).min(10.0) / 10.0,
        now.lane(now.me, ahead).clamp(0.0, 4.0) / 4.0,
        if now.ball.x < 0.0 { 1.0 } else { 0.0 },
    ]
}

fn action(name: &str) -> PlayerAction {
    match name {
        "shoot" => actions::smart_kick(GOAL, 3.0, 2.0, 2),
        "pass" => {
            let planner = HeliosOffensivePlanner {
                direct_pass: true,
                lead_pass: true,
                through_pass: true,
                max_depth: 1,
                ..Default::default()
            };
            PlayerAction { action: Some(Action::HeliosOffensivePlanner(planner)) }
        }
        "dribble" => actions::dribble(GOAL, 90.0, 4),
        "clear" => actions::clear_ball(),
        _ => actions::hold_ball(GOAL),
    }
}

/// All actions, the one with the highest score first: the first possible one is executed.
fn with_ball(now: &Situation) -> Vec<PlayerAction> {
    let seen = features(now);
    let score = |row: &Row| row.weights.iter().zip(seen).map(|(w, x)| w * x).sum::<f64>();
    let mut ranked: Vec<_> = POLICY.iter().map(|row| (score(row), &row.action)).collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut chosen: Vec<_> = ranked.iter().map(|one| action(one.1)).collect();
    chosen.push(actions::watch_ball(0));
    chosen
}

/// The actions of one player for one cycle.
pub fn decide(state: &State) -> PlayerActions {
    let Some(now) = Situation::new(state) else { return PlayerActions::default() };
    if now.world.is_penalty_kick_mode {
        return reply(vec![actions::penalty()]);
    }
    reply(match now.world.game_mode_type() {
        GameModeType::PlayOn if now.own.is_goalie => vec![actions::goalie()],
        GameModeType::PlayOn if now.own.is_kickable => with_ball(&now),
        GameModeType::PlayOn => vec![actions::basic_move(), actions::watch_ball(1)],
        _ => vec![actions::set_play()],
    })
}

fn reply(actions: Vec<PlayerAction>) -> PlayerActions {
    PlayerActions { actions, ..Default::default() }
}

pub fn decide_as_coach(_state: &State) -> CoachActions {
    CoachActions { actions: vec![actions::substitute(), actions::say_player_types()] }
}

pub fn decide_as_trainer(_state: &State) -> TrainerActions {
    TrainerActions::default()
}
