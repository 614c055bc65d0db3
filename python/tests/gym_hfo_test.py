"""Half field offense: HFO's rules and its old interface."""
import os
import unittest

import gym_support  # noqa: F401  # first: may hide gymnasium
import numpy as np
from gym_support import FULL

import cls_gym
from cls_gym import hfo

STATUSES = ["IN_GAME", "GOAL", "CAPTURED_BY_DEFENSE", "OUT_OF_BOUNDS", "OUT_OF_TIME"]


def play(task, decide, episodes, seed=1, **config):
    """The statuses with which episodes end: the first one of each of so many worlds."""
    with cls_gym.VectorEnv(task, episodes, **config) as envs:
        seen, infos = envs.reset(seed=seed)
        status, step = np.zeros(episodes, np.int64), 0
        cycles = np.zeros(episodes, np.int64)
        while not status.all():
            seen, _, _, _, infos = envs.step(decide(envs, step, seen))
            cycles = np.where(status == 0, infos["cycles"], cycles)
            status = np.where(status == 0, infos["status"], status)
            step += 1
        return status, cycles


class Rules(unittest.TestCase):
    def test_statuses_have_the_numbers_of_hfo(self):
        with cls_gym.Env("cls/HFO-1v0-v0") as env:
            self.assertEqual(list(env.spec_of_task.statuses[:5]), STATUSES)

    def test_starts_are_those_of_hfo(self):
        with cls_gym.VectorEnv("cls/HFO-3v3-v0", 2000 if FULL else 300) as envs:
            envs.reset(seed=5)
            worlds = [envs._worlds.pool.view(i) for i in range(envs.num_envs)]
        x = np.array([world.ball_x for world in worlds]) / 52.5
        y = np.array([world.ball_y for world in worlds]) / 34.0
        # Kolmogorov-Smirnov at 0.1 %: 1.95 / sqrt(n).
        for values, low, high in ((x, 0.0, 0.2), (y, -0.8, 0.8)):
            self.assertTrue(low <= values.min() and values.max() <= high)
            ranks = np.sort((values - low) / (high - low))
            gap = np.abs(ranks - np.arange(len(ranks)) / len(ranks)).max()
            self.assertLess(gap, 1.95 / np.sqrt(len(ranks)))
        for world in worlds:
            players = [one for one in world.players if one.on_pitch]
            self.assertEqual(sum(one.side > 0 for one in players), 3)
            goalie, *others = [one for one in players if one.side < 0]
            self.assertEqual((goalie.unum, goalie.goalie, goalie.x, goalie.y), (1, 1, 52.5, 0.0))
            for one in others:
                self.assertTrue(42.0 <= one.x <= 52.5 and abs(one.y) <= 27.2 + 1e-9)
            for one in players[:3]:
                self.assertIn(one.unum, (11, 7, 8))
                self.assertTrue(-0.1 <= one.x <= 52.5 and abs(one.y) <= 27.2 + 1e-9)
                # HFO's squares of 10.5 m: from two before the ball to three behind it.
                self.assertTrue(-21.0 - 1e-9 <= one.x - world.ball_x <= 31.5 + 1e-9)

    def test_untouched_ball_ends_the_episode_in_time(self):
        def stand(envs, step, seen):
            return np.zeros(len(seen), np.int64)
        status, cycles = play("cls/HFO-1v0-v0", stand, 64, actions="low_discrete")
        far = cycles < 1000  # not the ones that start at the ball
        self.assertTrue((status == 4).all())
        self.assertGreater(far.sum(), 50)
        self.assertTrue(((cycles[far] >= 101) & (cycles[far] <= 102)).all(), cycles)

    def test_random_policy_does_not_score(self):
        for actions in ("low", "low_flat", "low_discrete", "skills"):
            def random(envs, step, seen):
                if step == 0:
                    envs.action_space.seed(3)
                return envs.action_space.sample()
            status, _ = play("cls/HFO-1v0-v0", random, 400, actions=actions)
            self.assertLess((status == 1).mean(), 0.05, actions)

    def test_shooter_scores_without_goalie(self):
        names = [action["name"] for action in self.actions()]
        shoot, intercept, dribble = (names.index(name)
                                     for name in ("SHOOT", "INTERCEPT", "DRIBBLE"))

        def decide(envs, step, seen):
            kickable = seen[:, 12] > 0.5
            near = seen[:, 15] > 0.7  # proximity of the goal
            which = np.where(kickable, np.where(near, shoot, dribble), intercept)
            return (which, *(np.zeros((len(seen), *space.shape[1:]), np.float32)
                             for space in envs.action_space.spaces[1:]))
        status, _ = play("cls/HFO-1v0-v0", decide, 100, features="hfo_low", actions="hfo")
        self.assertGreater((status == 1).mean(), 0.9)

    def actions(self):
        with cls_gym.Env("cls/HFO-1v0-v0", actions="hfo") as env:
            return env.spec_of_task.document["actions"]["items"]


class OldInterface(unittest.TestCase):
    def test_names_and_numbers(self):
        self.assertEqual((hfo.DASH, hfo.KICK_TO, hfo.SHOOT, hfo.NOOP, hfo.QUIT, hfo.REORIENT),
                         (0, 4, 9, 13, 14, 19))
        self.assertEqual((hfo.IN_GAME, hfo.SERVER_DOWN, hfo.LEFT, hfo.RIGHT), (0, 5, 1, -1))
        env = hfo.HFOEnvironment(fullstate=True, seed=1)
        self.assertEqual(env.statusToString(hfo.OUT_OF_TIME), "OutOfTime")
        self.assertEqual(env.actionToString(hfo.MOVE_TO), "MoveTo")
        self.assertRaises(RuntimeError, env.getState)
        self.assertRaises(TypeError, hfo.HFOEnvironment, port=6000)

    def test_high_level_agent_plays_trials(self):
        env = hfo.HFOEnvironment(fullstate=True, seed=1, trials=3)
        env.connectToServer(hfo.HIGH_LEVEL_FEATURE_SET, "bin/teams/base/config/formations-dt",
                            6000, "localhost", "base_left", False)
        ends = []
        while True:
            status = hfo.IN_GAME
            while status == hfo.IN_GAME:
                state = env.getState()
                env.act(hfo.SHOOT if state[5] == 1 else hfo.INTERCEPT)
                status = env.step()
            if status == hfo.SERVER_DOWN:
                break
            ends.append(status)
        self.assertEqual(len(ends), 3)
        self.assertEqual(env.getUnum(), 11)
        self.assertEqual((env.getNumTeammates(), env.getNumOpponents()), (0, 0))
        self.assertEqual(env.playerOnBall().side, hfo.LEFT)

    def test_without_fullstate_the_agent_has_its_world_model(self):
        states = []
        for fullstate in (True, False):
            env = hfo.HFOEnvironment(fullstate=fullstate, seed=3)
            env.connectToServer(hfo.LOW_LEVEL_FEATURE_SET)
            states.append(env.getState())
        self.assertEqual(states[0].shape, states[1].shape)
        self.assertFalse((states[0] == states[1]).all())

    def test_parameters_and_settings(self):
        os.environ["CLS_HFO"] = "--defense-npcs 1 --fullstate --seed 4"
        try:
            env = hfo.HFOEnvironment()
        finally:
            del os.environ["CLS_HFO"]
        env.connectToServer(hfo.LOW_LEVEL_FEATURE_SET)
        self.assertEqual(env.getStateSize(), 59 + 9)
        self.assertEqual(env.getNumOpponents(), 1)
        self.assertEqual([env.numParams(action) for action in range(20)],
                         [2, 1, 1, 2, 3, 2, 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0])
        self.assertRaises(AssertionError, env.act, hfo.DASH, 1.0)
        env.act(hfo.DASH, 100.0, 0.0)
        before = env.getState()
        self.assertEqual(env.step(), hfo.IN_GAME)
        self.assertFalse(np.array_equal(before, env.getState()))
        env.act(hfo.QUIT)
        self.assertEqual(env.step(), hfo.SERVER_DOWN)


if __name__ == "__main__":
    unittest.main()
