"""The T1's walk as a policy file, written from a trained model."""

import numpy as np

from .. import network
from ..train import torch_layers
from . import mirror, robot

DIGITS = 5


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
    return "\n".join([*lines, *network.lines(_layers(model))]) + "\n"


def _layers(model):
    """Returns the layers of the symmetric actor as those of one network, in which each hidden layer is there twice."""
    policy = model.policy
    first, *others = torch_layers(policy.mlp_extractor.policy_net)
    limit, count = robot.OBSERVATION_LIMIT, len(robot.INPUTS)
    swapped = _matrix(*mirror.mirror_of_observation())[:count, :count]
    layers = [(np.identity(count) / limit, np.zeros(count), "cut")]
    layers.append((np.concatenate([first.weights, first.weights @ swapped]) * limit, np.tile(first.bias, 2), first.activation))
    for layer in others:
        zeros = np.zeros_like(layer.weights)
        layers.append((np.block([[layer.weights, zeros], [zeros, layer.weights]]), np.tile(layer.bias, 2), layer.activation))
    (last,) = torch_layers([policy.action_net.linear])
    swapped = _matrix(*mirror.mirror_of_action())
    layers.append((np.concatenate([last.weights, swapped @ last.weights], axis=1) / 2, (last.bias + swapped @ last.bias) / 2, "cut"))
    return [(_rounded(weights), _rounded(bias), activation) for weights, bias, activation in layers]


def _matrix(indices, signs):
    """Returns the matrix of a mirror that is given by indices and signs."""
    return np.identity(len(indices))[indices] * signs[:, None]


def _rounded(numbers):
    return np.vectorize(lambda number: float(f"{number:.{DIGITS}g}"))(numbers)
