"""cls_gym.match: whole matches of `cls match` as an environment."""
import os
import unittest

import numpy as np

import cls_gym
from cls_gym.match import PLAYERS, MatchEnv

CLS = os.environ.get("CLS_BINARY", "cls")
SHORT = ("--cycles", "80")


class Matches(unittest.TestCase):
    def make(self, *side, options=SHORT, **config):
        env = MatchEnv(*side, cls=CLS, options=options, **config)
        self.addCleanup(env.close)
        return env

    def play(self, env, seed):
        seen, info = env.reset(seed=seed)
        out = [(seen, info["action_mask"], info["cycle"])]
        over = False
        while not over:
            legal = [np.flatnonzero(mask)[-1] if mask.any() else 0 for mask in info["action_mask"]]
            seen, reward, over, truncated, info = env.step(np.array(legal))
            self.assertIn(seen, env.observation_space)
            self.assertIs(truncated, False)
            self.assertEqual(info["skipped"], 0)
            out.append((seen, info["action_mask"], info["cycle"], reward))
        return out

    def test_plays_to_the_end_and_repeats_by_seed(self):
        env = self.make("mock")
        first = self.play(env, 3)
        self.assertGreater(len(first), 40)
        again = self.play(env, 3)
        self.assertEqual(len(first), len(again))
        for one, other in zip(first, again):
            for a, b in zip(one, other):
                np.testing.assert_array_equal(a, b)
        with self.assertRaises(cls_gym.ResetNeeded):
            env.step(np.zeros(PLAYERS, np.int64))

    def test_numbers_are_those_of_the_task(self):
        env = self.make("mock:hold")
        with cls_gym.Env("cls/Match-v0", obs="world_model", features="ego", num_agents=PLAYERS,
                         actions="low_discrete") as native:
            self.assertEqual(native.observation_space, env.observation_space)
            self.assertEqual(native.action_space, env.action_space)
        seen, info = env.reset(seed=1)
        self.assertEqual(info["action_mask"].shape, (PLAYERS, 81))
        self.assertTrue((np.abs(seen).sum(axis=1) > 0).all())

    def test_a_reset_in_the_middle_starts_anew(self):
        env = self.make("mock")
        env.reset(seed=1)
        env.step(np.zeros(PLAYERS, np.int64))
        _, info = env.reset(seed=1)
        self.assertLess(info["cycle"], 30)

    def test_goals_are_rewards(self):
        env = self.make("mock", options=("--cycles", "2500"))
        env.reset(seed=2)
        total, over = 0.0, False
        while not over:  # no field player of the left team moves
            _, reward, over, _, info = env.step(np.zeros(PLAYERS, np.int64))
            total += reward
        self.assertEqual(total, float(info["score"][0] - info["score"][1]))
        self.assertGreater(info["score"].sum(), 0)

    def test_faults_are_named(self):
        env = self.make("team:no/such/folder")
        with self.assertRaisesRegex(cls_gym.EngineError, "no/such/folder"):
            env.reset(seed=1)
        with self.assertRaisesRegex(cls_gym.ConfigError, "ids alone"):
            self.make("mock", actions="low")
        env = self.make("mock")
        env.reset(seed=1)
        for action in (np.zeros(3, np.int64), np.full(PLAYERS, 81), np.full(PLAYERS, -1)):
            with self.assertRaisesRegex(cls_gym.ConfigError, "10 ids below 81"):
                env.step(action)
        env.close()
        env.close()
        self.assertRaises(cls_gym.ClosedEnvironmentError, env.reset)

    @unittest.skipIf("CLS_TEAM" not in os.environ, "CLS_TEAM names no folder of an external team")
    def test_external_team_over_udp(self):
        env = self.make(f"team:{os.environ['CLS_TEAM']}")
        _, info = env.reset(seed=1)
        over, cycles = False, []
        while not over:
            _, _, over, _, info = env.step(np.zeros(PLAYERS, np.int64))
            cycles.append(info["cycle"])
        self.assertGreater(len(cycles), 20)


if __name__ == "__main__":
    unittest.main()
