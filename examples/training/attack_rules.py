"""Rules for two or more attackers, on the features "ego" and the actions "skills".

They score in about a third of 2v2 episodes: enough for learn_torch.py --imitate, which learns to
do the same and then better. Own rules fit in their place: act() is all that is called.
"""
import numpy as np

SHOT_RANGE = 18.0  # m
PRESSURE = 4.0     # m from the ball to the nearest opponent
LANE = 0.3         # radians from a pass to the nearest opponent
AHEAD = 2.0        # m that a receiver is nearer to the goal line


class AttackRules:
    """Shoot near the goal, pass forward under pressure, else dribble; without the ball support."""

    def __init__(self, envs):
        spec = envs.spec_of_task
        self.column = {feature.name: i for i, feature in enumerate(spec.features)}
        self.id = {name: i for i, name in enumerate(spec.actions.names)}
        self.opponents = [name[:-5] for name in self.column
                          if name.startswith("opponent") and name.endswith("_seen")]

    def act(self, seen, mask):
        """int64[..., A] of observations float32[..., A, F] and masks uint8[..., A, K]."""
        def value(name):
            return seen[..., self.column[name]]

        def place(name):  # m, x along the body
            return 60.0 * value(name + "_distance")[..., None] * np.stack(
                [value(name + "_cos"), value(name + "_sin")], -1)

        ball, mate = place("ball"), place("teammate1")
        lane = mate - ball
        rival, gap = self.nearest_rival(ball, lane, place)
        x, y = 52.5 * value("self_x"), 34.0 * value("self_y")
        ball_x, ball_y = 52.5 * value("ball_x"), 34.0 * value("ball_y")
        mate_x = x + mate[..., 0] * value("self_cos") - mate[..., 1] * value("self_sin")
        way = np.degrees(np.arctan2(0.5 * ball_y - y, 47.5 - x))
        dribble = self.id["dribble_0"] + np.round((way + 180.0) / 22.5).astype(int) % 16
        away = 60.0 * value("ball_distance")
        first = away <= 60.0 * value("teammate1_ball_distance")
        own = np.where((away < 1.8) & (rival > away + 1.0), dribble, self.id["take_ball"])
        free = (mask[..., self.id["pass_1"]] > 0) & (mate_x > x + AHEAD) & (gap > LANE)
        kick = np.where((rival < PRESSURE) & free, self.id["pass_1"], dribble)
        near = np.hypot(52.5 - ball_x, ball_y)
        shoot = (near < 0.8 * SHOT_RANGE) | (near < SHOT_RANGE) & (rival < PRESSURE) & ~free
        kick = np.where(shoot, self.id["shoot"], kick)
        without = np.where(first, own, self.id["support"])
        return np.where(value("self_kickable") > 0, kick, without)

    def nearest_rival(self, ball, lane, place):
        """m from the ball to the nearest opponent; radians of the lane to the nearest one in it."""
        rival, gap = np.full(ball.shape[:-1], np.inf), np.full(ball.shape[:-1], np.pi)
        for name in self.opponents:
            to = place(name) - ball
            far = np.hypot(to[..., 0], to[..., 1])
            cross = lane[..., 0] * to[..., 1] - lane[..., 1] * to[..., 0]
            angle = np.abs(np.arctan2(cross, (lane * to).sum(-1)))
            in_lane = far < np.hypot(lane[..., 0], lane[..., 1]) + 1.0
            rival, gap = np.minimum(rival, far), np.where(in_lane, np.minimum(gap, angle), gap)
        return rival, gap
