#!/usr/bin/env python3
"""Learns half field offense with PyTorch: PPO with one policy for all attackers.

    python3 examples/training/learn_torch.py --defense 1 --out policy.npz

The attackers share network, reward and experience; each observes the pitch from its own place.
They choose among skills (`--actions skills`) or single commands (`low_discrete`). `--imitate`
begins with rules (attack_rules.py): where nearly all random play loses the ball, nothing else is
found to improve. `--obs world_model` lets them see what players know in matches, and
`--start policy.npz` continues with a trained policy, also one for fewer players: most of the
learning is cheap with the full state, the rest is not. With `--steps 0` it is evaluated alone. At
the end it plays 500 fresh episodes without exploration and prints the share of goals with a
confidence interval. `--out` writes a policy that plays matches (docs/training.md).
"""
import argparse
import json
import math
import sys
import time

import numpy as np

import cls_gym
from attack_rules import AttackRules
from cls_gym.policy import Policy, PolicyError, describe, load

try:
    import torch
except ImportError:
    sys.exit("learn_torch.py needs PyTorch: pip install torch; learn_numpy.py does without")

HORIZON = 64
GAMMA, LAMBDA, CLIP = 0.9925, 0.95, 0.2  # GAMMA: per cycle
EPOCHS, BATCHES = 4, 8
EPISODES = 500
WARM_UP = 12  # updates of the critic alone after imitation
REWARD = {"goal": 5, "captured": 1, "out_of_bounds": 1, "out_of_time": 1, "advance": 0.05}


def network(sizes, last_scale):
    """Tanh layers and a linear one."""
    layers = []
    for inputs, outputs in zip(sizes, sizes[1:]):
        linear = torch.nn.Linear(inputs, outputs)
        torch.nn.init.orthogonal_(linear.weight, last_scale if outputs == sizes[-1] else 1.0)
        torch.nn.init.zeros_(linear.bias)
        layers += [linear, torch.nn.Tanh()]
    return torch.nn.Sequential(*layers[:-1])


def linears(net):
    return [layer for layer in net if isinstance(layer, torch.nn.Linear)]


def as_policy(actor, about):
    return Policy([(layer.weight.detach().numpy().T.copy(), layer.bias.detach().numpy().copy())
                   for layer in linears(actor)], about)


def start_from(actor, policy, spec):
    """Takes over the weights of a trained policy, features by name: those that it does not know,
    of further players, begin without influence."""
    mine, known = [feature.name for feature in spec.features], policy.about["feature_names"]
    if list(spec.actions.names) != policy.about["action_names"] or not set(known) <= set(mine):
        raise PolicyError("--start: the policy has other features or actions")
    first = np.zeros((len(mine), policy.layers[0][0].shape[1]), np.float32)
    first[[mine.index(name) for name in known]] = policy.layers[0][0]
    weights = [first, *(weight for weight, _ in policy.layers[1:])]
    for layer, weight, (_, bias) in zip(linears(actor), weights, policy.layers):
        if layer.weight.shape != weight.T.shape:
            raise PolicyError("--start: the policy has other layers")
        with torch.no_grad():
            layer.weight.copy_(torch.from_numpy(weight.T.copy()))
            layer.bias.copy_(torch.from_numpy(bias))


class Learner:
    """Proximal policy optimization. T steps of N worlds with A agents each."""

    def __init__(self, envs, seed, rate, entropy, frame_skip):
        torch.manual_seed(seed)
        spec = envs.spec_of_task
        features, self.actions = len(spec.features), len(spec.actions.names)
        self.envs, self.agents, self.entropy, self.warm_up = envs, len(spec.agents), entropy, 0
        self.gamma = GAMMA ** frame_skip
        self.actor = network([features, 128, 128, self.actions], 0.01)
        self.critic = network([features, 128, 128, 1], 1.0)
        self.rate = rate
        self.optimizer = torch.optim.Adam(
            [*self.actor.parameters(), *self.critic.parameters()], lr=rate, eps=1e-5)
        self.seen, infos = envs.reset(seed=seed)
        self.mask = infos["action_mask"]

    def tensors(self, seen, mask):
        """[N * A, ...]: each agent is a sample."""
        return (torch.from_numpy(np.ascontiguousarray(seen)).reshape(-1, seen.shape[-1]),
                torch.from_numpy(np.ascontiguousarray(mask)).reshape(-1, self.actions))

    def distribution(self, seen, mask):
        scores = self.actor(seen).masked_fill(mask == 0, -1e9)
        return torch.distributions.Categorical(logits=scores)

    @torch.no_grad()
    def play(self):
        """A rollout, and the statuses of the episodes that ended."""
        worlds = self.envs.num_envs
        steps, ends = [], []
        for _ in range(HORIZON):
            seen, mask = self.tensors(self.seen, self.mask)
            chances = self.distribution(seen, mask)
            acted = chances.sample()
            value = self.critic(seen)[:, 0]
            shape = (worlds, self.agents) if self.agents > 1 else (worlds,)
            after, reward, terminated, truncated, infos = self.envs.step(
                acted.numpy().reshape(shape))
            reward = np.repeat(np.asarray(reward, np.float32), self.agents)
            ended = terminated | truncated
            for world in np.flatnonzero(truncated):  # its value stands in for the rest
                last = torch.from_numpy(np.atleast_2d(infos["final_obs"][world]).copy())
                own = slice(world * self.agents, (world + 1) * self.agents)
                reward[own] += self.gamma * self.critic(last)[:, 0].numpy()
            if ended.any():
                ends += infos["final_info"]["status"][ended].tolist()
            steps.append((seen, mask, acted, chances.log_prob(acted), value,
                          torch.from_numpy(reward),
                          torch.from_numpy(np.repeat(ended, self.agents))))
            self.seen, self.mask = after, infos["action_mask"]
        parts = [torch.stack(part) for part in zip(*steps)]
        last = self.critic(self.tensors(self.seen, self.mask)[0])[:, 0]
        return parts, last, ends

    def advantages(self, values, rewards, ended, last):
        result, running, following = torch.zeros_like(rewards), 0.0, last
        for t in reversed(range(len(rewards))):
            alive = (~ended[t]).float()
            surprise = rewards[t] + self.gamma * following * alive - values[t]
            running = surprise + self.gamma * LAMBDA * alive * running
            result[t], following = running, values[t]
        return result

    def learn(self, share):
        """One update; `share` of the training is over. Returns the statuses."""
        for group in self.optimizer.param_groups:
            group["lr"] = self.rate * (1.0 - share)
        (seen, mask, acted, before, values, rewards, ended), last, ends = self.play()
        better = self.advantages(values, rewards, ended, last)
        target = better + values
        flat = [part.flatten(0, 1) for part in (seen, mask, acted, before, better, target)]
        for _ in range(EPOCHS):
            for chosen in torch.randperm(len(flat[2])).chunk(BATCHES):
                self.improve(*(part[chosen] for part in flat))
        self.warm_up -= 1
        return ends

    def improve(self, seen, mask, acted, before, better, target):
        chances = self.distribution(seen, mask)
        ratio = torch.exp(chances.log_prob(acted) - before)
        better = (better - better.mean()) / (better.std() + 1e-8)
        gain = torch.minimum(ratio * better, ratio.clamp(1 - CLIP, 1 + CLIP) * better).mean()
        error = 0.5 * (self.critic(seen)[:, 0] - target).square().mean()
        loss = error
        if self.warm_up <= 0:
            loss = loss - gain - self.entropy * chances.entropy().mean()
        self.optimizer.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.actor.parameters(), 0.5)
        torch.nn.utils.clip_grad_norm_(self.critic.parameters(), 0.5)
        self.optimizer.step()


def imitate(learner, rules, rounds):
    """Learns to choose what the rules choose, in situations that they and the policy bring about.
    """
    envs, optimizer = learner.envs, torch.optim.Adam(learner.actor.parameters(), lr=1e-3)
    random, data = np.random.default_rng(1), []
    for number in range(rounds):
        for _ in range(HORIZON):
            wanted = np.asarray(rules.act(learner.seen, learner.mask))
            seen, mask = learner.tensors(learner.seen, learner.mask)
            data.append((seen, mask, torch.from_numpy(wanted.reshape(-1))))
            with torch.no_grad():
                own = learner.distribution(seen, mask).sample().numpy().reshape(wanted.shape)
            by_rules = random.random((envs.num_envs,) + (1,) * (wanted.ndim - 1)) < 0.5
            acted = wanted if number == 0 else np.where(by_rules, wanted, own)
            learner.seen, _, _, _, infos = envs.step(acted)
            learner.mask = infos["action_mask"]
        data = data[-6 * HORIZON:]
        seen, mask, wanted = (torch.cat(part) for part in zip(*data))
        for chosen in [*torch.randperm(len(wanted)).split(2048),
                       *torch.randperm(len(wanted)).split(2048)]:
            chances = learner.distribution(seen[chosen], mask[chosen])
            error = torch.nn.functional.cross_entropy(chances.logits, wanted[chosen])
            optimizer.zero_grad()
            (error - 0.02 * chances.entropy().mean()).backward()
            optimizer.step()
        print(f"imitates: round {number + 1} of {rounds}, error {error.item():.2f}", flush=True)
    learner.warm_up = WARM_UP


def evaluate(config, policy, episodes, seed):
    """The share of goals in the first episode of each of so many worlds."""
    envs = cls_gym.VectorEnv(num_envs=episodes, **config)
    seen, infos = envs.reset(seed=seed)
    status = np.zeros(episodes, np.int64)
    while not status.all():
        seen, _, _, _, infos = envs.step(policy.act(seen, infos["action_mask"]))
        status = np.where(status == 0, infos["status"], status)
    envs.close()
    return float((status == 1).mean())


def interval(share, count):
    """The 95 % interval of Wilson."""
    z = 1.96
    middle = (share + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * math.sqrt(share * (1 - share) / count
                                               + z * z / (4 * count * count))
    return middle - half, middle + half


def train(options, config, report):
    envs = cls_gym.VectorEnv(num_envs=options.worlds, autoreset_mode="same_step", **config)
    learner = Learner(envs, options.seed, options.rate, options.entropy, options.frame_skip)
    if options.start:
        start_from(learner.actor, load(options.start), envs.spec_of_task)
    if options.imitate:
        imitate(learner, AttackRules(envs), options.imitate)
    per_update = options.worlds * HORIZON
    start = time.process_time()
    for done in range(0, options.steps, per_update):
        if options.minutes and time.process_time() - start > 60 * options.minutes:
            break
        ends = learner.learn(done / options.steps)
        report(done + per_update, float(np.mean(np.array(ends) == 1)) if ends else 0.0)
    about = describe(envs)
    envs.close()
    return as_policy(learner.actor, about)


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--offense", type=int, default=1)
    parser.add_argument("--defense", type=int, default=0, help="with the goalie")
    parser.add_argument("--obs", choices=("full_state", "world_model"), default="full_state")
    parser.add_argument("--steps", type=int, default=1_000_000, help="decisions of the worlds together")
    parser.add_argument("--minutes", type=float, help="of CPU time at most")
    parser.add_argument("--worlds", type=int, default=256)
    parser.add_argument("--rate", type=float, default=1e-3)
    parser.add_argument("--entropy", type=float, default=0.01)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--actions", choices=("skills", "low_discrete"), default="skills",
                        help="skills such as shoot, pass and dribble, or single commands")
    parser.add_argument("--frame-skip", type=int, default=4, help="cycles per decision")
    parser.add_argument("--imitate", type=int, default=0, metavar="ROUNDS",
                        help="rounds of imitation of the rules before (2v2: 12)")
    parser.add_argument("--opponent", default="scripted",
                        help="who plays the defense: scripted, mock or planner")
    parser.add_argument("--start", metavar="FILE", help="a trained policy to continue with")
    parser.add_argument("--out", metavar="FILE", help="the trained policy (.npz)")
    parser.add_argument("--curve", metavar="FILE", help="share of goals by steps (.json)")
    options = parser.parse_args()
    if options.imitate and (options.offense < 2 or options.actions != "skills"):
        parser.error("--imitate: the rules are for two or more attackers with --actions skills")
    return options


def main():
    options = parse()
    torch.set_num_threads(1)
    config = {"task": "cls/HalfFieldOffense-v0", "offense": options.offense,
              "defense": options.defense, "features": "ego", "actions": options.actions,
              "obs": options.obs, "opponent": options.opponent, "max_cycles": 500,
              "frame_skip": options.frame_skip, "reward": REWARD}
    curve, start = [], time.process_time()

    def report(steps, goals):
        curve.append((steps, goals))
        if len(curve) % 10 == 0:
            print(f"{steps:>9} steps  {goals:.2f} goals  {time.process_time() - start:.0f} s CPU",
                  flush=True)

    try:
        policy = train(options, config, report)
    except PolicyError as error:
        sys.exit(f"learn_torch.py: {error}")
    spent = time.process_time() - start
    goals = evaluate(config, policy, EPISODES, 10_000)
    low, high = interval(goals, EPISODES)
    print(f"{options.offense}v{options.defense} ({options.opponent}), {options.obs}, "
          f"seed {options.seed}: {goals:.3f} ({low:.3f} to {high:.3f}) of {EPISODES} fresh "
          f"episodes end with a goal; {curve[-1][0] if curve else 0} steps, "
          f"{spent:.0f} s CPU")
    if options.out:
        policy.save(options.out)
    if options.curve:
        with open(options.curve, "w", encoding="utf-8") as out:
            json.dump({"label": f"{options.offense}v{options.defense}, seed {options.seed}",
                       "goals": goals, "episodes": EPISODES, "cpu_seconds": spent,
                       "curve": curve}, out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
