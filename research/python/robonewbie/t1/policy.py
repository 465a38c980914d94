"""The T1's walk as a policy file: written from a trained model, and read with numpy alone."""

import numpy as np

from ..train import _layers_of, _numbers, layer_lines
from . import mirror, robot

DIGITS = 5
_ACTIVATIONS = {"tanh": np.tanh, "cut": lambda sums: np.clip(sums, -1, 1), "linear": lambda sums: sums}


def policy_text(model, about):
    """Formats the actor of a PPO model for org.robonewbie.agent.policy.PolicyText.

    The first layer clips the observation. Stance, gains and gait are in the file, so that it is all that a player needs.
    """

    def numbers(name, values):
        return f"numbers {name} " + " ".join(f"{value:g}" for value in values)

    lines = ["policy 1 t1-walk", *(f"# {line}" for line in about)]
    lines += [
        numbers("cycles-per-action", [robot.CYCLES_PER_ACTION]),
        numbers("actions-per-stride", [robot.GAIT_ACTIONS]),
        numbers("lift-degrees", [robot.LIFT_DEGREES]),
        numbers("swing-degrees-forward-left-turn", robot.SWING_DEGREES),
        numbers("most-forward-left-turn-backward", [*robot.MAX_COMMAND, robot.MAX_BACKWARD]),
        numbers("stance-degrees", robot.STANCE_DEGREES),
        numbers("stiffness", robot.STIFFNESS),
        numbers("damping", robot.DAMPING),
    ]
    lines += [f"input {name} {unit}" for name, unit in robot.INPUTS]
    lines += [f"output {motor} {degrees:g} degrees" for motor, degrees in zip(robot.LEG_MOTORS, robot.RANGE_DEGREES)]
    return "\n".join([*lines, *layer_lines(_layers(model))]) + "\n"


def _layers(model):
    """Returns the layers of the symmetric actor as those of one network, in which each hidden layer is there twice."""
    policy = model.policy
    first, *others = _layers_of(policy.mlp_extractor.policy_net)
    limit, count = robot.OBSERVATION_LIMIT, len(robot.INPUTS)
    swapped = _matrix(*mirror.mirror_of_observation())[:count, :count]
    layers = [(np.identity(count) / limit, np.zeros(count), "cut")]
    weights, bias, activation = first
    layers.append((np.concatenate([weights, weights @ swapped]) * limit, np.tile(bias, 2), activation))
    for weights, bias, activation in others:
        zeros = np.zeros_like(weights)
        layers.append((np.block([[weights, zeros], [zeros, weights]]), np.tile(bias, 2), activation))
    weights, bias = _numbers(policy.action_net.linear)
    swapped = _matrix(*mirror.mirror_of_action())
    layers.append((np.concatenate([weights, swapped @ weights], axis=1) / 2, (bias + swapped @ bias) / 2, "cut"))
    return [(_rounded(weights), _rounded(bias), activation) for weights, bias, activation in layers]


def _matrix(indices, signs):
    """Returns the matrix of a mirror that is given by indices and signs."""
    return np.identity(len(indices))[indices] * signs[:, None]


def _rounded(numbers):
    return np.vectorize(lambda number: float(f"{number:.{DIGITS}g}"))(numbers)


class Policy:
    """A policy file that is played with numpy."""

    def __init__(self, text):
        self._layers = []
        lines = iter(text.splitlines())
        for line in lines:
            if line.startswith("layer "):
                _, _, outputs, activation = line.split()
                rows = np.array([next(lines).split() for _ in range(int(outputs))], float)
                self._layers.append((rows[:, 1:], rows[:, 0], _ACTIVATIONS[activation]))

    def __call__(self, observation):
        """Returns the actions for observations, one row per robot."""
        values = np.asarray(observation, float)[:, : len(robot.INPUTS)]
        for weights, bias, activation in self._layers:
            values = activation(values @ weights.T + bias)
        return values
