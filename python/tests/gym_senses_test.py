"""Agents that choose where they look and what they say: spaces, masks, copies, refusals."""
import pickle
import unittest

from gym_support import differences  # first: may hide gymnasium
import numpy as np

import cls_gym
from cls_gym import policy
from cls_gym.spaces import HAVE_GYMNASIUM

PLAIN = {"task": "cls/HFO-2v1-v0", "obs": "world_model", "features": "ego",
         "actions": "low_discrete", "max_cycles": 40}
SENSES = dict(PLAIN, look=True, say=True)
COUNTS = (81, 13, 4, 5, 9)


class Spaces(unittest.TestCase):
    def test_the_specification_names_the_items(self):
        with cls_gym.Env(**SENSES) as env:
            senses = env.spec_of_task.actions.senses
            self.assertEqual([one.name for one in senses], ["neck", "view", "focus", "say"])
            self.assertEqual(senses[1].items, ("default", "narrow", "normal", "wide"))
            self.assertEqual(env.action_space.shape, (2, 5))
            np.testing.assert_array_equal(env.action_space.nvec, [COUNTS, COUNTS])
            names = [one.name for one in env.spec_of_task.features]
            self.assertEqual(names[-19:-17] + names[-2:],
                             ["own_neck_sin", "own_neck_cos", "heard_number", "heard_age"])
        with cls_gym.Env(**dict(PLAIN, look=True)) as env:
            self.assertEqual(env.action_space.shape, (2, 4))
        with cls_gym.Env(**PLAIN) as env:
            self.assertEqual(env.spec_of_task.actions.senses, ())
            self.assertEqual(env.action_space.shape, (2,))

    def test_masks_draw_legal_ids_and_any_item(self):
        with cls_gym.VectorEnv(num_envs=3, **SENSES) as envs:
            seen, infos = envs.reset(seed=1)
            self.assertEqual(infos["action_mask"].shape, (3, 2, 81))
            self.assertEqual(envs.action_masks()[0].shape, (2 * sum(COUNTS),))
            drawn = np.zeros(5, np.int64)
            for _ in range(60):
                played = envs.action_space.sample(infos["action_mask"])
                drawn = np.maximum(drawn, played.max(axis=(0, 1)))
                seen, _, _, _, infos = envs.step(played)
                self.assertEqual(int(infos["illegal"].sum()), 0)
            np.testing.assert_array_equal(drawn[1:], np.array(COUNTS[1:]) - 1)

    def test_actions_with_numbers_are_tuples(self):
        with cls_gym.Env(**dict(SENSES, actions="low_all")) as env:
            seen, info = env.reset(seed=1)
            action = env.action_space.sample(info["action_mask"])
            self.assertEqual((action[0].shape, action[1].shape), ((2, 5), (2, 2)))
            self.assertIn(env.step(action)[0], env.observation_space)


class Episodes(unittest.TestCase):
    def test_defaults_are_those_of_an_environment_without_senses(self):
        with cls_gym.VectorEnv(num_envs=2, **PLAIN) as plain, \
                cls_gym.VectorEnv(num_envs=2, **SENSES) as sensing:
            one, infos = plain.reset(seed=4)
            two, _ = sensing.reset(seed=4)
            for _ in range(60):
                self.assertEqual(differences(one, two[..., :one.shape[-1]]), [])
                played = plain.action_space.sample(infos["action_mask"])
                row = np.zeros((2, 2, 5), np.int64)
                row[..., 0] = played
                one, rewards, ended, _, infos = plain.step(played)
                two, others, ends, _, _ = sensing.step(row)
                np.testing.assert_array_equal(rewards, others)
                np.testing.assert_array_equal(ended, ends)

    def test_a_symbol_is_heard_by_the_teammate(self):
        with cls_gym.Env(**SENSES) as env:
            names = [one.name for one in env.spec_of_task.features]
            env.reset(seed=2)
            seen = env.step(np.array([[0, 0, 0, 0, 2], [0, 0, 0, 0, 0]]))[0]
            heard = seen[:, names.index("heard_B")]
            self.assertEqual(heard.tolist(), [-1.0, 1.0])

    def test_copies_play_the_same(self):
        with cls_gym.Env(**SENSES) as env:
            env.reset(seed=3)
            env.action_space.seed(1)
            for _ in range(20):
                env.step(env.action_space.sample())
            snapshot, copied = env.snapshot(), pickle.loads(pickle.dumps(env))
            for _ in range(5):
                played = env.action_space.sample()
                one, two = env.step(played), copied.step(played)
                self.assertEqual(differences(one[:4], two[:4]), [])
            again = pickle.loads(pickle.dumps(snapshot))
            self.assertEqual(differences(copied.restore(again), env.restore(snapshot)), [])

    @unittest.skipUnless(HAVE_GYMNASIUM, "no gymnasium")
    def test_agents_by_name(self):
        try:
            env = cls_gym.ParallelEnv(**SENSES)
        except ImportError:
            self.skipTest("no pettingzoo")
        seen, infos = env.reset(seed=1)
        while env.agents:
            played = {one: env.action_space(one).sample(infos[one]["action_mask"])
                      for one in env.agents}
            self.assertEqual({row.shape for row in played.values()}, {(5,)})
            seen, _, _, _, infos = env.step(played)
        env.close()


class Refusals(unittest.TestCase):
    def test_one_line_names_the_keyword(self):
        for config, text in (
                (dict(PLAIN, look=True, obs="full_state"), "'look' needs 'obs' = 'world_model'"),
                (dict(PLAIN, say=True, actions="low_flat"), "'say' needs actions with ids"),
                (dict(PLAIN, say="A"), "say: must be")):
            with self.assertRaisesRegex(cls_gym.ConfigError, text):
                cls_gym.Env(**config)

    def test_items_that_are_none(self):
        with cls_gym.Env(**SENSES) as env:
            env.reset(seed=1)
            rows = np.zeros((2, 5), np.int64)
            rows[1, 2] = 4
            with self.assertRaisesRegex(cls_gym.ActionError, "agent 1: view 4 is not in 0..3"):
                env.step(rows)
            with self.assertRaisesRegex(cls_gym.ActionError, r"shape \(2,\), must be \(2, 5\)"):
                env.step(rows[:, 0])

    def test_policies_that_have_none(self):
        with cls_gym.VectorEnv(num_envs=1, autoreset_mode="disabled", **SENSES) as envs:
            with self.assertRaisesRegex(policy.PolicyError, "^look, say: "):
                policy.describe(envs)
            from cls_gym.adapters import _common
            with self.assertRaisesRegex(cls_gym.ConfigError, "look, say: X takes ids alone"):
                _common.check_vector(envs, "X", envs.autoreset_mode)
        from cls_gym.league import SelfPlay
        with self.assertRaisesRegex(cls_gym.ConfigError, "^look, say: "):
            SelfPlay(lambda seen, masks: masks.argmax(-1), 1, **SENSES)


if __name__ == "__main__":
    unittest.main()
