"""Adapters of frameworks of one policy, in the real frameworks, by name where one is missing; the
examples of them. gym_multiagent_test.py has those of several agents.

python/tests/adapters runs both in environments that have all frameworks, demands that nothing is
skipped, and prints the speed of each adapter beside the engine's.
"""
import os
import tempfile
import unittest
import warnings

from gym_adapter_support import TASK, WORLDS, Adapter, actions, needs, vector  # first: see there
from gym_support import differences
import numpy as np

import cls_gym
from cls_gym._worlds import Worlds


class Engine(Adapter):
    def test_speed(self):
        for count in (1, WORLDS):
            with vector(count) as envs:
                envs.reset(seed=1)
                pool = envs._worlds.pool
                pool.action_ids[...] = actions(count, 2)
                self.note(pool.step, count, "engine alone")
                played = actions(count, 2)
                self.note(lambda: envs.step(played), count, "VectorEnv")
        with cls_gym.Env(**TASK) as env:
            env.reset(seed=1)

            def step():
                if any(env.step(np.array([9, 40]))[2:4]):
                    env.reset()
            self.note(step, 1, "Env")


@needs("gymnasium")
class PipelineOfGroups(Adapter):
    name = "Pipeline"

    def test_arrays_are_those_of_step(self):
        self.assertIn("world steps/s", self.run_example("pipeline.py"))
        worlds = cls_gym.Pipeline(num_envs=4, autoreset_mode="same_step", **TASK)
        with vector(4) as envs:
            worlds.async_reset(seed=3)
            seen = {tuple(batch[4]["env_id"]): batch for batch in (worlds.recv(), worlds.recv())}
            first, _ = envs.reset(seed=3)
            for ids, batch in seen.items():
                np.testing.assert_array_equal(batch[0], first[list(ids)])
            for played in actions(60, 4, 2):
                for ids in seen:
                    worlds.send(played[list(ids)], ids)
                expected = envs.step(played)
                for _ in seen:
                    batch = worlds.recv()
                    rows = batch[4]["env_id"]
                    for one, other in zip(batch[:4], expected):
                        self.assertEqual(differences(one, other[rows]), [])
                    np.testing.assert_array_equal(batch[4]["seed"], expected[4]["seed"][rows])
            self.assertRaisesRegex(cls_gym.ResetNeeded, "nothing was sent", worlds.recv)
            self.assertRaisesRegex(cls_gym.ActionError, "no group", worlds.send, played[:2], [0, 3])
            worlds.send(played[:2], [0, 1])
            self.assertRaisesRegex(cls_gym.ActionError, "plays already", worlds.send, played[:2],
                                   [0, 1])
            worlds.send(np.full((2, 2), 99), [2, 3])
            worlds.recv()
            self.assertRaises(cls_gym.ActionError, worlds.recv)
        worlds.close()
        self.refused(lambda: cls_gym.Pipeline(num_envs=5), "multiple of 2")

    def test_speed(self):
        worlds = cls_gym.Pipeline(num_envs=WORLDS, autoreset_mode="same_step", **TASK)
        worlds.async_reset(seed=1)
        played = actions(WORLDS // 2, 2)
        self.note(lambda: worlds.send(played, worlds.recv()[4]["env_id"]), WORLDS, steps=0.5)
        worlds.close()


@needs("pettingzoo")
class PettingZoo(Adapter):
    name = "PettingZoo ParallelEnv"

    def test_example_and_speed(self):
        self.assertIn("in turn:", self.run_example("pettingzoo_aec.py"))
        env = cls_gym.ParallelEnv(**TASK)
        env.reset(seed=1)

        def step():
            env.step(dict.fromkeys(env.agents, 9))
            if not env.agents:
                env.reset()
        self.note(step, 1)


@needs("supersuit", "stable_baselines3")
class SuperSuit(Adapter):
    name = "SuperSuit"

    def test_recipe_to_stable_baselines3(self):
        self.assertIn("mean reward of", self.run_example("supersuit_sb3.py", 1200))

    def test_speed(self):
        import supersuit
        envs = supersuit.concat_vec_envs_v1(supersuit.pettingzoo_env_to_vec_env_v1(
            cls_gym.ParallelEnv(**TASK)), 8, num_cpus=0, base_class="gymnasium")
        envs.reset(seed=1)
        played = actions(16)
        self.note(lambda: envs.step(played), 8)


@needs("stable_baselines3", "sb3_contrib")
class StableBaselines3(Adapter):
    name = "Stable-Baselines3"

    def test_policy_of_a_match_chooses_what_the_model_does(self):
        import torch
        from cls_gym import policy
        from sb3_contrib import MaskablePPO
        env = self.make(40)
        model = MaskablePPO("MlpPolicy", env, seed=1)
        parts = model.policy.mlp_extractor.policy_net, model.policy.action_net
        own = policy.from_torch(env.envs, *parts)
        seen, masks = env.reset(), np.stack(env.action_masks())
        chosen, _ = model.predict(seen, action_masks=masks, deterministic=True)
        np.testing.assert_array_equal(own.act(seen, masks), chosen)
        with tempfile.TemporaryDirectory() as folder:
            own.save(os.path.join(folder, "p.npz"))
            loaded = policy.load(os.path.join(folder, "p.npz"))
        self.assertEqual(loaded.about["features"], "ego")
        for wrong, text in (([torch.nn.ReLU(), *parts], "ReLU is neither Linear nor Tanh"),
                            (parts[:1], "not one score per action"),
                            (parts[1:], "layer 0 does not fit")):
            with self.assertRaisesRegex(policy.PolicyError, text):
                policy.from_torch(env.envs, *wrong)

    def make(self, count=3, **config):
        from cls_gym.adapters.sb3 import SB3VecEnv
        return SB3VecEnv(vector(count, **config))

    def test_rows_are_those_of_the_worlds(self):
        env, other = self.make(max_cycles=15), vector(max_cycles=15)
        self.assertEqual((env.num_envs, env.observation_space.shape, int(env.action_space.n)),
                         (6, (51,), 81))
        env.seed(4)
        np.testing.assert_array_equal(env.reset(), other.reset(seed=4)[0].reshape(6, -1))
        returns = np.zeros(6)
        for played in actions(40, 6):
            seen, rewards, dones, infos = env.step(played)
            expected = other.step(played.reshape(3, 2))
            returns += rewards
            np.testing.assert_array_equal(seen, expected[0].reshape(6, -1))
            np.testing.assert_array_equal(rewards, other.agent_rewards.ravel())
            np.testing.assert_array_equal(dones, np.repeat(expected[2] | expected[3], 2))
            for row in np.flatnonzero(dones):
                final = expected[4]["final_obs"][row // 2][row % 2]
                np.testing.assert_array_equal(infos[row]["terminal_observation"], final)
                self.assertEqual(infos[row]["TimeLimit.truncated"], bool(expected[3][row // 2]))
                self.assertAlmostEqual(infos[row]["episode"]["r"], returns[row])
                self.assertEqual(infos[row]["episode"]["t"],
                                 expected[4]["final_info"]["cycles"][row // 2])
                returns[row] = 0
        self.assertFalse(any(infos[row] for row in np.flatnonzero(~dones)))

    def test_masked_policy_plays_no_illegal_action_and_wrappers_work(self):
        from sb3_contrib import MaskablePPO
        from sb3_contrib.common.maskable.utils import get_action_masks, is_masking_supported
        from stable_baselines3 import PPO
        from stable_baselines3.common.evaluation import evaluate_policy
        from stable_baselines3.common.vec_env import VecNormalize
        env = self.make(4, mask="info")
        self.assertTrue(is_masking_supported(env))
        env.reset()
        self.assertEqual(get_action_masks(env).shape, (8, 81))
        MaskablePPO("MlpPolicy", env, n_steps=32, batch_size=64, n_epochs=1, seed=1).learn(600)
        self.assertEqual(env.envs._worlds.pool.illegal.sum(), 0)
        for place in ("appended", "observation"):
            kind = "MultiInputPolicy" if place == "observation" else "MlpPolicy"
            PPO(kind, self.make(2, mask=place), n_steps=16, batch_size=32, n_epochs=1).learn(64)
        normal = VecNormalize(self.make(2, actions="low_flat", max_cycles=20))
        model = PPO("MlpPolicy", normal, n_steps=32, batch_size=32, n_epochs=1).learn(128)
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # that no Monitor records the rewards
            mean, _ = evaluate_policy(model, normal, n_eval_episodes=4)
        self.assertTrue(np.isfinite(mean))

    def test_refusals(self):
        self.refused(lambda: self.make(actions="low"), "Stable-Baselines3 has no actions that are")
        self.refused(lambda: self.make(mode="next_step"), "needs 'same_step', not 'next_step'")
        from cls_gym.adapters.sb3 import SB3VecEnv
        self.refused(lambda: SB3VecEnv(cls_gym.Env(**TASK)), "a cls_gym.VectorEnv, not")
        env = self.make()
        self.assertRaisesRegex(AttributeError, "share one engine", env.set_attr, "x", 1)
        self.assertRaisesRegex(AttributeError, "no 'render'", env.env_method, "render")
        env.set_options([{"difficulty": 0.1}] + [{}] * 5)
        self.refused(env.reset, "one set of options")

    def test_example_and_speed(self):
        self.assertRegex(self.run_example("sb3_ppo.py", 4096), "goals in [01].[0-9]+ of 100")
        env = self.make(WORLDS)
        env.reset()
        played = actions(2 * WORLDS)
        self.note(lambda: env.step(played), WORLDS)


@needs("jax")
class Jax(Adapter):
    name = "JAX callback"

    def test_jitted_scan_gives_the_arrays_of_numpy(self):
        import jax
        from cls_gym.adapters.jax import functions
        reset, step = functions(vector(8, max_cycles=50))
        played = actions(1000, 8, 2)

        @jax.jit
        def play(ids):
            first = reset(3)
            return first, jax.lax.scan(lambda _, one: (None, step(one)), None, ids)[1]

        first, rest = jax.tree_util.tree_map(np.asarray, play(played))
        with vector(8, max_cycles=50) as envs:
            np.testing.assert_array_equal(first.observation, envs.reset(seed=3)[0])
            for number, ids in enumerate(played):
                seen, _, ended, cut, infos = envs.step(ids)
                for name, value in (("observation", seen), ("reward", envs.agent_rewards),
                                    ("terminated", ended), ("truncated", cut),
                                    ("mask", infos["action_mask"] != 0)):
                    np.testing.assert_array_equal(getattr(rest, name)[number], value)
        self.assertTrue(rest.truncated.any())

    def test_refusals_example_and_speed(self):
        from cls_gym.adapters.jax import functions
        self.refused(lambda: functions(vector(actions="low")), "JAX has no actions that are tuples")
        self.refused(lambda: functions(vector(mask="appended")), "masks beside")
        self.assertIn("goals, ", self.run_example("jax_scan.py"))
        import jax
        reset, step = functions(vector(WORLDS))
        played = actions(50, WORLDS, 2)
        play = jax.jit(lambda ids: jax.lax.scan(
            lambda _, one: (None, step(one).reward.sum()), None, ids)[1])
        self.note(lambda: play(played).block_until_ready(), WORLDS, steps=50)


@needs("pufferlib.vector")
class PufferLib(Adapter):
    name = "PufferLib"
    with_old_gymnasium = True

    def test_example_and_what_is_refused(self):
        self.assertIn("128 rows", self.run_example("puffer_rows.py"))
        from cls_gym.adapters.pufferlib import PufferCls
        self.refused(lambda: PufferCls(actions="low"), "PufferLib has no actions that are tuples")
        self.refused(lambda: PufferCls(mask="observation"), "dictionaries")

    def test_rows_are_those_of_the_worlds_without_copies(self):
        from cls_gym.adapters.pufferlib import PufferCls
        config = dict(TASK, num_envs=3, max_cycles=20)
        for mask in ("info", "appended"):
            env = PufferCls(mask=mask, **config)
            other = Worlds(TASK["task"], 3, {key: config[key] for key in (
                "features", "actions", "max_cycles")}, autoreset="same_step")
            pool = env.worlds.pool
            self.assertEqual(pool.rewards.ctypes.data, env.rewards.ctypes.data)
            self.assertEqual(pool.observations.ctypes.data == env.observations.ctypes.data,
                             mask == "info")
            env.reset(seed=4)
            other.pool.bind(next_seeds=env._seeds.next)
            first = env.worlds.pool.seeds.copy()
            other.reset(None, first, None)
            for played in actions(60, 6):
                other.set_actions(played.reshape(3, 2))
                other.step()  # first: the other one draws the next seeds
                seen, rewards, ended, cut, _ = env.step(played)
                np.testing.assert_array_equal(seen[:, :51], other.pool.observations.reshape(6, -1))
                np.testing.assert_array_equal(rewards, other.pool.rewards.ravel())
                np.testing.assert_array_equal(ended, np.repeat(other.pool.terminated, 2))
                np.testing.assert_array_equal(cut, np.repeat(other.pool.truncated, 2))
                if mask == "appended":
                    np.testing.assert_array_equal(seen[:, 51:],
                                                  other.pool.action_masks.reshape(6, -1))
            self.assertNotEqual(env._seeds.current.tolist(), first.tolist())

    def test_processes_give_the_arrays_of_one(self):
        if __name__ != "__main__":
            self.skipTest("processes need a program")
        import pufferlib.vector
        from cls_gym.adapters.pufferlib import PufferCls
        results = []
        for backend, more in ((pufferlib.vector.Serial, {}),
                              (pufferlib.vector.Multiprocessing, {"num_workers": 2})):
            rows = pufferlib.vector.make(
                PufferCls, backend=backend, num_envs=2,
                env_kwargs=dict(TASK, num_envs=4, max_cycles=20), **more)
            played = [rows.reset(seed=5)[0].copy()]
            for ids in actions(60, 16):
                played.append([one.copy() for one in rows.step(ids)[:4]])
            rows.close()
            results.append(played)
        self.assertEqual(differences(*results), [])

    def test_speed(self):
        from cls_gym.adapters.pufferlib import PufferCls
        played = actions(2 * WORLDS)
        for mask in ("appended", "info"):
            env = PufferCls(num_envs=WORLDS, mask=mask, **TASK)
            env.reset()
            self.note(lambda: env.step(played), WORLDS, f"PufferLib, mask={mask}")


if __name__ == "__main__":
    unittest.main()
