"""Reflection of observations and actions in the plane between the robot's left and right, for symmetry losses and data augmentation."""

from __future__ import annotations

import re

import numpy as np

from robonewbie.network import Dense
from robonewbie.simulator import RoboNewbieError

_SIDES = {"LEFT_": "RIGHT_", "RIGHT_": "LEFT_", "leftFoot": "rightFoot", "rightFoot": "leftFoot"}
# Rotations about axes that lie in the plane, and the components of other vectors that point to the left, change their signs.
_OPPOSITE = re.compile(
    r".*(_YAW|_ROLL)"
    r"|(gyro|torso\.turn)\.(forward|up)"
    r"|(?!gyro|torso\.turn).*\.(left|y|sine|horizontal)"
    r"|command\.(turn|heading)"
    r"|gait\.cosine"
)


def mirror_of(names: list[str]) -> tuple[np.ndarray, np.ndarray]:
    """Returns indices and signs such that ``signs * values[..., indices]`` are the mirrored values of the quantities with these names.

    :raises RoboNewbieError: if a quantity of one side has no counterpart on the other
    """
    partners = [re.sub("|".join(_SIDES), lambda side: _SIDES[side.group()], name) for name in names]
    missing = set(partners) - set(names)
    if missing:
        raise RoboNewbieError(f"The task is not symmetric: {', '.join(sorted(missing))} is missing.")
    signs = [-1 if _OPPOSITE.fullmatch(re.sub(r"@.*", "", name)) else 1 for name in names]
    return np.array([names.index(partner) for partner in partners]), np.array(signs, dtype=np.float32)


def symmetric_layers(layers: list[Dense], observation_mirror: tuple, action_mirror: tuple) -> list[Dense]:
    """Returns the layers of one network for the mean of a network's action and its mirrored action for the mirrored observation.

    The mirrors are indices and signs. Each hidden layer is there twice.
    """
    doubled = []
    for layer in layers:
        weights, zeros = layer.weights, np.zeros_like(layer.weights)
        weights = np.block([[weights, zeros], [zeros, weights]]) if doubled else np.concatenate([weights, weights @ _matrix(*observation_mirror)])
        doubled.append(Dense(weights, np.tile(layer.bias, 2), layer.activation))
    mirror = _matrix(*action_mirror)
    mean = np.concatenate([np.identity(len(mirror)), mirror], axis=1) / 2
    last = doubled.pop()
    return [*doubled, Dense(mean @ last.weights, mean @ last.bias, last.activation)]


def _matrix(indices, signs):
    return np.identity(len(indices))[indices] * np.asarray(signs)[:, None]
