"""MaskablePPO of sb3-contrib learns to score in an empty goal; one process, 32 worlds.

    pip install 'FILE[sb3]'; python3 sb3_ppo.py [STEPS]
"""
import sys

import numpy as np
from sb3_contrib import MaskablePPO
from stable_baselines3.common.logger import configure

import cls_gym
from cls_gym.adapters.sb3 import SB3VecEnv
from cls_gym.policy import from_torch

steps = int(sys.argv[1]) if len(sys.argv) > 1 else 200_000
worlds = {"task": "cls/HFO-1v0-v0", "features": "ego", "actions": "skills", "frame_skip": 4,
          "max_cycles": 500, "autoreset_mode": "same_step"}
env = SB3VecEnv(cls_gym.VectorEnv(num_envs=32, **worlds,
                                  reward={"goal": 5, "advance": 0.05, "approach": 0.05}))
model = MaskablePPO("MlpPolicy", env, n_steps=128, batch_size=1024, n_epochs=4, gamma=0.99,
                    learning_rate=1e-3, ent_coef=0.01, seed=1)
model.set_logger(configure(format_strings=["stdout"]))
model.learn(steps)
from_torch(env.envs, model.policy.mlp_extractor.policy_net, model.policy.action_net).save("sb3.npz")

trial = SB3VecEnv(cls_gym.VectorEnv(num_envs=100, **worlds))
trial.seed(1_000_000_000)
seen, first = trial.reset(), np.full(100, -1)
while (first < 0).any():
    actions, _ = model.predict(seen, action_masks=trial.action_masks(), deterministic=True)
    seen, _, ended, infos = trial.step(actions)
    for row in np.flatnonzero(ended & (first < 0)):
        first[row] = infos[row]["status"]
print(f"goals in {np.mean(first == 1):.2f} of 100 fresh episodes")
