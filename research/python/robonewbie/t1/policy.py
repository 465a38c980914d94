"""The T1's walk as a policy file, written from a trained model."""

import numpy as np

from .. import network
from ..network import Dense
from ..train import actor_layers
from . import robot

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
        numbers("sway-degrees-sine-cosine-foot", [*robot.SWAY_DEGREES, robot.FOOT_SHARE]),
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
    """Returns the layers of the actor; the first one clips the observation."""
    first, *others, last = actor_layers(model.policy)
    limit, count = robot.OBSERVATION_LIMIT, len(robot.INPUTS)
    layers = [
        Dense(np.identity(count) / limit, np.zeros(count), "cut"),
        Dense(first.weights * limit, first.bias, first.activation),
        *others,
        Dense(last.weights, last.bias, "cut"),
    ]
    return [Dense(_rounded(layer.weights), _rounded(layer.bias), layer.activation) for layer in layers]


def _rounded(numbers):
    return np.vectorize(lambda number: float(f"{number:.{DIGITS}g}"))(numbers)
