//! The team's decisions by the behaviors of the proxy: which of them, and with which values.
use crate::actions;
use crate::protos::player_action::Action;
use crate::protos::*;
use crate::situation::{distance, Situation, GOAL};

const SHOT: f64 = 20.0; // meters to the goal

/// The actions of one player for one cycle; the first possible body action is executed.
pub fn decide(state: &State) -> PlayerActions {
    let Some(now) = Situation::new(state) else { return PlayerActions::default() };
    if now.world.is_penalty_kick_mode {
        return reply(vec![actions::penalty()]);
    }
    reply(match now.world.game_mode_type() {
        GameModeType::PlayOn if now.own.is_goalie => vec![actions::goalie()],
        GameModeType::PlayOn if now.own.is_kickable => {
            let defends = (2..=5).contains(&now.own.uniform_number);
            let mut chosen = vec![actions::shoot()];
            if distance(now.ball, GOAL) < SHOT {
                chosen.push(actions::smart_kick(GOAL, 3.0, 2.0, 2));
            }
            chosen.extend([plan(defends), actions::hold_ball(GOAL), actions::watch_ball(0)]);
            chosen
        }
        GameModeType::PlayOn => vec![actions::basic_move(), actions::watch_ball(1)],
        _ => vec![actions::set_play()],
    })
}

fn reply(actions: Vec<PlayerAction>) -> PlayerActions {
    PlayerActions { actions, ..Default::default() }
}

/// Searches chains of passes and dribbles. Defenders pass rather than dribble.
fn plan(defends: bool) -> PlayerAction {
    let planner = HeliosOffensivePlanner {
        direct_pass: true,
        lead_pass: true,
        through_pass: true,
        short_dribble: true,
        long_dribble: !defends,
        cross: !defends,
        simple_pass: true,
        simple_dribble: true,
        simple_shoot: true,
        evaluation: Some(evaluation(defends)),
        ..Default::default()
    };
    PlayerAction { action: Some(Action::HeliosOffensivePlanner(planner)) }
}

/// Factors by the first action of a chain, and costs of opponents at 0, 1, 2, ... meters.
fn evaluation(defends: bool) -> PlannerEvaluation {
    let factors = ActionTypeEffector {
        direct_pass: if defends { 1.2 } else { 1.0 },
        lead_pass: 1.0,
        through_pass: 1.1,
        short_dribble: if defends { 0.8 } else { 1.0 },
        long_dribble: 1.0,
        cross: 1.0,
        hold: 1.0,
    };
    let near = OpponentEffector {
        negetive_effect_by_distance: vec![-8.0, -5.0, -2.0],
        ..Default::default()
    };
    PlannerEvaluation {
        effectors: Some(PlannerEvaluationEffector {
            action_type_effector: Some(factors),
            opponent_effector: Some(near),
            ..Default::default()
        }),
        ..Default::default()
    }
}

pub fn decide_as_coach(_state: &State) -> CoachActions {
    CoachActions { actions: vec![actions::substitute(), actions::say_player_types()] }
}

pub fn decide_as_trainer(_state: &State) -> TrainerActions {
    TrainerActions::default()
}
