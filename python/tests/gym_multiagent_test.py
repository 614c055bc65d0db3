"""Adapters of frameworks of several agents, as gym_adapters_test.py."""
import os
import pathlib
import tempfile
import unittest

from gym_adapter_support import (EXAMPLES, TASK, WORLDS, Adapter, actions, needs,  # first: see there
                                 vector)
import numpy as np

import cls_gym


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

    def test_policy_of_a_match_has_the_scores_of_the_network(self):
        import torch
        from cls_gym.policy import from_torch
        from torchrl.modules import MultiAgentMLP
        env = self.make(20)
        seen = env.reset()["agents", "observation"]
        network = MultiAgentMLP(seen.shape[-1], 81, seen.shape[-2], centralized=False,
                                share_params=True)
        with torch.no_grad():
            scores = network(seen).numpy()
        own = from_torch(env.envs, network).scores(seen.numpy())
        np.testing.assert_allclose(own, scores, atol=1e-5)

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

    def test_policy_of_a_match_has_the_scores_of_the_module(self):
        import torch
        from cls_gym.adapters.rllib import ClsMultiAgentEnv, MaskedModule
        from cls_gym.policy import from_torch
        from ray.rllib.core.rl_module.rl_module import RLModuleSpec
        env = ClsMultiAgentEnv({**TASK, "mask": "observation"})
        agent = env.possible_agents[0]
        module = RLModuleSpec(
            module_class=MaskedModule, observation_space=env.observation_spaces[agent],
            action_space=env.action_spaces[agent], model_config={"vf_share_layers": False}).build()
        seen = env.reset(seed=1)[0][agent]
        rows = {key: torch.as_tensor(value)[None] for key, value in seen.items()}
        with torch.no_grad():
            scores = module.forward_inference({"obs": rows})["action_dist_inputs"][0].numpy()
        own = from_torch(env.env, module.encoder.actor_encoder, module.pi)
        legal = seen["action_mask"] != 0
        np.testing.assert_allclose(own.scores(seen["observation"])[legal], scores[legal], atol=1e-5)

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


if __name__ == "__main__":
    unittest.main()
