"""PettingZoo, parallel and in turn (AEC), with action masks: pip install 'FILE[gym]'"""
from pettingzoo.utils import parallel_to_aec

import cls_gym

env = cls_gym.ParallelEnv("cls/HFO-2v2-v0", agents="both", features="ego", actions="skills")
observations, infos = env.reset(seed=1)
while env.agents:
    actions = {agent: env.action_space(agent).sample(infos[agent]["action_mask"])
               for agent in env.agents}
    observations, rewards, terminations, truncations, infos = env.step(actions)
print("parallel:", rewards)

turns = parallel_to_aec(cls_gym.ParallelEnv("cls/HFO-2v2-v0", agents="both", features="ego",
                                            actions="skills"))
turns.reset(seed=1)
rewards = {}
for agent in turns.agent_iter():
    observation, reward, terminated, truncated, info = turns.last()
    rewards[agent] = reward
    over = terminated or truncated
    turns.step(None if over else turns.action_space(agent).sample(info["action_mask"]))
print("in turn:", rewards)
