//! The team's decisions: the place for your own ideas.
use crate::actions;
use crate::protos::{CoachActions, GameModeType, PlayerActions, State, TrainerActions};
use crate::situation::{Situation, GOAL};

/// The actions of one player for one cycle; the first possible body action is executed.
pub fn decide(state: &State) -> PlayerActions {
    let Some(now) = Situation::new(state) else { return PlayerActions::default() };
    let actions = match now.world.game_mode_type() {
        GameModeType::PlayOn if now.own.is_goalie => vec![actions::goalie()],
        GameModeType::PlayOn if now.own.is_kickable => {
            vec![
                actions::show_line(now.ball, GOAL, "yellow"),
                actions::show_text("has the ball"),
                actions::smart_kick(GOAL, 3.0, 0.1, 3),
                actions::watch_ball(0),
            ]
        }
        GameModeType::PlayOn => vec![actions::basic_move()],
        _ => vec![actions::set_play()],
    };
    PlayerActions { actions, ..Default::default() }
}

pub fn decide_as_coach(_state: &State) -> CoachActions {
    CoachActions { actions: vec![actions::substitute()] }
}

pub fn decide_as_trainer(_state: &State) -> TrainerActions {
    TrainerActions::default()
}
