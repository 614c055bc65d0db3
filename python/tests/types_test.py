"""mypy --strict of cls_gym, and of a user's program that uses it."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PYTHON = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = '''
from __future__ import annotations

from typing import Any, Dict, List

import cls_gym
import numpy as np
from cls_gym.policy import Policy
from cls_gym.selfplay import SelfPlay


def rollout(envs: cls_gym.VectorEnv, steps: int) -> float:
    observations, infos = envs.reset(seed=1)
    total = 0.0
    for _ in range(steps):
        actions = envs.action_space.sample(infos["action_mask"])
        observations, rewards, terminations, truncations, infos = envs.step(actions)
        total += float(rewards.sum())
    return total


def evaluate(policy: Policy, options: Dict[str, Any]) -> np.ndarray:
    with cls_gym.Env("cls/HFO-1v0-v0", **options) as env:
        observation, info = env.reset(seed=1)
        snapshot: cls_gym.Snapshot = env.snapshot()
        world: cls_gym.World = env.view()
        world.ball_x = 30.0
        env.set_state(world)
        env.restore(snapshot)
        action = policy.act(observation, info["action_mask"])
        observation, reward, terminated, truncated, info = env.step(action)
        names: List[str] = [feature.name for feature in env.spec_of_task.features]
        return np.zeros(len(names) + int(reward))


worlds = SelfPlay(lambda seen, mask: mask.argmax(axis=1), num_envs=2)
print(rollout(cls_gym.VectorEnv("cls/HFO-1v0-v0", 4, actions="low_discrete"), 10))
'''


def mypy(folder, *arguments, **environment):
    return subprocess.run([sys.executable, "-m", "mypy", *arguments], cwd=folder, text=True,
                          capture_output=True, env={**os.environ, **environment}, check=False)


class Types(unittest.TestCase):
    # One cache for all: most of the time goes into NumPy's types.
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    def check_program(self, text):
        (self.folder / "program.py").write_text(text, "utf-8")
        return mypy(self.folder, "--strict", "program.py", MYPYPATH=str(PYTHON))

    def test_package(self):
        checked = mypy(PYTHON, "--cache-dir", str(self.folder / ".mypy_cache"), "-p", "cls_gym", PYTHONPATH="")
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)

    def test_program_of_a_user(self):
        checked = self.check_program(PROGRAM)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)

    def test_mistakes_of_a_user_are_found(self):
        for wrong, text in (("env.set_state(1)", '"int"; expected "World"'),
                            ("env.snapshot().steps", 'has no attribute "steps"')):
            checked = self.check_program(PROGRAM.replace("env.set_state(world)", wrong))
            self.assertIn(text, checked.stdout)


if __name__ == "__main__":
    unittest.main()
