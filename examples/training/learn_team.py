"""A team that learns its decisions with the ball from the planner of cls, then from its own mistakes.

    python3 examples/training/learn_team.py record --out data/planner --matches 64
    python3 examples/training/learn_team.py clone --data data/planner --out cloned.policy
    python3 examples/training/learn_team.py record --out data/round1 --matches 32 --policy cloned.policy
    python3 examples/training/learn_team.py clone --data data/planner data/round1 --out dagger.policy
    python3 examples/training/learn_team.py play --policy dagger.policy --opponent planner
    cls match policy:dagger.policy mock

`record` plays matches in the engine and stores what the players with the ball observed, and what the
planner would have chosen for them: where the planner plays (behavior cloning), or where a policy does
(DAgger). `clone` fits a network to it. `play` is a match of the policy, of the planner's choices
(--policy planner) or of random ones (--policy random) in the engine. Each stage can be stopped and
started again: `record` goes on where it stopped. It needs NumPy. docs/learned-team.md has the figures.
"""
from __future__ import annotations

import argparse
import json
import pathlib
import time
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

import numpy as np

import cls_gym
from cls_gym import network, policy
from cls_gym.network import Network, Step

# Of team/1 with 10 teammates and 11 opponents: columns of the own state and the ball, of a player,
# and of a dribble or a pass.
OWN, PLAYER, TARGET = 54, 15, 8
MATES, DRIBBLES = OWN, OWN + 21 * PLAYER
PASSES = DRIBBLES + 16 * TARGET
FEATURES = PASSES + 40 * TARGET
OPTIONS = 84
Choose = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


# ---- matches

def worlds(count: int, opponent: str, cycles: int = 0) -> cls_gym.VectorEnv:
    """Whole matches; opponent: "self" (both teams are agents), or a name of docs/training.md."""
    teams: Dict[str, Any] = {"agents": "both"} if opponent == "self" else {"opponent": opponent}
    return cls_gym.VectorEnv("cls/Match-v0", count, obs="world_model", features="team",
                             actions="options", expert="planner", until="decision", frame_skip=20,
                             types="random", max_cycles=cycles, **teams)


def chooser(name: str, seed: int) -> Choose:
    """Chooses for rows of players with the ball: observations, masks and the planner's choices."""
    if name == "planner":
        return lambda observations, masks, expert: expert
    if name == "random":
        random = np.random.default_rng(seed)
        return lambda observations, masks, expert: (random.random(masks.shape) * masks).argmax(1)
    net = network.load(name)
    return lambda observations, masks, expert: net.act(observations, masks)


def play(envs: cls_gym.VectorEnv, choose: Choose, seed: int,
         see: Optional[Callable[..., None]] = None) -> np.ndarray:
    """int[N]: goal differences of a match in each world. see: takes the worlds, observations, masks
    and the planner's choices of the players with the ball."""
    observations, infos = envs.reset(seed=seed)
    ended = np.zeros(envs.num_envs, bool)
    score = np.zeros((envs.num_envs, 2), int)
    while not ended.all():
        masks, expert = infos["action_mask"], infos["expert"]
        ball = (masks[:, :, 0] == 0) & (expert >= 0) & ~ended[:, None]
        actions = np.zeros(expert.shape, np.int64)
        if ball.any():
            rows = observations[ball], masks[ball], expert[ball]
            actions[ball] = choose(*rows)
            if see is not None:
                see(ball.nonzero()[0], *rows)
        observations, _, terminated, truncated, infos = envs.step(actions)
        now = (terminated | truncated) & ~ended  # such a world begins another match, which is not seen
        score[now] = infos["score"][now]
        ended |= now
    return score[:, 0] - score[:, 1]


def record(options: argparse.Namespace) -> None:
    """Files of `worlds` matches each; those that exist are complete."""
    options.out.mkdir(parents=True, exist_ok=True)
    choose = chooser(options.policy, options.seed)
    with worlds(options.worlds, options.opponent, options.cycles) as envs:
        for first in range(options.seed, options.seed + options.matches, options.worlds):
            path = options.out / f"{options.opponent}-{first:07d}.npz"
            if path.exists():
                continue
            seen: List[Tuple[np.ndarray, ...]] = []
            began = time.process_time()
            goals = play(envs, choose, first, lambda *rows: seen.append(
                (rows[0] + first, rows[1].astype(np.float16), rows[2].astype(bool), rows[3])))
            match, observed, masks, expert = (np.concatenate(one) for one in zip(*seen))
            part = path.with_suffix(".part")
            with open(part, "wb") as out:
                np.savez(out, match=match, observed=observed, masks=masks, expert=expert)
            part.rename(path)
            print(f"{path}: {len(expert)} choices, goals {goals.mean():+.2f}, "
                  f"{time.process_time() - began:.0f} s of CPU", flush=True)


# ---- the network and its gradient

def dense(name: str, of: str, inputs: int, width: int, activation: str,
          random: np.random.Generator) -> Step:
    weight = random.normal(0, (2 / inputs) ** 0.5, (inputs, width))
    return Step(name, "dense", [of], width=width, activation=activation,
                weights=[weight * (0.1 if activation == "none" else 1), np.zeros(width)])


def make_network(about: Dict[str, Any], mean: np.ndarray, deviation: np.ndarray,
                 random: np.random.Generator) -> Network:
    """What the player knows becomes a summary; a network that all dribbles share, and one that all
    receivers share, score each option from the summary and where the option leads."""
    scale = 1 / np.maximum(deviation, 0.05)
    hidden, summary = 160, 64
    steps = [
        Step("scaled", "norm", ["features"], weights=[scale, -mean * scale]),
        dense("first", "scaled", FEATURES, hidden, "relu", random),
        dense("summary", "first", hidden, summary, "relu", random),
        dense("basic", "summary", summary, 5, "none", random),
        Step("dribbles", "columns", ["scaled"], DRIBBLES, 16, TARGET),
        Step("each_dribble", "concat", ["dribbles", "summary"]),
        dense("dribble_part", "each_dribble", TARGET + summary, 48, "relu", random),
        dense("dribble_score", "dribble_part", 48, 1, "none", random),
        Step("dribble_scores", "flatten", ["dribble_score"]),
        Step("passes", "columns", ["scaled"], PASSES, 10, 4 * TARGET),
        Step("mates", "columns", ["scaled"], MATES, 10, PLAYER),
        Step("each_pass", "concat", ["passes", "mates", "summary"]),
        dense("pass_part", "each_pass", 4 * TARGET + PLAYER + summary, 64, "relu", random),
        dense("pass_score", "pass_part", 64, 4, "none", random),
        Step("pass_scores", "flatten", ["pass_score"]),
        dense("moves", "summary", summary, OPTIONS - 61, "none", random),
        Step("scores", "concat", ["basic", "dribble_scores", "pass_scores", "moves"])]
    return Network(steps, dict(about, decides="ball"))


def forward(net: Network, observations: np.ndarray) -> Dict[str, np.ndarray]:
    """The result [B, rows, width] of each step."""
    results = {"features": observations[:, None, :]}
    for step in net.steps:
        x = results[step.of[0]]
        if step.kind == "columns":
            out = x[:, 0, step.first:step.first + step.rows * step.width]
            out = out.reshape(len(x), step.rows, step.width)
        elif step.kind == "norm":
            out = x * step.weights[0] + step.weights[1]
        elif step.kind == "dense":
            out = x.reshape(-1, x.shape[2]) @ step.weights[0] + step.weights[1]
            out = out.reshape(x.shape[0], x.shape[1], -1)
            if step.activation == "relu":
                np.maximum(out, 0, out=out)
        elif step.kind == "concat":
            parts = [results[name] for name in step.of]
            rows = max(one.shape[1] for one in parts)
            out = np.concatenate([np.broadcast_to(one, (len(x), rows, one.shape[2]))
                                  for one in parts], axis=2)
        else:
            out = x.reshape(len(x), 1, -1)
        results[step.name] = out
    return results


def backward(net: Network, results: Dict[str, np.ndarray],
             of_scores: np.ndarray) -> Dict[str, List[np.ndarray]]:
    """Gradients of the weights of dense steps by name, from that of the scores [B, 1, K]."""
    of: Dict[str, np.ndarray] = {net.steps[-1].name: of_scores}
    gradients: Dict[str, List[np.ndarray]] = {}

    def add(name: str, gradient: np.ndarray) -> None:
        if name not in ("features", "scaled"):
            of[name] = of[name] + gradient if name in of else gradient

    for step in reversed(net.steps):
        if step.name not in of or step.kind in ("columns", "norm"):
            continue
        gradient, x = of[step.name], results[step.of[0]]
        if step.kind == "dense":
            if step.activation == "relu":
                gradient = gradient * (results[step.name] > 0)
            flat = gradient.reshape(-1, gradient.shape[2])
            gradients[step.name] = [x.reshape(-1, x.shape[2]).T @ flat, flat.sum(0)]
            if step.of[0] != "scaled":
                add(step.of[0], (flat @ step.weights[0].T).reshape(x.shape))
        elif step.kind == "concat":
            first = 0
            for name in step.of:
                part = results[name]
                one = gradient[:, :, first:first + part.shape[2]]
                first += part.shape[2]
                add(name, one.sum(1, keepdims=True) if part.shape[1] < one.shape[1] else one)
        else:
            add(step.of[0], gradient.reshape(x.shape))
    return gradients


class Adam:
    """Adam with a decay of the weights."""

    def __init__(self, net: Network, decay: float) -> None:
        self.net, self.decay, self.steps = net, decay, 0
        self.means = {step.name: [np.zeros_like(one) for one in step.weights] for step in net.steps}
        self.squares = {name: [np.zeros_like(one) for one in all] for name, all in
                        self.means.items()}

    def step(self, gradients: Dict[str, List[np.ndarray]], rate: float) -> None:
        self.steps += 1
        for step in self.net.steps:
            for i, gradient in enumerate(gradients.get(step.name, [])):
                mean, square = self.means[step.name][i], self.squares[step.name][i]
                mean += 0.1 * (gradient - mean)
                square += 0.001 * (gradient * gradient - square)
                change = mean / (1 - 0.9 ** self.steps)
                change /= np.sqrt(square / (1 - 0.999 ** self.steps)) + 1e-8
                decay = self.decay if i == 0 else 0.0
                step.weights[i][...] -= rate * (change + decay * step.weights[i])


# ---- imitation

def read(folders: List[pathlib.Path]) -> Tuple[np.ndarray, ...]:
    """match, observed, masks and expert of all files; matches of different folders differ."""
    parts: List[Tuple[np.ndarray, ...]] = []
    for number, folder in enumerate(folders):
        for path in sorted(folder.glob("*.npz")):
            with np.load(path) as file:
                parts.append((file["match"] + 10_000_000 * number, file["observed"], file["masks"],
                              file["expert"]))
    match, observed, masks, expert = (np.concatenate(one) for one in zip(*parts))
    return match, observed.astype(np.float32), masks, expert


def probabilities(scores: np.ndarray, masks: np.ndarray) -> np.ndarray:
    shifted = np.where(masks, scores, -1e9)
    shifted = np.exp(shifted - shifted.max(1, keepdims=True))
    return np.asarray(shifted / shifted.sum(1, keepdims=True), np.float32)


def agreement(net: Network, observed: np.ndarray, masks: np.ndarray,
              expert: np.ndarray) -> Tuple[float, float, float]:
    """Shares of choices that are the expert's, and that are among the three best; the loss."""
    top1 = top3 = loss = 0.0
    for first in range(0, len(expert), 4096):
        part = slice(first, first + 4096)
        scores = forward(net, observed[part])["scores"][:, 0]
        chosen = probabilities(scores, masks[part])
        own = np.take_along_axis(chosen, expert[part, None], 1)
        better = (chosen > own).sum(1)
        top1 += float((better == 0).sum())
        top3 += float((better < 3).sum())
        loss -= float(np.log(np.maximum(own, 1e-9)).sum())
    return top1 / len(expert), top3 / len(expert), loss / len(expert)


def batches(count: int, size: int, random: np.random.Generator) -> Iterator[np.ndarray]:
    order = random.permutation(count)
    for first in range(0, count - size + 1, size):
        yield order[first:first + size]


def clone(options: argparse.Namespace) -> None:
    """Fits the choices of the planner; one of ten matches is held out, and the best epoch kept."""
    random = np.random.default_rng(options.seed)
    match, observed, masks, expert = read(options.data)
    held = match % 10 == 9
    train = tuple(one[~held] for one in (observed, masks, expert))
    test = tuple(one[held] for one in (observed, masks, expert))
    print(f"{len(train[2])} choices to learn from, {len(test[2])} held out", flush=True)
    with worlds(1, "planner") as envs:
        about = policy.describe(envs)
    net = make_network(about, train[0].mean(0), train[0].std(0), random)
    adam, curve, best = Adam(net, options.decay), [], np.inf
    for epoch in range(options.epochs):
        rate = options.rate * 0.5 * (1 + np.cos(np.pi * epoch / options.epochs))
        for rows in batches(len(train[2]), 512, random):
            results = forward(net, train[0][rows])
            of_scores = probabilities(results["scores"][:, 0], train[1][rows])
            of_scores[np.arange(len(rows)), train[2][rows]] -= 1
            adam.step(backward(net, results, of_scores[:, None] / len(rows)), rate)
        top1, top3, loss = agreement(net, *test)
        curve.append({"epoch": epoch + 1, "top1": top1, "top3": top3, "loss": loss})
        print(f"epoch {epoch + 1}: held out: {top1:.3f} the planner's, {top3:.3f} among three, "
              f"loss {loss:.3f}; {time.process_time():.0f} s of CPU", flush=True)
        if loss < best:
            best = loss
            net.about["training"] = {"choices": len(train[2]), **curve[-1]}
            net.save(options.out)
    pathlib.Path(options.out).with_suffix(".curve.json").write_text(json.dumps(curve))


def evaluate(options: argparse.Namespace) -> None:
    """Goal difference of matches in the engine, with its 95 % interval."""
    choose = chooser(options.policy, options.seed)
    goals: List[np.ndarray] = []
    with worlds(options.worlds, options.opponent, options.cycles) as envs:
        for first in range(options.seed, options.seed + options.matches, options.worlds):
            goals.append(play(envs, choose, first))
            all_goals = np.concatenate(goals)
            margin = 1.96 * all_goals.std(ddof=1) / len(all_goals) ** 0.5
            print(f"{options.policy} against {options.opponent}, {len(all_goals)} matches: "
                  f"{all_goals.mean():+.2f} ({all_goals.mean() - margin:+.2f} to "
                  f"{all_goals.mean() + margin:+.2f})", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    stages = parser.add_subparsers(required=True, metavar="STAGE")

    def stage(name: str, run: Callable[[argparse.Namespace], None]) -> argparse.ArgumentParser:
        one = stages.add_parser(name, help=(run.__doc__ or "").split("\n")[0])
        one.set_defaults(run=run)
        one.add_argument("--seed", type=int, default=1)
        return one

    def of_matches(one: argparse.ArgumentParser, opponent: str) -> None:
        one.add_argument("--policy", default="planner", help="planner, random, or a policy file")
        one.add_argument("--opponent", default=opponent, help="self, planner, mock or scripted")
        one.add_argument("--matches", type=int, default=16)
        one.add_argument("--worlds", type=int, default=8, help="matches at the same time")
        one.add_argument("--cycles", type=int, default=0, help="of a match (default: 6000)")

    recorded = stage("record", record)
    recorded.add_argument("--out", type=pathlib.Path, required=True)
    of_matches(recorded, "self")
    cloned = stage("clone", clone)
    cloned.add_argument("--data", type=pathlib.Path, nargs="+", required=True)
    cloned.add_argument("--out", required=True)
    cloned.add_argument("--epochs", type=int, default=12)
    cloned.add_argument("--rate", type=float, default=0.001)
    cloned.add_argument("--decay", type=float, default=0.02)
    of_matches(stage("play", evaluate), "planner")
    options = parser.parse_args()
    options.run(options)


if __name__ == "__main__":
    main()
