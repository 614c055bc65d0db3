"""The official checkers of Gymnasium, PettingZoo and Stable-Baselines3, without a warning."""
import contextlib
import io
import types
import unittest
import warnings

from gym_support import ACTION_SETS, TASKS, differences, of_set, seeded_actions

import cls_gym

FEATURES = [entry.get("name") or entry.get("set") for entry in cls_gym.catalog()["feature_sets"]]
HFO = "cls/HFO-1v0-v0"

try:
    import gymnasium
    from gymnasium.utils.env_checker import check_env
except ImportError:
    gymnasium = None
try:
    from pettingzoo.test import (api_test, max_cycles_test, parallel_api_test, parallel_seed_test,
                                 render_test)
    from pettingzoo.utils import parallel_to_aec
except ImportError:
    parallel_api_test = None
try:
    from stable_baselines3.common.env_checker import check_env as check_for_sb3
except ImportError:
    check_for_sb3 = None


def check(env):
    """Gymnasium's checker; it also renders to the terminal."""
    with contextlib.redirect_stdout(io.StringIO()):
        check_env(env.unwrapped)


@unittest.skipIf(gymnasium is None, "no gymnasium: pip install gymnasium")
class Gymnasium(unittest.TestCase):
    def setUp(self):
        self.enterContext(warnings.catch_warnings())
        warnings.simplefilter("error")

    def test_checker_accepts_every_id(self):
        for id in cls_gym.ids():
            with self.subTest(id):
                env = gymnasium.make(id)
                check(env)
                env.close()

    def test_checker_accepts_features_and_actions(self):
        for features in FEATURES:
            for actions in ACTION_SETS if features != "team" else ("options",):
                with self.subTest(f"{features} {actions}"):
                    env = gymnasium.make(HFO, features=features, **of_set(actions))
                    check(env)
                    env.close()

    def test_checker_accepts_what_players_know(self):
        for actions in ACTION_SETS:
            for opponent in ("scripted", "mock", {"planner": 1, "hold": 1}):
                with self.subTest(f"{actions} {opponent}"):
                    env = gymnasium.make("cls/HFO-1v1-v0", obs="world_model", actions=actions,
                                         opponent=opponent)
                    check(env)
                    env.close()

    def test_make_vec_in_its_three_modes(self):
        results = []
        for mode in ("sync", "async", "vector_entry_point"):
            with self.subTest(mode):
                envs = gymnasium.make_vec(HFO, num_envs=3, vectorization_mode=mode,
                                          actions="low_discrete", max_cycles=9)
                out = [envs.reset(seed=5)]
                for action in seeded_actions(envs.action_space, 2, 25):
                    out.append(envs.step(action))
                results.append(out)
                self.assertIs(envs.unwrapped.metadata["autoreset_mode"],
                              gymnasium.vector.AutoresetMode.NEXT_STEP)
                envs.close()
        self.assertEqual(differences(results[0], results[1]), [])
        self.assertEqual(differences(results[0], results[2]), [])

    def test_make_vec_makes_the_native_environment(self):
        envs = gymnasium.make_vec("cls_gym:" + HFO, num_envs=3, actions="low_discrete")
        self.assertIsInstance(envs.unwrapped, cls_gym.VectorEnv)
        self.assertEqual(envs.metadata["autoreset_mode"],
                         gymnasium.vector.AutoresetMode.NEXT_STEP)
        self.assertIs(envs.unwrapped.autoreset_mode, envs.metadata["autoreset_mode"])
        envs.close()

    def test_vector_equals_sync_vector_env(self):
        for mode in gymnasium.vector.AutoresetMode:
            for actions in ("low", "low_flat", "low_discrete", "skills"):
                with self.subTest(f"{mode} {actions}"):
                    self.compare(mode, actions=actions, max_cycles=30)
            for mask in ("observation", "appended"):
                for task, actions in ((HFO, "low"), ("cls/HFO-2v1-v0", "low_discrete")):
                    with self.subTest(f"{mode} {mask} {actions}"):
                        self.compare(mode, task, actions=actions, mask=mask, max_cycles=30)

    def comparable(self, one, other):
        """Without what the native environment has beside, and tuples, which it has not."""
        for infos in (one[-1], one[-1].get("final_info", {})):
            if "id_mask" in infos:
                infos.pop("action_mask")
                infos.pop("_action_mask")
        for key in ("final_state", "_final_state"):
            other[-1].pop(key, None)
        return one, other

    def compare(self, mode, task=HFO, **config):
        count = 4
        sync = gymnasium.vector.SyncVectorEnv([lambda: cls_gym.Env(task, **config)] * count,
                                              autoreset_mode=mode)
        native = cls_gym.VectorEnv(task, count, autoreset_mode=mode, **config)
        self.assertEqual(sync.observation_space, native.observation_space)
        self.assertEqual(sync.action_space, native.action_space)
        for seed in (3, None):
            self.assertEqual(differences(*self.comparable(sync.reset(seed=seed),
                                                          native.reset(seed=seed))), [])
        sync.action_space.seed(1)
        for _ in range(150):
            action = sync.action_space.sample()
            one, other = sync.step(action), native.step(action)
            self.assertEqual(differences(*self.comparable(one, other)), [])
            ended = one[2] | one[3]
            if mode is gymnasium.vector.AutoresetMode.DISABLED and ended.any():
                self.assertEqual(differences(*self.comparable(
                    sync.reset(options={"reset_mask": ended.copy()}),
                    native.reset(options={"reset_mask": ended.copy()}))), [])
        sync.close()
        native.close()


@unittest.skipIf(check_for_sb3 is None, "no stable_baselines3: pip install stable-baselines3")
class StableBaselines3(unittest.TestCase):
    def test_checker_accepts(self):
        for task in TASKS:
            for actions in ("low_flat", "low_discrete"):  # it has no tuples of actions
                with self.subTest(f"{task} {actions}"), warnings.catch_warnings():
                    warnings.simplefilter("error")
                    env = cls_gym.Env(task, actions=actions, num_agents=1)
                    check_for_sb3(env)
                    env.close()


@unittest.skipIf(parallel_api_test is None, "no pettingzoo: pip install pettingzoo")
class PettingZoo(unittest.TestCase):
    def make(self, task="cls/HFO-2v2-v0", **config):
        return cls_gym.ParallelEnv(task, agents="both", **dict({"features": "ego"}, **config))

    def test_checkers_accept(self):
        for actions in ACTION_SETS:
            for mask in ("info", "observation", "appended"):
                if mask != "info" and actions not in ("low", "low_discrete"):
                    continue
                with self.subTest(f"{actions} {mask}"), warnings.catch_warnings():
                    warnings.simplefilter("error")
                    self.check(**of_set(actions), mask=mask)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            max_cycles_test(types.SimpleNamespace(
                env=lambda max_cycles: parallel_to_aec(self.make(max_cycles=max_cycles)),
                parallel_env=lambda max_cycles: self.make(max_cycles=max_cycles)))
        with contextlib.redirect_stdout(io.StringIO()):
            render_test(lambda render_mode: parallel_to_aec(self.make(render_mode=render_mode)))

    def check(self, **config):
        # The test passes the unknown option "options", which must warn.
        warnings.filterwarnings("ignore", ".*option 'options' is unknown")
        parallel_api_test(self.make(**config), 1000)
        parallel_seed_test(lambda: self.make(**config))
        # It prefers Box and Discrete, which "low" and "hfo" are not, nor mask="observation".
        warnings.filterwarnings("ignore", ".*space for each agent probably should be")
        warnings.filterwarnings("ignore", "Observation is not a NumPy array")
        with contextlib.redirect_stdout(io.StringIO()):
            api_test(parallel_to_aec(self.make(**config)), 1000)

    def test_episode_over_dictionaries(self):
        env = self.make(actions="low_discrete", mask="observation", max_cycles=25)
        observations, infos = env.reset(seed=1)
        self.assertEqual(set(observations), set(env.possible_agents))
        self.assertEqual({agent.split("_")[0] for agent in env.possible_agents},
                         {"left", "right"})
        self.assertIs(env.action_space("left_11"), env.action_space("left_11"))
        self.assertIn(env.state(), env.state_space)
        steps = 0
        while env.agents:
            for agent in env.agents:
                self.assertIn(observations[agent], env.observation_space(agent))
            actions = {agent: env.action_space(agent).sample(observations[agent]["action_mask"])
                       for agent in env.agents}
            observations, rewards, terminations, truncations, infos = env.step(actions)
            steps += 1
        self.assertLessEqual(steps, 25)
        for result in (observations, rewards, terminations, truncations, infos):
            self.assertEqual(set(result), set(env.possible_agents))
        self.assertTrue(all(terminations.values()) or all(truncations.values()))
        self.assertRaises(cls_gym.ResetNeeded, env.step, {})
        env.reset(seed=1)
        self.assertRaisesRegex(cls_gym.ActionError, "left_11", env.step, {})
        env.close()
        env.close()


if __name__ == "__main__":
    unittest.main()
