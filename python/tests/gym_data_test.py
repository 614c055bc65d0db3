"""Recorded episodes, what reads them, and recording on a cluster of Ray."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import warnings

import gym_support  # first: may hide gymnasium
import numpy as np
from gym_adapter_support import EXAMPLES, needs

import cls_gym
from cls_gym import data

TASK = {"task": "cls/HFO-2v1-v0", "features": "ego", "actions": "low_discrete", "max_cycles": 25}
warnings.filterwarnings("ignore")
del gym_support


def worlds(count=3, **config):
    return cls_gym.VectorEnv(num_envs=count, autoreset_mode="disabled", **{**TASK, **config})


def policy(observations, masks):
    """Legal ids that depend on the observation alone."""
    values = np.abs(observations).sum(axis=1, keepdims=True) * np.arange(1, masks.shape[1] + 1)
    return np.where(masks != 0, values % 7.0, -1.0).argmax(axis=1)


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


@needs("pyarrow")
class Records(Folder):
    def test_an_episode_is_that_of_its_seed(self):
        self.assertEqual(data.record(worlds(), policy, 7, self.folder, seed=40), 7)
        names = [path.name for path in data.files(self.folder)]
        self.assertEqual(names, [f"{number:08d}.arrow" for number in range(7)])
        for number in (0, 5):
            one = data.load(self.folder / names[number])
            self.assertEqual((one["about"]["seed"], one["about"]["episode"]), (40 + number, number))
            with cls_gym.Env(**TASK) as env:
                seen, info = env.reset(seed=40 + number)
                for step in range(len(one["action"])):
                    np.testing.assert_array_equal(one["observation"][step], seen)
                    np.testing.assert_array_equal(one["state"][step], env.state())
                    np.testing.assert_array_equal(one["mask"][step], info["action_mask"])
                    np.testing.assert_array_equal(one["action"][step],
                                                  policy(seen, info["action_mask"]))
                    seen, _, terminated, truncated, info = env.step(one["action"][step].astype(int))
                    np.testing.assert_array_equal(one["reward"][step], env.agent_rewards)
                    self.assertEqual((one["terminated"][step], one["truncated"][step]),
                                     (terminated, truncated))
                self.assertTrue(terminated or truncated)
                np.testing.assert_array_equal(one["observation"][-1], seen)
                np.testing.assert_array_equal(one["state"][-1], env.state())
                self.assertEqual(one["about"]["status"], env.spec_of_task.statuses[info["status"]])

    def test_what_is_there_stays_and_the_number_of_worlds_does_not_matter(self):
        data.record(worlds(5), policy, 6, self.folder)
        first = {path.name: path.read_bytes() for path in data.files(self.folder)}
        (self.folder / "00000002.arrow").unlink()
        (self.folder / "00000004.arrow").unlink()
        self.assertEqual(data.record(worlds(1), policy, 8, self.folder), 4)
        for name, content in first.items():
            self.assertEqual((self.folder / name).read_bytes(), content, name)
        self.assertEqual(len(list(self.folder.iterdir())), 8)  # nothing unfinished

    def test_numbers_and_labels(self):
        data.record(worlds(actions="low_flat"), lambda seen, _: np.tanh(seen[:, :10]), 2,
                    self.folder / "numbers")
        one = data.load(self.folder / "numbers/00000001.arrow")
        self.assertEqual((one["action"].shape[1:], one["action"].dtype), ((2, 10), np.float32))
        self.assertNotIn("mask", one)
        data.record(worlds(), policy, 1, self.folder / "labels",
                    expert=lambda seen, masks: np.full(len(seen), 9))
        self.assertEqual(set(data.load(self.folder / "labels/00000000.arrow")["expert"].flat), {9})

    def test_refusals(self):
        for config, text in (({"autoreset_mode": "same_step"}, "needs 'disabled'"),
                             ({"actions": "low"}, "record.. has no actions that are tuples"),
                             ({"mask": "appended"}, "column of its own")):
            envs = cls_gym.VectorEnv(**{**TASK, "autoreset_mode": "disabled", **config})
            with self.assertRaisesRegex(cls_gym.ConfigError, text):
                data.record(envs, policy, 1, self.folder)


@needs("pyarrow", "polars", "pandas", "duckdb")
class OneLiners(Folder):
    def test_lines_of_the_guide_run(self):
        """Each line of the block reads all rows of the folder "episodes"."""
        guide = pathlib.Path(__file__).resolve().parents[2] / "docs/training.md"
        block = guide.read_text("utf-8").partition("<!-- readers -->")[2]
        lines = [line for line in block.partition("```python\n")[2].partition("```")[0].splitlines()
                 if line]
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        data.record(worlds(), policy, 4, "episodes")
        names = {}
        for line in lines:
            exec(line, names)
        rows = sum(len(data.load(path)["observation"]) for path in data.files("episodes"))
        self.assertEqual({int(names[name]) for name in ("a", "b", "c")}, {rows})


@needs("pyarrow", "minari", "gymnasium", "h5py")
class Minari(Folder):
    def test_dataset_loads_and_its_environment_recovers(self):
        import minari
        data.record(worlds(), policy, 5, self.folder / "episodes", seed=3)
        before = os.environ.get("MINARI_DATASETS_PATH")
        os.environ["MINARI_DATASETS_PATH"] = str(self.folder / "minari")
        self.addCleanup(lambda: os.environ.pop("MINARI_DATASETS_PATH") if before is None else
                        os.environ.update(MINARI_DATASETS_PATH=before))
        data.to_minari(self.folder / "episodes", "cls/hfo-2v1/test-v0", author="a")
        dataset = minari.load_dataset("cls/hfo-2v1/test-v0")
        self.assertEqual(dataset.total_episodes, 5)
        episode = dataset[2]
        one = data.load(self.folder / "episodes/00000002.arrow")
        np.testing.assert_array_equal(episode.observations, one["observation"])
        np.testing.assert_array_equal(episode.actions, one["action"])
        env = dataset.recover_environment()
        seen, _ = env.reset(seed=5)
        np.testing.assert_array_equal(seen, one["observation"][0])
        self.assertIn(episode.actions[0], env.action_space)
        (self.folder / "none").mkdir()
        with self.assertRaisesRegex(cls_gym.ConfigError, "no episodes"):
            data.to_minari(self.folder / "none", "cls/none-v0")


@needs("pyarrow", "ray")
class RayCluster(Folder):
    def setUp(self):
        super().setUp()
        from ray.cluster_utils import Cluster
        paths = [str(pathlib.Path(cls_gym.__file__).parents[1]), os.environ.get("PYTHONPATH")]
        self.environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
        os.environ.update(PYTHONPATH=self.environment["PYTHONPATH"])  # of the node processes
        cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
        self.addCleanup(cluster.shutdown)
        cluster.add_node(num_cpus=1)
        self.environment["RAY_ADDRESS"] = cluster.address

    def start(self, example, *arguments):
        return subprocess.Popen([sys.executable, str(EXAMPLES / example), *arguments], text=True,
                                env=self.environment, stdout=subprocess.PIPE)

    def finished(self, process, count):
        """The episodes that are there when `count` are, or the process has ended."""
        while len(data.files(self.folder)) < count and process.poll() is None:
            time.sleep(0.02)
        self.assertGreaterEqual(len(data.files(self.folder)), count)
        return {path: path.read_bytes() for path in data.files(self.folder)}

    def assert_kept(self, finished):
        for path, content in finished.items():
            self.assertEqual(path.read_bytes(), content)
            data.load(path)

    def test_two_nodes_record_and_a_killed_program_loses_no_finished_episode(self):
        with self.start("ray_record.py", str(self.folder), "80") as first:
            self.finished(first, 5)
            first.kill()
        finished = {path: path.read_bytes() for path in data.files(self.folder)}
        with self.start("ray_record.py", str(self.folder), "80") as again:
            out, _ = again.communicate(timeout=300)
        self.assertIn("80 episodes from 2 nodes", out)
        self.assert_kept(finished)

    def test_a_killed_actor_loses_no_finished_episode_and_the_others_go_on(self):
        with self.start("ray_actors.py", str(self.folder), "160") as program:
            part, node, victim = program.stdout.readline().split()
            before = {path.name: path.stat().st_mtime_ns for path in data.files(self.folder)}
            finished = self.finished(program, len(before))
            os.kill(int(victim), signal.SIGKILL)
            out, _ = program.communicate(timeout=300)
        self.assertEqual(program.returncode, 0)
        self.assertIn("160 episodes\n", out)
        lines = [line.split() for line in out.splitlines()  # others are Ray's
                 if re.fullmatch(r"\d+ \w+ \d+", line)]
        self.assertEqual({int(first) for first, *_ in [[part], *lines]}, set(range(0, 160, 20)))
        processes = {process for *_, process in lines}
        self.assertGreaterEqual(len({one for _, one, _ in lines} | {node}), 2, "both nodes play")
        self.assertGreaterEqual(len(processes - {victim}), 2, "the victim was started again")
        self.assert_kept(finished)
        for name, written in before.items():
            self.assertEqual((self.folder / name).stat().st_mtime_ns, written, name)


if __name__ == "__main__":
    unittest.main()
