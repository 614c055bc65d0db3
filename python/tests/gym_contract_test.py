"""What frameworks rely on: copies that travel, and errors that name keywords."""
import copy
import multiprocessing
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest
import warnings

import gym_support  # first: may hide gymnasium
import numpy as np
from gym_support import ACTION_SETS, differences, of_set, seeded_actions

import cls_gym
from cls_gym import _config, _engine, _history
from cls_gym.selfplay import SelfPlay

HFO = "cls/HFO-1v0-v0"
FOLDER = pathlib.Path(cls_gym.__file__).resolve().parents[1]


def sent(value):
    """A copy by way of bytes."""
    return pickle.loads(pickle.dumps(value))


def elsewhere(work, value):
    """The result of a function in a new process; `value` and the result travel as bytes."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(work, (value,))


def play_on(env, seed=8, count=30, resets=False):
    """What the next steps return, of a single world until its end or with resets."""
    out = []
    for action in seeded_actions(copy.deepcopy(env.action_space), seed, count):
        out.append(env.step(action))
        if not hasattr(env, "num_envs") and (out[-1][2] or out[-1][3]):
            if not resets:
                break
            out.append(env.reset())
    return out


def play_snapshot(snapshot):
    """Continues a snapshot in an environment of its own that has played something else."""
    with cls_gym.Env("cls/HFO-2v2-v0", actions="low_discrete") as env:
        env.reset(seed=77)
        decoy = env.snapshot()  # has the number that the snapshot's had in its process
        env.step(env.action_space.sample())
        first = env.restore(snapshot)
        result = first, play_on(env)
        del decoy
        return result


class Snapshots(unittest.TestCase):
    def begun(self, *config, steps=25, **named):
        env = cls_gym.Env(*config, **named)
        self.addCleanup(env.close)
        env.reset(seed=4, options={"difficulty": 0.5})
        for action in seeded_actions(env.action_space, 1, steps):
            if any(env.step(action)[2:4]):
                env.reset()
        return env

    def test_another_process_continues_the_same_episode(self):
        env = self.begun("cls/HFO-2v2-v0", actions="low_discrete")
        snapshot = env.snapshot()
        first, rest = elsewhere(play_snapshot, snapshot)
        self.assertEqual(differences(env.restore(snapshot), first), [])
        self.assertEqual(differences(play_on(env), rest), [])

    def test_every_action_set_and_what_players_know_travel(self):
        for config in ([of_set(one) for one in ACTION_SETS]
                       + [{"actions": "hfo", "obs": "world_model"}]):
            with self.subTest(config):
                env = self.begun("cls/HFO-2v1-v0", **config)
                snapshot = sent(env.snapshot())
                with cls_gym.Env("cls/HFO-2v1-v0", **config) as other:
                    other.reset(seed=1)
                    other.restore(snapshot)
                    self.assertEqual(differences(play_on(env), play_on(other)), [])

    def test_one_world_of_many_receives_it_and_the_others_stay(self):
        env = self.begun(HFO, actions="low_discrete")
        snapshot = sent(env.snapshot())
        rest = [env.step(action)[:4] for action in (9, 12, 40)]
        for mode in ("next_step", "same_step", "disabled"):
            with self.subTest(mode), cls_gym.VectorEnv(
                    HFO, 3, actions="low_discrete", autoreset_mode=mode) as envs, \
                    cls_gym.VectorEnv(HFO, 3, actions="low_discrete", autoreset_mode=mode) as same:
                for one in (envs, same):
                    one.reset(seed=3)
                    for _ in range(7):
                        one.step(np.array([9, 9, 9]))
                envs.restore(1, snapshot)
                np.testing.assert_array_equal(envs.agent_rewards[[0, 2]],
                                              same.agent_rewards[[0, 2]])
                for action, expected in zip((9, 12, 40), rest):
                    got = envs.step(np.full(3, action))
                    self.assertEqual(differences(expected[0], got[0][1]), [])
                    other = same.step(np.full(3, action))
                    for index in (0, 2):
                        self.assertEqual(differences(other[0][index], got[0][index]), [])

    def test_snapshots_of_snapshots_and_forks_travel(self):
        with cls_gym.VectorEnv(HFO, 2, actions="low_discrete") as envs:
            envs.reset(seed=2)
            for number in range(5):
                envs.step(np.array([9, 20 + number]))
            first = envs.snapshot(1)
            envs.step(np.array([1, 2]))
            envs.restore(0, first)
            envs.step(np.array([3, 4]))
            envs.fork(0, [1])
            envs.step(np.array([30, 31]))
            last = [sent(envs.snapshot(index)) for index in range(2)]
            rest = play_on(envs, count=10)
            with cls_gym.VectorEnv(HFO, 2, actions="low_discrete") as other:
                for index, snapshot in enumerate(last):
                    other.restore(index, snapshot)
                for expected, got in zip(rest, play_on(other, count=10)):
                    self.assertEqual(differences(expected[:4], got[:4]), [])

    def test_a_copy_is_the_same_snapshot(self):
        snapshot = self.begun(HFO).snapshot()
        self.assertIs(copy.deepcopy(snapshot), snapshot)
        self.assertIs(copy.copy(snapshot), snapshot)
        twice = sent(sent(snapshot))
        self.assertEqual(twice.episode.mark, snapshot.episode.mark)
        self.assertEqual(twice.episode.steps, 25)

    def test_differences_of_settings_and_engines_are_said(self):
        snapshot = self.begun(HFO, actions="low_discrete").snapshot()
        with cls_gym.Env(HFO, actions="skills") as env:
            env.reset(seed=1)
            with self.assertRaisesRegex(cls_gym.EngineError, "='low_discrete', here 'skills'"):
                env.restore(snapshot)
            self.assertRaises(TypeError, env.restore, 3)
        with cls_gym.Env(HFO, actions="low_discrete") as env:
            before, _ = env.reset(seed=1)
            foreign = sent(snapshot)
            foreign._engine = "0.0.1 abc"
            with warnings.catch_warnings(record=True) as found:
                warnings.simplefilter("always")
                env.restore(foreign)
            self.assertIn("0.0.1 abc", str(found[0].message))
            env.reset(seed=1)
            foreign = sent(snapshot)
            foreign._engine = "0.0.1 abc"
            foreign._episode = foreign._episode._replace(mark=1)
            with self.assertRaisesRegex(cls_gym.EngineError, "differently from .*0.0.1 abc"):
                env.restore(foreign)
            with cls_gym.Env(HFO, actions="low_discrete") as other:  # nothing has changed
                other.reset(seed=1)
                self.assertEqual(differences(play_on(env), play_on(other)), [])

    def test_an_ended_episode_stays_ended_where_it_can(self):
        env = cls_gym.Env(HFO, actions="low_discrete", max_cycles=3)
        self.addCleanup(env.close)
        env.reset(seed=1)
        for _ in range(3):
            env.step(9)
        snapshot = sent(env.snapshot())
        with cls_gym.Env(HFO, actions="low_discrete", max_cycles=3) as other:
            other.restore(snapshot)
            self.assertRaises(cls_gym.ResetNeeded, other.step, 9)
        with cls_gym.VectorEnv(HFO, 2, actions="low_discrete", max_cycles=3,
                               autoreset_mode="same_step") as envs:
            envs.reset(seed=1)
            self.assertRaisesRegex(cls_gym.EngineError, "ended", envs.restore, 0, snapshot)

    def test_a_recording_is_not_played_again(self):
        snapshot = sent(self.begun(HFO).snapshot())
        with tempfile.TemporaryDirectory() as folder, cls_gym.Env(HFO) as env:
            env.record(os.path.join(folder, "a.rcg"))
            env.reset(seed=1)
            self.assertRaisesRegex(cls_gym.EngineError, "recorded", env.restore, snapshot)
            env.record(None)
            env.restore(snapshot)

    def test_long_histories_are_kept_and_too_long_ones_are_refused(self):
        self.addCleanup(setattr, _history, "_BLOCK", _history._BLOCK)
        self.addCleanup(setattr, _history, "LIMIT", _history.LIMIT)
        _history._BLOCK = 1  # 16 rows a block
        for limit, travels in ((1 << 20, True), (32, False)):
            _history.LIMIT = limit
            with self.subTest(limit), cls_gym.VectorEnv("cls/Match-v0", 2, actions="low_discrete",
                                                        opponent="hold") as envs:
                envs.reset(seed=1)
                for action in seeded_actions(envs.action_space, 1, 100):
                    envs.step(action)
                snapshot = envs.snapshot(0)
                if travels:
                    rest = play_on(sent(envs), count=5)
                    self.assertEqual(differences(play_on(envs, count=5), rest), [])
                else:
                    self.assertRaisesRegex(cls_gym.EngineError, "remembers", pickle.dumps, snapshot)
                    self.assertRaisesRegex(cls_gym.EngineError, "remembers", pickle.dumps, envs)
                    envs.restore(1, snapshot)
                    self.assertLessEqual(len(envs._worlds.history._blocks), 2)


def continue_environment(env):
    """What a received environment plays."""
    return play_on(env, resets=True), env.reset()


class Environments(unittest.TestCase):
    def test_copies_continue_with_the_same_bits(self):
        for actions in ("low", "low_flat", "low_discrete"):
            for steps in (0, 13):
                with self.subTest(f"{actions} {steps}"), cls_gym.Env(
                        "cls/HFO-2v1-v0", actions=actions, max_cycles=20) as env:
                    env.reset(seed=5, options={"difficulty": 0.25})
                    for action in seeded_actions(env.action_space, 1, steps):
                        if any(env.step(action)[2:4]):
                            env.reset()
                    copies = [sent(env), copy.deepcopy(env)]
                    expected = continue_environment(env)
                    sample = env.action_space.sample()
                    for other in copies:
                        self.assertEqual(differences(expected, continue_environment(other)), [])
                        self.assertEqual(differences(sample, other.action_space.sample()), [])
                        other.close()

    def test_another_process_continues_vectors(self):
        for mode in ("next_step", "same_step", "disabled"):
            with self.subTest(mode), cls_gym.VectorEnv(
                    HFO, 5, autoreset_mode=mode, max_cycles=35, actions="low_discrete",
                    opponent={"hold": 1, "scripted": 1}) as envs:
                envs.reset(seed=5, options={"difficulty": 0.25})
                ended = np.zeros(5, np.bool_)
                for action in seeded_actions(envs.action_space, 1, 60):
                    if mode == "disabled" and ended.any():
                        envs.reset(options={"reset_mask": ended})
                    step = envs.step(action)
                    ended = step[2] | step[3]
                if mode == "disabled" and ended.any():
                    envs.reset(options={"reset_mask": ended})
                count = 30 if mode != "disabled" else 1
                other = sent(envs)
                np.testing.assert_array_equal(envs.agent_rewards, other.agent_rewards)
                self.assertEqual(differences(play_on(envs, count=count),
                                             play_on(other, count=count)), [])
                self.assertEqual(differences(envs.reset(), other.reset()), [])
                other.close()

    def test_every_class_travels_or_says_why_not(self):
        fresh = sent(cls_gym.Env(HFO))  # not begun
        self.assertRaises(cls_gym.ResetNeeded, fresh.step, fresh.action_space.sample())
        closed = cls_gym.Env(HFO)
        closed.close()
        self.assertRaises(cls_gym.ClosedEnvironmentError, sent(closed).reset)

        class Own(cls_gym.Env):
            """Of the caller, with an attribute."""

        own = Own(HFO)
        own.note = "kept"
        self.assertEqual(copy.deepcopy(own).note, "kept")

        worlds = SelfPlay(zeros, 3)
        worlds.reset(1)
        worlds.step(np.ones((3, 2), np.int64))
        other = sent(worlds)
        for _ in range(5):
            self.assertEqual(differences(worlds.step(np.ones((3, 2), np.int64)),
                                         other.step(np.ones((3, 2), np.int64))), [])

        from cls_gym.hfo import HIGH_LEVEL_FEATURE_SET, NOOP, HFOEnvironment
        hfo = HFOEnvironment(seed=1)
        hfo.connectToServer(HIGH_LEVEL_FEATURE_SET)
        hfo.act(NOOP)
        hfo.step()
        other = sent(hfo)
        self.assertEqual(hfo.step(), other.step())
        self.assertEqual(differences(hfo.getState(), other.getState()), [])

        from cls_gym.league import League
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(sent(League(folder, offense=3)).config["offense"], 3)

        from cls_gym.match import MatchEnv
        env = MatchEnv.__new__(MatchEnv)
        self.assertRaisesRegex(TypeError, "MatchEnv", pickle.dumps, env)
        self.assertRaisesRegex(TypeError, "MatchEnv", copy.deepcopy, env)
        env._closed = True

    def test_parallel_environments_travel(self):
        try:
            import pettingzoo  # noqa: F401
        except ImportError:
            self.skipTest("no pettingzoo: pip install pettingzoo")
        env = cls_gym.ParallelEnv("cls/HFO-2v2-v0", agents="both", actions="low_discrete")
        env.reset(seed=1)
        for _ in range(4):
            env.step({agent: 9 for agent in env.agents})
        for other in (sent(env), copy.deepcopy(env)):
            self.assertEqual(other.agents, env.agents)
        for _ in range(4):
            actions = {agent: 12 for agent in env.agents}
            self.assertEqual(differences(env.step(actions), other.step(actions)), [])

    def test_gymnasium_wrappers_travel_with_it(self):
        try:
            import gymnasium
        except ImportError:
            self.skipTest("no gymnasium: pip install gymnasium")
        env = gymnasium.make(HFO, actions="low_discrete")
        env.reset(seed=1)
        env.step(9)
        other = sent(env)
        self.assertEqual(other.spec, env.spec)
        self.assertEqual(differences(env.step(10), other.step(10)), [])


def zeros(observations, masks):
    """A policy."""
    return np.zeros(len(observations), np.int64)


class Keywords(unittest.TestCase):
    def makers(self):
        return [cls_gym.Env, cls_gym.VectorEnv]

    def test_unknown_ones_are_type_errors_that_name_the_nearest(self):
        for make in self.makers():
            for keyword, hint in (("obss", "obs"), ("id", "task"), ("opponents", "opponent"),
                                  ("feature", "features"), ("masks", "mask"),
                                  ("autoreset", "autoreset_mode"), ("zzz", "frame_skip")):
                with self.subTest(f"{make.__name__} {keyword}"):
                    with self.assertRaisesRegex(TypeError, f"{make.__name__}: unknown keyword "
                                                f"{keyword}='x'; .*{hint}") as caught:
                        make(**{keyword: "x"})
                    self.assertIsInstance(caught.exception, ValueError)
                    self.assertIsInstance(caught.exception, cls_gym.ConfigError)
        for keyword in ("num_envs", "autoreset_mode", "copy"):  # once played without a word
            with self.assertRaisesRegex(TypeError, "VectorEnv has it"):
                cls_gym.Env(HFO, **{keyword: 3})

    def test_list_is_that_of_the_engine(self):
        try:
            _engine.Pool({"task": "HalfFieldOffense", "num_envs": 1, "zzzzzzzzzz": 1})
        except cls_gym.ConfigError as error:
            known = str(error).partition("known: ")[2].rstrip(")").split(", ")
        self.assertEqual(set(known), {*_config.KEYWORDS, "task", "num_envs", "autoreset"})

    def test_values_are_value_errors_with_keyword_value_and_nearest(self):
        for config, texts in (
                ({"obs": "ful_state"}, ("obs: ", "'ful_state'", "'full_state'")),
                ({"features": "eg"}, ("features: ", "'eg'", "'ego'")),
                ({"actions": "low_discret"}, ("actions: ", "'low_discret'", "'low_discrete'")),
                ({"agents": "bth"}, ("agents: ", "'bth'", "'both'")),
                ({"opponent": {"mok": 1}}, ("opponent.mok: ", "'mok'", "'mock'")),
                ({"reward": {"gaol": 1}}, ("reward.gaol: ", "'gaol'", "'goal'")),
                ({"reward": {"goal": float("nan")}}, ("reward.goal: ", "nan", "finite")),
                ({"reward": {"goal": [object()]}}, ("reward.goal: ", "object", "number")),
                ({"options": {"dificulty": 1}}, ("options.dificulty: ", "'difficulty'")),
                ({"opponent": {"mock", "hold"}}, ("opponent: ", "set", "dictionary")),
                ({"frame_skip": 0}, ("frame_skip: ", "0", "1 to 100")),
                ({"offense": 99}, ("offense: ", "99", "0 to 11")),
                ({"mask": "observations"}, ("mask: ", "'observations'", "'observation'")),
                ({"mask": "appended", "actions": "low_flat"}, ("mask: ", "'low_flat'", "'info'")),
                ({"render_mode": "rgb"}, ("render_mode: ", "'rgb'", "rgb_array")),
                ({"task": "cls/HFO-1v00-v0x"}, ("task: ", "'cls/HFO-1v00-v0x'", "cls/HFO-1v")),
                ({"task": 3}, ("task: ", "3", "cls/HFO-1v0-v0")),
                ({"agents": "both"}, ("agents: ", "'both'", "'offense'"))):
            with self.subTest(config), self.assertRaises(ValueError) as caught:
                cls_gym.Env(**config)
            for text in texts:
                self.assertIn(text, str(caught.exception))
            self.assertNotIsInstance(caught.exception, TypeError)
            self.assertNotIn("configuration:", str(caught.exception))
        with cls_gym.Env(HFO) as env:
            with self.assertRaisesRegex(ValueError, "^difficulty: 7 is not within 0 to 1"):
                env.reset(seed=1, options={"difficulty": 7})
            self.assertRaisesRegex(TypeError, "options: a dictionary", env.reset, options="x")

    def test_numbers_of_numpy_are_numbers(self):
        with cls_gym.Env("cls/HalfFieldOffense-v0", offense=np.int64(2),
                         reward={"goal": np.float32(2.0)}) as env:
            self.assertEqual(env.num_agents, 2)
            env.reset(seed=1, options={"difficulty": np.float32(0.5)})

    def test_agents_of_both_teams_have_defaults(self):
        for task in cls_gym.ids():
            for agents in ("both", "defense"):
                try:
                    env = cls_gym.Env(task, agents=agents)
                except cls_gym.ConfigError as error:
                    self.assertRegex(str(error), "needs players of the defense")
                    self.assertRegex(task, "1v0|HalfFieldOffense|ReachBall|EmptyGoal")
                    continue
                with self.subTest(f"{task} {agents}"), env:
                    self.assertNotEqual(env.spec_of_task.feature_set, "hfo_low")
                    env.reset(seed=1)
        with cls_gym.Env("cls/HFO-2v2-v0", agents="both") as env:
            self.assertEqual(env.spec_of_task.feature_set, "ego")
        with cls_gym.Env("cls/HFO-2v2-v0") as env:  # as ever
            self.assertEqual(env.spec_of_task.feature_set, "hfo_low")


class OldGymnasium(unittest.TestCase):
    """A Gymnasium without what cls_gym needs is an error, never another class without a word."""

    PROGRAM = "\n".join((
        "import gymnasium, cls_gym",
        "assert cls_gym.ids()",
        "for make in (cls_gym.Env, cls_gym.VectorEnv, cls_gym.make_env, cls_gym.make_vector_env):",
        "    try:",
        "        make(task='cls/HFO-1v0-v0')",
        "    except ImportError as error:",
        "        print(error)"))

    def test_one_line_says_which_is_needed(self):
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder) / "gymnasium"
            (package / "envs").mkdir(parents=True)
            (package / "__init__.py").write_text("__version__ = '0.29.1'\n")
            (package / "envs/__init__.py").write_text("")
            (package / "envs/registration.py").write_text(
                "registry = {}\ndef register(*_, **__): 0\n")
            path = os.pathsep.join(filter(None, [folder, str(FOLDER),
                                                 os.environ.get("PYTHONPATH")]))
            done = subprocess.run([sys.executable, "-c", self.PROGRAM], text=True, check=False,
                                  env={**os.environ, "PYTHONPATH": path}, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 4)
        for line in lines:
            self.assertRegex(line, "Gymnasium 0.29.1 is too old, 1.1 or later is needed: pip ")


if __name__ == "__main__":
    unittest.main()
