"""What tests of adapters share: frameworks by name, worlds, examples, and speeds for the table."""
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

import cls_gym
from cls_gym._api import old_gymnasium

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/training/frameworks"
SPEEDS = os.environ.get("CLS_ADAPTERS_SPEEDS")
#: What is measured, with random but constant actions.
TASK = {"task": "cls/HFO-2v1-v0", "features": "ego", "actions": "low_discrete"}
WORLDS = 64
os.environ.setdefault("RAY_AUTH_MODE", "disabled")  # else it writes a token into the home
warnings.filterwarnings("ignore")
# Frameworks leave things where they are imported, PufferLib a link to its package: not in the tree.
FOLDER = tempfile.TemporaryDirectory()
os.chdir(FOLDER.name)


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

    def run_example(self, file, *arguments, seconds=1800):
        """The output of an example of at most 40 lines, blank ones aside. `seconds` is for a program
        that hangs: it needs two minutes of a processor at most, which a busy machine may stretch."""
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
