//! What a player knows in one cycle: geometry and facts derived from a State.
//!
//! Only + - * / and sqrt, in a fixed order: every language computes the same bits.
use crate::protos::{Player, RpcVector2D, Self_, State, WorldModel};

pub const FAR: f64 = 1000.0; // meters or cycles: no player is there
const MAX_AGE: i32 = 20; // cycles; older estimates of players are ignored

#[derive(Clone, Copy, Debug)]
pub struct Point {
    pub x: f64,
    pub y: f64,
}

pub const fn at(x: f64, y: f64) -> Point {
    Point { x, y }
}

/// The opponent's: every team attacks toward +x.
pub const GOAL: Point = at(52.5, 0.0);

pub fn point(vector: &Option<RpcVector2D>) -> Point {
    vector.as_ref().map_or(at(0.0, 0.0), |v| at(f64::from(v.x), f64::from(v.y)))
}

pub fn length(dx: f64, dy: f64) -> f64 {
    (dx * dx + dy * dy).sqrt()
}

pub fn distance(a: Point, b: Point) -> f64 {
    length(a.x - b.x, a.y - b.y)
}

/// The State of one player, with the facts that most decisions begin with.
pub struct Situation<'a> {
    pub world: &'a WorldModel,
    pub own: &'a Self_,
    pub me: Point,
    pub ball: Point,
    pub opponents: Vec<Point>,
    /// Cycles to the ball: of this player, its fastest teammate, the fastest opponent.
    pub my_steps: i32,
    pub our_steps: i32,
    pub their_steps: i32,
}

impl<'a> Situation<'a> {
    /// None: the State has no world model of a player.
    pub fn new(state: &'a State) -> Option<Self> {
        let world = state.world_model.as_ref()?;
        let own = world.self_.as_ref()?;
        let table = world.intercept_table.as_ref()?;
        let recent = |player: &&Player| player.pos_count <= MAX_AGE;
        Some(Situation {
            world,
            own,
            me: point(&own.position),
            ball: point(&world.ball.as_ref()?.position),
            opponents: world.opponents.iter().filter(recent).map(|p| point(&p.position)).collect(),
            my_steps: if own.is_kickable { 0 } else { table.self_reach_steps },
            our_steps: steps(
                world.kickable_teammate_existance,
                table.first_teammate_id,
                table.first_teammate_reach_steps,
            ),
            their_steps: steps(
                world.kickable_opponent_existance,
                table.first_opponent_id,
                table.first_opponent_reach_steps,
            ),
        })
    }

    /// The distance of the nearest opponent.
    pub fn room(&self, place: Point) -> f64 {
        self.opponents.iter().fold(FAR, |nearest, &other| nearest.min(distance(other, place)))
    }

    /// How far opponents stay away from a ball that rolls from start to end; below 0: they reach
    /// it. An opponent reaches 0.8 m, and 0.2 m more for each meter that the ball rolls.
    pub fn lane(&self, start: Point, end: Point) -> f64 {
        let (dx, dy) = (end.x - start.x, end.y - start.y);
        let whole = length(dx, dy);
        if whole < 0.1 {
            return FAR;
        }
        let mut free = FAR;
        for opponent in &self.opponents {
            let along = ((opponent.x - start.x) * dx + (opponent.y - start.y) * dy) / whole;
            if along < 0.0 {
                continue;
            }
            let along = along.min(whole);
            let share = along / whole;
            let passed = at(start.x + dx * share, start.y + dy * share);
            free = free.min(distance(*opponent, passed) - 0.8 - 0.2 * along);
        }
        free
    }
}

/// Cycles to the ball; a player id of 0 means that no such player is known.
fn steps(kickable: bool, player_id: i32, cycles: i32) -> i32 {
    match (kickable, player_id) {
        (true, _) => 0,
        (false, 0) => FAR as i32,
        _ => cycles,
    }
}
