"""Masks, attributes and arrays of environments: where they are, and that they say what is."""
import unittest

import gym_support  # noqa: F401  first: may hide gymnasium
import numpy as np
from gym_support import ACTION_SETS, differences, of_set, seeded_actions

import cls_gym

HFO = "cls/HFO-1v0-v0"


class Masks(unittest.TestCase):
    def test_they_fit_sample_in_every_action_set(self):
        for actions in ACTION_SETS:
            for task in (HFO, "cls/HFO-2v1-v0"):
                with self.subTest(f"{task} {actions}"), cls_gym.Env(task, **of_set(actions)) as env:
                    _, info = env.reset(seed=1)
                    env.action_space.seed(1)
                    for _ in range(40):
                        action = env.action_space.sample(info.get("action_mask"))
                        self.assertIn(action, env.action_space)
                        *_, terminated, truncated, info = env.step(action)
                        self.assertEqual(np.sum(info["illegal"]), 0)
                        if terminated or truncated:
                            _, info = env.reset()
                with self.subTest(f"vector {task} {actions}"), \
                        cls_gym.VectorEnv(task, 3, **of_set(actions)) as envs:
                    _, infos = envs.reset(seed=1)
                    envs.action_space.seed(1)
                    for _ in range(40):
                        mask = infos.get("id_mask", infos.get("action_mask"))
                        action = envs.action_space.sample(mask)
                        self.assertIn(action, envs.action_space)
                        infos = envs.step(action)[4]
                        self.assertEqual(infos["illegal"].sum(), 0)

    def test_ids_are_drawn_evenly_among_those_allowed(self):
        space = cls_gym.VectorEnv("cls/HFO-2v1-v0", 400, actions="low_discrete").action_space
        space.seed(1)
        mask = np.zeros((400, 2, 81), np.int8)
        mask[..., [3, 80]] = 1
        drawn = space.sample(mask)
        self.assertEqual(set(np.unique(drawn)), {3, 80})
        self.assertLess(abs(np.mean(drawn == 3) - 0.5), 0.08)
        self.assertEqual(space.sample(np.zeros_like(mask)).max(), 0)
        self.assertRaisesRegex(ValueError, "shape", space.sample, mask[..., :5])

    def test_tuples_have_the_ids_mask_beside(self):
        with cls_gym.Env(HFO, actions="low") as env:
            _, info = env.reset(seed=1)
            self.assertIs(info["action_mask"][0], info["id_mask"])
            self.assertEqual(info["action_mask"][1:], (None,) * (len(env.action_space.spaces) - 1))

    def test_places(self):
        for task, shape in ((HFO, ()), ("cls/HFO-2v1-v0", (2,))):
            for actions, name in (("low_discrete", "action_mask"), ("low", "id_mask")):
                with self.subTest(f"{task} {actions}"):
                    self.check_places(task, shape, actions, name)

    def check_places(self, task, shape, actions, name):
        made = [cls_gym.Env(task, actions=actions, mask=place)
                for place in ("info", "observation", "appended")]
        for _ in range(2):
            plain, info = made[0].reset(seed=2)
            inside, without = made[1].reset(seed=2)
            flat, also_without = made[2].reset(seed=2)
            mask = info[name]
            self.assertEqual(mask.shape[:-1], shape)
            self.assertEqual(set(info) - set(without), {name, "action_mask"})
            self.assertEqual(set(without), set(also_without))
            self.assertEqual(differences(inside, {"observation": plain, name: mask}), [])
            self.assertEqual(flat.dtype, np.float32)
            np.testing.assert_array_equal(flat, np.concatenate([plain, mask], -1))
            for env, seen in zip(made, (plain, inside, flat)):
                self.assertIn(seen, env.observation_space)
        for env in made:
            env.close()

    def test_action_masks(self):
        for task, agents in ((HFO, 1), ("cls/HFO-2v1-v0", 2)):
            with cls_gym.Env(task, actions="low_discrete", max_cycles=2) as env:
                self.assertRaises(cls_gym.ResetNeeded, env.action_masks)
                _, info = env.reset(seed=1)
                self.assertEqual(env.action_masks().dtype, np.bool_)
                np.testing.assert_array_equal(env.action_masks(), info["action_mask"].ravel() != 0)
                for _ in range(2):
                    env.step(env.action_space.sample())
                self.assertTrue(env.action_masks().all())  # none is played
            with cls_gym.VectorEnv(task, 3, actions="low_discrete") as envs:
                _, infos = envs.reset(seed=1)
                masks = envs.action_masks()
                self.assertIsInstance(masks, list)
                np.testing.assert_array_equal(
                    np.stack(masks), infos["action_mask"].reshape(3, 81 * agents) != 0)
        with cls_gym.Env(HFO, actions="low_flat") as env:
            env.reset(seed=1)
            self.assertRaisesRegex(cls_gym.ActionError, "low_flat", env.action_masks)


class Attributes(unittest.TestCase):
    def test_they_are_there(self):
        with cls_gym.VectorEnv("cls/HFO-2v1-v0", 3, autoreset_mode="same_step") as envs:
            envs.reset(seed=1)
            self.assertIs(envs.autoreset_mode, cls_gym.AutoresetMode.SAME_STEP)
            self.assertIs(envs.metadata["autoreset_mode"], envs.autoreset_mode)
            self.assertEqual(envs.num_agents, 2)
            self.assertEqual((envs.alive.shape, envs.alive.dtype, envs.alive.all()),
                             ((3, 2), np.bool_, True))
            self.assertEqual(envs.agent_rewards.shape, (3, 2))
            envs._worlds.pool.terminated[0] = True
            envs._worlds.pool.alive[1, 0] = False  # a red card
            self.assertEqual(envs.agent_terminations.tolist(),
                             [[True, True], [True, False], [False, False]])
        with cls_gym.Env("cls/HFO-2v1-v0") as env:
            env.reset(seed=1)
            self.assertEqual((env.num_agents, env.alive.tolist(), env.agent_rewards.shape),
                             (2, [True, True], (2,)))
            self.assertEqual(env.agent_terminations.tolist(), [False, False])

    def test_final_state_is_that_of_the_ended_episode(self):
        with cls_gym.VectorEnv(HFO, 2, actions="low_discrete", max_cycles=3,
                               autoreset_mode="same_step") as envs, \
                cls_gym.Env(HFO, actions="low_discrete", max_cycles=3) as env:
            envs.reset(seed=1)
            env.reset(seed=1)
            for _ in range(3):
                infos = envs.step(np.array([9, 9]))[4]
                env.step(9)
            np.testing.assert_array_equal(infos["final_state"][0], env.state())
            self.assertEqual(infos["_final_state"].tolist(), [True, True])
            self.assertFalse(np.array_equal(envs.state()[0], env.state()))


class Buffers(unittest.TestCase):
    def test_two_arrays_alternate_without_copies(self):
        for mode in ("next_step", "same_step", "disabled"):
            with cls_gym.VectorEnv(HFO, 3, copy=False, autoreset_mode=mode) as envs, \
                    cls_gym.VectorEnv(HFO, 3, autoreset_mode=mode) as copied:
                last, _ = envs.reset(seed=1)
                expected = copied.reset(seed=1)[0]
                places = {last.ctypes.data}
                for action in seeded_actions(envs.action_space, 1, 6):
                    now, before = envs.step(action)[0], expected
                    expected = copied.step(action)[0]
                    np.testing.assert_array_equal(last, before)  # a learner stores it now
                    np.testing.assert_array_equal(now, expected)
                    places.add(now.ctypes.data)
                    last = now
                self.assertEqual(len(places), 2)
                self.assertRaises(cls_gym.ActionError, envs.step, None)
                self.assertRaises(ValueError, envs.reset, options={"difficulty": 7})
                kept, some = last.copy(), np.array([True, False, False])
                seen, _ = envs.reset(options={"reset_mask": some})
                np.testing.assert_array_equal(last, kept)
                np.testing.assert_array_equal(seen[1:], kept[1:])
                snapshot = envs.snapshot(0)
                envs.step(seeded_actions(envs.action_space, 1, 1)[0])
                np.testing.assert_array_equal(envs.restore(0, snapshot), seen[0])

    def test_arrays_of_the_caller_are_filled(self):
        memory = bytearray(4 * 3 * 2 * 61)
        observations = np.frombuffer(memory, np.float32)
        rewards = np.ones((3, 2), np.float32)
        with cls_gym.VectorEnv("cls/HFO-2v2-v0", 3, features="ego", copy=False,
                               actions="low_discrete") as envs, \
                cls_gym.VectorEnv("cls/HFO-2v2-v0", 3, features="ego",
                                  actions="low_discrete") as other:
            envs.bind(observations=observations, rewards=rewards,
                      action_ids=np.zeros((3, 2), np.int32))
            seen, _ = envs.reset(seed=1)
            self.assertEqual(seen.ctypes.data, observations.ctypes.data)
            self.assertEqual(differences(other.reset(seed=1)[0], seen), [])
            action = np.full((3, 2), 9)
            self.assertEqual(differences(other.step(action), envs.step(action)), [])
            self.assertFalse(rewards.any())
            for arrays, text in (({"observations": observations[1:]}, r"ons: float32\[365"),
                                 ({"rewards": np.zeros((3, 2))}, "rewards: float64"),
                                 ({"rewards": np.zeros((2, 3), np.float32).T}, "contiguous"),
                                 ({"reward": rewards}, "did you mean 'rewards'"),
                                 ({"final_state": rewards}, "same_step"),
                                 ({"next_seeds": np.zeros(3, np.uint64)}, "next_seeds")):
                self.assertRaisesRegex(cls_gym.ConfigError, text, envs.bind, **arrays)


if __name__ == "__main__":
    unittest.main()
