"""Parameter sharing through SuperSuit: both attackers of 2v1 are rows of PPO of
Stable-Baselines3. pip install 'FILE[sb3]' supersuit; cls_gym.adapters.sb3 is several times faster.
"""
import sys

import supersuit
from stable_baselines3 import PPO
from stable_baselines3.common.vec_env import VecMonitor

import cls_gym

if __name__ == "__main__":
    env = cls_gym.ParallelEnv("cls/HFO-2v1-v0", features="ego", actions="skills", frame_skip=4,
                              mask="appended",
                              reward={"goal": 5, "advance": 0.05, "approach": 0.05})
    env = supersuit.pettingzoo_env_to_vec_env_v1(env)
    env = supersuit.concat_vec_envs_v1(env, 8, num_cpus=0, base_class="stable_baselines3")
    model = PPO("MlpPolicy", VecMonitor(env), n_steps=128, batch_size=512)
    model.learn(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
    rewards = [one["r"] for one in model.ep_info_buffer]
    print(f"mean reward of {len(rewards)} episodes: {sum(rewards) / max(len(rewards), 1):.2f}")
