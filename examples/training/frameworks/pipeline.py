"""Two groups of worlds: one steps in a thread while the policy decides for the other.

    pip install FILE; python3 pipeline.py
"""
import time

import numpy as np

import cls_gym

worlds = cls_gym.Pipeline("cls/Match-v0", num_envs=64, groups=2, actions="low_discrete")
weights = [np.random.default_rng(1).normal(size=shape).astype(np.float32)
           for shape in ((241, 256), (256, 256), (256, 81))]
worlds.async_reset(seed=1)
started, steps = time.perf_counter(), 0
while steps < 64 * 100:
    observations, rewards, terminations, truncations, infos = worlds.recv()
    values = np.tanh(np.tanh(observations @ weights[0]) @ weights[1]) @ weights[2]
    actions = np.where(infos["action_mask"] != 0, values, -np.inf).argmax(axis=-1)
    worlds.send(actions, infos["env_id"])
    steps += len(infos["env_id"])
print(f"{steps / (time.perf_counter() - started):.0f} world steps/s")
worlds.close()
