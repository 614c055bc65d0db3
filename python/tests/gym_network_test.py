"""Policy files cls.policy/2: the same bits as the engine, files, refusals.

    python3 gym_network_test.py --write    # the files of fixtures/policies
"""
import os
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

from gym_support import differences  # noqa: F401  first: may hide gymnasium
import numpy as np

import cls_gym
from cls_gym import network, policy
from cls_gym.network import Network, PolicyError, Step

FIXTURES = pathlib.Path(__file__).resolve().parents[2] / "fixtures/policies"
FEATURES = 817  # of team/1, eleven against eleven
ROWS = 3


def observations():
    """float32[ROWS, FEATURES], as tests/training/policy_test.cpp makes them."""
    index = np.arange(ROWS * FEATURES) * 37 % 101 - 50
    return (index.astype(np.float32) / np.float32(50)).reshape(ROWS, FEATURES)


def about():
    with cls_gym.VectorEnv("cls/Match-v0", 1, obs="world_model", features="team",
                           actions="options") as envs:
        return policy.describe(envs)


def all_kinds(of):
    """A network with every kind of step and random weights."""
    random = np.random.default_rng(5)

    def weights(*shapes):
        return [random.normal(0, shape[0] ** -0.5, shape).astype(np.float32) for shape in shapes]

    steps = [Step("own", "columns", ["features"], 0, 1, 54),
             Step("scaled", "norm", ["own"], weights=weights((54,), (54,))),
             Step("mates", "columns", ["features"], 54, 10, 15),
             Step("mate_parts", "dense", ["mates"], width=7, activation="relu",
                  weights=weights((15, 7), (7,))),
             Step("team", "pool", ["mate_parts", "mates"]),
             Step("both", "concat", ["scaled", "team"]),
             Step("memory", "gru", ["both"], width=9,
                  weights=weights((68, 27), (27,), (9, 27), (27,))),
             Step("joined", "concat", ["mate_parts", "memory"]),
             Step("flat", "flatten", ["joined"]),
             Step("hidden", "dense", ["flat"], width=5, activation="tanh",
                  weights=weights((160, 5), (5,))),
             Step("scores", "dense", ["hidden"], width=84, weights=weights((5, 84), (84,)))]
    return Network(steps, dict(of, decides="ball"))


def exact(net):
    """The scores of one player that observes the rows one after the other."""
    memory = {}
    return np.array([net.exact_scores(row, memory) for row in observations()])


class Networks(unittest.TestCase):
    def test_bits_are_those_of_the_engine(self):
        net = network.load(FIXTURES / "all_kinds.policy")
        stored = np.fromfile(FIXTURES / "all_kinds.scores", "<f4").reshape(ROWS, 84)
        scores = exact(net)
        self.assertEqual(scores.tobytes(), stored.tobytes())
        self.assertGreater(np.abs(scores[1] - scores[0]).max(), 1e-3)
        memory = {}
        fast = [net.scores(row, memory) for row in observations()]
        np.testing.assert_allclose(fast, scores, rtol=1e-4, atol=1e-5)

    def test_files_come_back_as_they_were(self):
        net = all_kinds(about())
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "net.policy")
            net.save(path)
            again = network.load(path)
            self.assertEqual(again.about, net.about)
            self.assertEqual(again.scores(observations()).tobytes(),
                             net.scores(observations()).tobytes())
            masks = np.zeros((ROWS, 84), np.int8)
            masks[:, [3, 70]] = 1
            self.assertTrue(np.isin(again.act(observations(), masks), (3, 70)).all())
            with self.assertRaisesRegex(PolicyError, "cls_gym.network.load reads it"):
                policy.load(path)

    def test_a_policy_of_layers_becomes_steps(self):
        random = np.random.default_rng(2)
        layers = [(random.normal(0, 0.05, (FEATURES, 12)), random.normal(0, 1, 12)),
                  (random.normal(0, 1, (12, 84)), random.normal(0, 1, 84))]
        plain = policy.Policy(layers, about())
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "plain.policy")
            plain.network().save(path)
            again = network.load(path)
        np.testing.assert_allclose(again.scores(observations()), plain.scores(observations()),
                                   atol=1e-5)

    def test_interrupted_saves_leave_the_file_as_it_was(self):
        plain = policy.Policy([(np.ones((FEATURES, 84)), np.ones(84))], about())
        for saved in (all_kinds(about()), plain):
            with tempfile.TemporaryDirectory() as folder:
                file, link = pathlib.Path(folder, "net.policy"), pathlib.Path(folder, "link")
                file.write_bytes(b"hours of training")
                link.symlink_to(file)
                with mock.patch("os.replace", side_effect=KeyboardInterrupt), \
                        self.assertRaises(KeyboardInterrupt):
                    saved.save(link)
                self.assertEqual(file.read_bytes(), b"hours of training")
                saved.save(link)
                self.assertTrue(link.is_symlink())
                self.assertNotEqual(file.read_bytes(), b"hours of training")
                self.assertEqual(sorted(os.listdir(folder)), ["link", "net.policy"])

    def test_failed_saves_name_the_file(self):
        with self.assertRaisesRegex(OSError, "No such file or directory: '/missing/net.policy'"):
            all_kinds(about()).save("/missing/net.policy")

    def test_devices_are_written_and_not_replaced(self):
        all_kinds(about()).save(os.devnull)
        self.assertFalse(pathlib.Path(os.devnull).is_file())

    def test_damaged_files_are_refused(self):
        content = (FIXTURES / "all_kinds.policy").read_bytes()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "net.policy")
            for damaged in (b"", content[:11], content[:-4], content + b"1234",
                            content.replace(b'"kind": "gru"', b'"kind": "gro"')):
                path.write_bytes(damaged)
                with self.assertRaises(PolicyError):
                    network.load(path)


if __name__ == "__main__":
    if "--write" in sys.argv:
        FIXTURES.mkdir(exist_ok=True)
        written = all_kinds(about())
        written.save(FIXTURES / "all_kinds.policy")
        exact(written).astype("<f4").tofile(FIXTURES / "all_kinds.scores")
    else:
        unittest.main()
