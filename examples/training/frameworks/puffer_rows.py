"""Worlds in PufferLib's buffers, here in two processes: pip install FILE pufferlib==3.0.0"""
import numpy as np
import pufferlib.vector

from cls_gym.adapters.pufferlib import PufferCls

if __name__ == "__main__":
    rows = pufferlib.vector.make(
        PufferCls, backend=pufferlib.vector.Multiprocessing, num_envs=2, num_workers=2,
        env_kwargs={"task": "cls/HFO-2v1-v0", "num_envs": 32, "features": "ego",
                    "actions": "skills", "frame_skip": 4})
    observations, _ = rows.reset(seed=1)
    ids = rows.single_action_space.n
    random = np.random.default_rng(1)
    goals = []
    for _ in range(200):
        legal = observations[:, -ids:]  # the mask is the end of a row
        actions = np.argmax(random.random(legal.shape) * legal, axis=1)
        observations, rewards, terminals, truncations, infos = rows.step(actions)
        goals += [info["goals"] for info in infos]
    print(f"{rows.num_agents} rows, {np.mean(goals):.2f} of the episodes ended with a goal")
    rows.close()
