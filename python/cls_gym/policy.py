"""Trained policies as files: a small network in NumPy, with what it sees and does.

Policies that choose among options are files of another kind: cls_gym.network.

A file is an .npz archive: weight0, bias0, weight1, ... float32 and `about`, a JSON text with
schema "cls.policy/1", task, features, feature_version, actions, action_version, teammates and
opponents. A policy plays only with the sets and versions that it was trained with.
"""
from __future__ import annotations

import json
import pathlib
import re
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from cls_gym._files import replaced
from cls_gym.network import MAGIC, Network, PolicyError, Step

__all__ = ["Policy", "PolicyError", "describe", "from_torch", "load", "misfit"]

SCHEMA = "cls.policy/1"
Layer = Tuple[np.ndarray, np.ndarray]


class Policy:
    """A network of tanh layers; its last layer gives a score per action id.

    layers: weight float32[inputs, outputs] and bias float32[outputs] of each layer.
    """

    def __init__(self, layers: Sequence[Layer], about: Dict[str, Any]) -> None:
        self.layers: List[Layer] = [(np.asarray(weight, np.float32), np.asarray(bias, np.float32))
                                    for weight, bias in layers]
        self.about = dict(about, schema=SCHEMA)

    def scores(self, observations: np.ndarray) -> np.ndarray:
        """float32[..., K] of observations float32[..., F]."""
        values = np.asarray(observations, np.float32)
        for weight, bias in self.layers[:-1]:
            values = np.tanh(values @ weight + bias)
        weight, bias = self.layers[-1]
        return values @ weight + bias

    def act(self, observations: np.ndarray, masks: Optional[np.ndarray] = None) -> np.ndarray:
        """int64[...]: the id with the highest score among those whose mask is not 0."""
        scores = self.scores(observations)
        if masks is not None:
            scores = np.where(masks != 0, scores, -np.inf)
        return np.asarray(scores.argmax(axis=-1))

    def network(self) -> Network:
        """The same policy as steps of cls.policy/2, for `cls match policy:FILE`: of the actions
        options it plays there without Python."""
        steps, last = [], len(self.layers) - 1
        for number, (weight, bias) in enumerate(self.layers):
            steps.append(Step(f"layer{number}", "dense",
                              [f"layer{number - 1}" if number else "features"],
                              width=weight.shape[1],
                              activation="tanh" if number < last else "none",
                              weights=[weight, bias]))
        return Network(steps, dict(self.about))

    def save(self, path: Union[str, pathlib.Path]) -> None:
        """Writes the file; it is complete or as it was before."""
        arrays: Dict[str, Any] = {"about": np.array(json.dumps(self.about))}
        for number, (weight, bias) in enumerate(self.layers):
            arrays[f"weight{number}"], arrays[f"bias{number}"] = weight, bias
        with replaced(path) as partial, open(partial, "wb") as out:
            np.savez(out, **arrays)


def describe(envs: Any) -> Dict[str, Any]:
    """What a policy file says about the environment that trained it."""
    spec = envs.spec_of_task
    if spec.actions.senses:
        raise PolicyError("look, say: a policy file has a score per action, and none for senses; "
                          "save the network in the format of its framework")
    names = [feature.name for feature in spec.features]
    return {"task": spec.task, "obs": spec.document["obs"],
            "features": spec.feature_set, "feature_version": spec.feature_version,
            "actions": spec.actions.name, "action_version": spec.actions.version,
            "action_names": list(spec.actions.names), "feature_names": names,
            "teammates": _count(names, "teammate"), "opponents": _count(names, "opponent")}


def from_torch(envs: Any, *modules: Any) -> Policy:
    """The policy of networks of PyTorch that follow each other: linear layers with tanh between
    them, of which the last gives a score per action id. `envs`: the environment that trained it.

    Stable-Baselines3: model.policy.mlp_extractor.policy_net, model.policy.action_net. TorchRL: a
    MultiAgentMLP with share_params. RLlib: module.encoder.actor_encoder (module.encoder.encoder
    where the value shares layers), module.pi. Raises PolicyError for other networks.
    """
    others = {kind for module in modules for part in module.modules()
              for kind in [type(part).__name__]
              if type(part).__module__.startswith("torch.nn.modules.")
              and kind not in ("Linear", "Tanh", "Identity", "Sequential", "ModuleList", "Flatten")}
    if others:
        raise PolicyError(f"from_torch: {min(others)} is neither Linear nor Tanh")
    layers: List[Layer] = []
    for module in modules:
        arrays = {name: value.detach().cpu().numpy() for name, value in module.state_dict().items()
                  if getattr(value, "ndim", 0)}
        for name, array in arrays.items():
            if name.endswith("weight") and array.ndim == 2:
                layers.append((array.T, arrays[name[:-len("weight")] + "bias"]))
    about = dict(describe(envs), schema=SCHEMA)
    _check_layers("from_torch", layers, about)
    return Policy(layers, about)


def misfit(policy: Policy, about: Dict[str, Any]) -> Optional[str]:
    """Why a policy cannot play in the environment that describe() gave; None: it can."""
    for key in ("features", "feature_version", "actions", "action_version"):
        if policy.about.get(key, about[key]) != about[key]:
            return f"trained with {key} {policy.about[key]}, not {about[key]}"
    if list(policy.about.get("feature_names", [])) != about["feature_names"] \
            or list(policy.about.get("action_names", [])) != about["action_names"]:
        ours, theirs = [(one.get("teammates", 0), one.get("opponents", 0),
                         len(one.get("feature_names", [])), len(one.get("action_names", [])))
                        for one in (policy.about, about)]
        return ("trained with %d teammates and %d opponents (%d features, %d actions), "
                "not %d and %d (%d, %d)" % (*ours, *theirs))
    return None


def _count(names: List[str], team: str) -> int:
    return len({name.split("_")[0] for name in names if name.startswith(team)})


def load(path: Union[str, pathlib.Path]) -> Policy:
    """Reads a file. Raises PolicyError if it is none."""
    try:
        with open(path, "rb") as file:
            if file.read(len(MAGIC)) == MAGIC:
                raise PolicyError(f"{path}: is of cls.policy/2: cls_gym.network.load reads it, and "
                                  "cls match policy:FILE plays it")
        with np.load(path, allow_pickle=False) as archive:
            about = json.loads(str(archive["about"]))
            count = sum(name.startswith("weight") for name in archive.files)
            layers = [(archive[f"weight{i}"], archive[f"bias{i}"]) for i in range(count)]
    except PolicyError:
        raise
    except OSError as error:
        raise PolicyError(f"{path}: cannot read: {error.strerror or error}") from error
    except Exception as error:  # an untrusted file may be damaged in any way
        raise PolicyError(f"{path}: no policy of cls_gym: {error}") from error
    _check_layers(path, layers, about)
    return Policy(layers, about)


def _check_layers(path: Any, layers: List[Layer], about: Any) -> None:
    schema = about.get("schema") if isinstance(about, dict) else None
    if re.fullmatch(r"cls\.policy/[1-9]\d*", str(schema)) and schema != SCHEMA:
        raise PolicyError(f"{path}: schema {schema} is newer than this cls_gym reads ({SCHEMA}); "
                          "update cls")
    if schema != SCHEMA:
        raise PolicyError(f"{path}: no policy of cls_gym: schema is not {SCHEMA}")
    width = len(about.get("feature_names", []))
    for number, (weight, bias) in enumerate(layers):
        if weight.ndim != 2 or weight.shape[0] != width or bias.shape != weight.shape[1:] \
                or weight.dtype.kind != "f" or bias.dtype.kind != "f":
            raise PolicyError(f"{path}: layer {number} does not fit the one before")
        width = weight.shape[1]
    if not layers or width != len(about.get("action_names", [])):
        raise PolicyError(f"{path}: has not one score per action")
