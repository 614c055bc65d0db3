"""Agents that choose among options, and what the planner would choose."""
import unittest

from gym_support import differences  # noqa: F401  first: may hide gymnasium
import numpy as np

import cls_gym

OPTIONS = {"task": "cls/Match-v0", "obs": "world_model", "features": "team",
           "actions": "options", "expert": "planner"}


class Experts(unittest.TestCase):
    def test_choices_are_legal_and_in_the_infos(self):
        with cls_gym.VectorEnv(num_envs=2, until="decision", frame_skip=20, **OPTIONS) as envs:
            self.assertEqual(envs.spec_of_task.document["expert"], "planner")
            _, infos = envs.reset(seed=1)
            chosen = 0
            for _ in range(100):
                expert, mask = infos["expert"], infos["action_mask"]
                self.assertEqual((expert.shape, expert.dtype), ((2, 11), np.int32))
                asked = expert >= 0
                legal = np.take_along_axis(mask, np.maximum(expert, 0)[..., None], 2)[..., 0]
                self.assertTrue(legal[asked].all())
                with_ball = mask[:, :, 0] == 0
                chosen += int(with_ball.sum())
                _, _, _, _, infos = envs.step(np.where(with_ball, expert, 0))
            self.assertGreater(chosen, 5)
            self.assertEqual(int(infos["illegal"].sum()), 0)

    def test_there_is_none_by_default(self):
        with cls_gym.Env(**dict(OPTIONS, expert="none")) as env:
            _, info = env.reset(seed=1)
            self.assertNotIn("expert", info)

    def test_refusals_name_what_is_missing(self):
        for changes, text in (({"obs": "full_state"}, "world_model"),
                              ({"actions": "skills"}, "needs the actions 'options'")):
            with self.assertRaisesRegex(cls_gym.ConfigError, text):
                cls_gym.Env(**dict(OPTIONS, **changes))


if __name__ == "__main__":
    unittest.main()
