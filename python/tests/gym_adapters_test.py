"""Each adapter in its real framework, by name where that is missing; the examples of them.

python/tests/adapters runs this in environments that have all frameworks, demands that nothing is
skipped, and prints the speed of each adapter beside the engine's.
"""
import contextlib
import importlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
import warnings

import gym_support  # noqa: F401  first: may hide gymnasium
import numpy as np
from gym_support import differences

import cls_gym
from cls_gym._api import old_gymnasium
from cls_gym._worlds import Worlds

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/training/frameworks"
SPEEDS = os.environ.get("CLS_ADAPTERS_SPEEDS")
#: What is measured, with random but constant actions.
TASK = {"task": "cls/HFO-2v1-v0", "features": "ego", "actions": "low_discrete"}
WORLDS = 64
os.environ.setdefault("RAY_AUTH_MODE", "disabled")  # else it writes a token into the home
warnings.filterwarnings("ignore")


def needs(*modules):
    """Skips a test case by name unless the modules can be imported."""
    missing = []
    for name in modules:
        with contextlib.redirect_stderr(io.StringIO()):
            try:
                importlib.import_module(name)
            except ImportError:
                missing.append(name.split(".")[0])
    return unittest.skipIf(missing, f"no {', '.join(missing)}")


def vector(count=3, mode="same_step", **config):
    return cls_gym.VectorEnv(num_envs=count, autoreset_mode=mode, **{**TASK, **config})


def actions(steps, *shape, ids=81, seed=2):
    """int64[steps, ...]: random ids."""
    return np.random.default_rng(seed).integers(0, ids, (steps, *shape))


class Adapter(unittest.TestCase):
    """`name` is the row of the table, `worlds` how many a call of `stepper` plays."""

    name = ""
    with_old_gymnasium = False

    def setUp(self):
        if old_gymnasium and not self.with_old_gymnasium:
            self.skipTest(f"Gymnasium {old_gymnasium} is too old")

    def note(self, step, worlds, name=None, steps=1, seconds=1.0):
        """Notes world steps per second of processor time of a function that plays `steps` of
        `worlds`."""
        if not SPEEDS:
            return
        step()
        started, count = time.process_time(), 0
        while time.process_time() - started < seconds:
            step()
            count += 1
        rate = count * worlds * steps / (time.process_time() - started)
        with open(SPEEDS, "a", encoding="utf-8") as out:
            print(json.dumps({"name": name or self.name, "worlds": worlds, "rate": rate}),
                  file=out)

    def run_example(self, file, *arguments, seconds=400):
        """The output of an example of at most 40 lines, blank ones aside."""
        text = (EXAMPLES / file).read_text("utf-8")
        self.assertLessEqual(sum(bool(line.strip()) for line in text.splitlines()), 40, file)
        with tempfile.TemporaryDirectory() as folder:
            paths = [str(pathlib.Path(cls_gym.__file__).parents[1]), os.environ.get("PYTHONPATH")]
            done = subprocess.run(
                [sys.executable, str(EXAMPLES / file), *map(str, arguments)], cwd=folder,
                text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                timeout=seconds, env={**os.environ, "PYTHONPATH": os.pathsep.join(
                    filter(None, paths)), "TMPDIR": folder, "CUDA_VISIBLE_DEVICES": ""})
        self.assertEqual(done.returncode, 0, done.stderr[-3000:])
        return done.stdout

    def refused(self, make, text):
        """A line that names what cannot be."""
        with self.assertRaisesRegex((cls_gym.ConfigError, TypeError), text):
            make()


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


@needs("torchrl")
class TorchRL(Adapter):
    name = "TorchRL"

    def make(self, count=3, **config):
        from cls_gym.adapters.torchrl import ClsEnv
        return ClsEnv(vector(count, "disabled", **config))

    def test_specs_of_every_action_set_and_what_is_refused(self):
        from torchrl.envs import check_env_specs
        for one in ("low_discrete", "skills", "low_flat"):
            for task in ("cls/HFO-1v0-v0", "cls/HFO-2v1-v0"):
                check_env_specs(self.make(task=task, actions=one))
        self.refused(lambda: self.make(actions="hfo"), "TorchRL has no actions that are tuples")
        self.refused(lambda: self.make(mask="appended"), "ActionMask reads")

    def test_rollout_is_that_of_the_worlds_with_partial_resets(self):
        env, other = self.make(max_cycles=12), vector(mode="disabled", max_cycles=12)
        env.set_seed(4)
        rolled = env.rollout(40, break_when_any_done=False)
        seen, _ = other.reset(seed=4)
        for step in range(40):
            now = rolled[:, step]
            np.testing.assert_array_equal(now["agents", "observation"], seen)
            seen, _, ended, cut, _ = other.step(now["agents", "action"].numpy())
            np.testing.assert_array_equal(now["next", "agents", "observation"], seen)
            np.testing.assert_array_equal(now["next", "agents", "reward"][..., 0],
                                          other.agent_rewards)
            np.testing.assert_array_equal(now["next", "state"], other.state())
            np.testing.assert_array_equal(now["next", "done"][:, 0], ended | cut)
            if (ended | cut).any():
                seen, _ = other.reset(options={"reset_mask": ended | cut})
        self.assertTrue(rolled["next", "truncated"].any())

    def test_masks_processes_and_pettingzoo(self):
        from torchrl.envs import (ActionMask, ParallelEnv, PettingZooWrapper, TransformedEnv,
                                  check_env_specs)
        masked = TransformedEnv(self.make(max_cycles=30), ActionMask(
            action_key=("agents", "action"), mask_key=("agents", "action_mask")))
        masked.rollout(25, break_when_any_done=False)
        self.assertEqual(masked.envs._worlds.pool.illegal.sum(), 0)
        if __name__ == "__main__":
            both = ParallelEnv(2, self.make)
            self.assertEqual(tuple(both.rollout(3).batch_size), (2, 3, 3))
            both.close()
        check_env_specs(PettingZooWrapper(cls_gym.ParallelEnv(**TASK), use_mask=True))

    def test_example_and_speed(self):
        self.assertIn("goals ", self.run_example("torchrl_mappo.py", 1))
        import torch
        env = self.make(WORLDS)
        data = env.reset()
        data["agents", "action"] = torch.from_numpy(actions(WORLDS, 2))

        def step():
            done = env.step(data)["next", "done"]
            if done.any():
                env.reset(data.select().set("_reset", done))
        self.note(step, WORLDS)


@needs("benchmarl")
class BenchMARL(Adapter):
    name = "BenchMARL"

    def test_three_algorithms_run(self):
        for name in ("mappo", "ippo", "qmix"):
            with self.subTest(name):
                self.assertIn("mean return", self.run_example("benchmarl_mappo.py", name, 3))

    def test_unknown_tasks_and_speed(self):
        from cls_gym.adapters.benchmarl import ClsTask
        self.refused(lambda: ClsTask("cls/HFO-1x0-v0"), "did you mean")
        task = ClsTask("cls/HFO-2v1-v0", {"features": "ego"})
        env = task.get_env_fun(WORLDS, False, 1, "cpu")()
        self.assertEqual(task.group_map(env), {"agents": ["left_11", "left_7"]})
        self.assertEqual(task.max_steps(env), 1001)
        self.note(lambda: env.rollout(8, break_when_any_done=False), WORLDS, steps=8)


@needs("skrl")
class Skrl(Adapter):
    name = "skrl"

    def make(self, count=3, **config):
        from cls_gym.adapters.skrl import ClsMultiAgent
        return ClsMultiAgent(vector(count, **config))

    def test_tensors_are_those_of_the_worlds(self):
        import torch
        env, other = self.make(max_cycles=12), vector(max_cycles=12)
        env._seed = 4
        seen, _ = env.reset()
        expected, _ = other.reset(seed=4)
        for played in actions(30, 3, 2):
            for place, agent in enumerate(env.agents):
                np.testing.assert_array_equal(seen[agent], expected[:, place])
            np.testing.assert_array_equal(env.state()["left_7"], other.state())
            seen, rewards, ended, cut, _ = env.step({
                agent: torch.from_numpy(played[:, [place]])
                for place, agent in enumerate(env.agents)})
            expected, _, *ends, _ = other.step(played)
            np.testing.assert_array_equal(rewards["left_7"][:, 0], other.agent_rewards[:, 1])
            np.testing.assert_array_equal(ended["left_7"][:, 0], ends[0])
            np.testing.assert_array_equal(cut["left_11"][:, 0], ends[1])

    def test_refusals_example_and_speed(self):
        self.refused(lambda: self.make(mask="observation"), "skrl flattens")
        self.refused(lambda: self.make(actions="low"), "skrl has no actions that are tuples")
        self.run_example("skrl_mappo.py", 70)
        import torch
        env = self.make(WORLDS)
        env.reset()
        played = {agent: torch.from_numpy(actions(WORLDS, 1)) for agent in env.agents}
        self.note(lambda: env.step(played), WORLDS)


#: The example with an environment that counts illegal actions, and its policy from a checkpoint.
#: RLlib checks each environment with a random action in the first cycle.
MASKED_RLLIB = """
import runpy
import numpy as np
from ray.rllib.algorithms.algorithm import Algorithm
from cls_gym.adapters import rllib

kept = []
class Kept(rllib.ClsMultiAgentEnv):
    def __init__(self, config):
        super().__init__({{**config, "frame_skip": 1}})  # the mask is of the first cycle

    def step(self, played):
        result = super().step(played)
        now = sum(one["illegal"] for one in result[4].values())
        if result[4][next(iter(result[4]))]["cycles"] > 1:
            kept.append(now - self.before)
        self.before = now
        return result

rllib.ClsMultiAgentEnv = Kept
algorithm = runpy.run_path({example!r})["algorithm"]
assert len(kept) > 400 and max(kept) == 0, (len(kept), max(kept))
saved = algorithm.get_module("shared").get_state()
again = Algorithm.from_checkpoint(algorithm.save_to_path())
for key, value in again.get_module("shared").get_state().items():
    np.testing.assert_array_equal(value, saved[key])
print("restored")
"""


@needs("ray.rllib", "pettingzoo", "torch")
class RLlib(Adapter):
    name = "RLlib MultiAgentEnv"

    def test_dictionaries_and_what_is_refused(self):
        from cls_gym.adapters.rllib import ClsMultiAgentEnv, MaskedModule
        env = ClsMultiAgentEnv({**TASK, "agents": "both", "max_cycles": 10})
        seen, _ = env.reset(seed=1)
        self.assertEqual(set(seen), set(env.possible_agents))
        for _ in range(10):
            seen, rewards, ended, cut, infos = env.step(dict.fromkeys(env.agents, 9))
        self.assertEqual((ended["__all__"], cut["__all__"], env.agents), (False, True, []))
        self.assertEqual(set(rewards), set(env.possible_agents))
        self.refused(lambda: MaskedModule(observation_space=env.observation_spaces["left_7"]),
                     "mask=\"observation\"")

    def test_policy_learns_with_masks_and_a_checkpoint_restores(self):
        program = MASKED_RLLIB.format(example=str(EXAMPLES / "rllib_ppo.py"))
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "program.py").write_text(program)
            out = self.run_example(pathlib.Path(folder) / "program.py", 1)
        self.assertIn("restored", out)
        text = (EXAMPLES / "rllib_ppo.py").read_text("utf-8")
        self.assertLessEqual(sum(bool(line.strip()) for line in text.splitlines()), 40)

    def test_speed(self):
        from cls_gym.adapters.rllib import ClsMultiAgentEnv
        env = ClsMultiAgentEnv(TASK)
        env.reset(seed=1)

        def step():
            env.step(dict.fromkeys(env.agents, 9))
            if not env.agents:
                env.reset()
        self.note(step, 1)


class Smac(Adapter):
    name = "SMAC facade"

    def make(self, **config):
        from cls_gym.adapters.smac import SmacEnv
        return SmacEnv(**{**TASK, **config})

    def test_interface(self):
        env = self.make(max_cycles=12, frame_skip=4)
        info = env.get_env_info()
        self.assertEqual(info, {"state_shape": env.get_state_size(), "obs_shape": 51,
                                "n_actions": 81, "n_agents": 2, "episode_limit": 3})
        seen, _ = env.reset(seed=1)
        self.assertEqual((len(seen), seen[0].shape), (2, (51,)))
        self.assertEqual(np.shape(env.get_avail_actions()), (2, 81))
        for step in range(3):
            seen, reward, ended, cut, extra = env.step([9, 9])
        self.assertEqual((ended, cut, extra), (False, True, {"battle_won": False,
                                                             "episode_limit": True}))
        np.testing.assert_array_equal(seen[1], env.get_obs_agent(1))
        self.assertEqual(env.get_stats()["battles_game"], 1)
        old = self.make(smac=True, max_cycles=1)
        seen, state = old.reset()
        self.assertEqual(state.shape, (info["state_shape"],))
        reward, over, extra = old.step(np.array([[9], [9]]))
        self.assertTrue(over and extra["episode_limit"])
        self.refused(lambda: self.make(actions="low"), "SMAC's interface has no actions that are")
        self.refused(lambda: self.make(actions="low_flat"), "needs ids")
        self.refused(lambda: self.make(mask="appended"), "get_avail_actions")
        self.refused(lambda: self.make(common_reward=False), "one reward for all")

    @unittest.skipIf(not os.environ.get("CLS_EPYMARL"),
                     "no EPyMARL: CLS_EPYMARL names the folder src of a clone")
    @needs("torch", "yaml")
    def test_epymarl_learns(self):
        for name in ("qmix", "mappo"):
            with self.subTest(name):
                self.run_example("epymarl_qmix.py", os.environ["CLS_EPYMARL"], name, 300)

    def test_speed(self):
        env = self.make()
        env.reset(seed=1)

        def step():
            env.get_avail_actions()
            if any(env.step([9, 9])[2:4]):
                env.reset()
        self.note(step, 1)


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
