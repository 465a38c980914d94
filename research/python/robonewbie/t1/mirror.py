"""The mirror image of a robot: its left becomes its right."""

import numpy as np


def _legs_swapped(first):
    return [*range(first + 6, first + 12), *range(first, first + 6)], [1, -1, -1, 1, 1, -1] * 2


def mirror_of_action():
    """Returns indices and signs: ``action[:, indices] * signs`` is the action of the mirrored robot."""
    indices, signs = _legs_swapped(0)
    return np.array(indices), np.array(signs, np.float32)


def mirror_of_inputs():
    """Returns indices and signs: ``observation[:, indices] * signs`` is what the policy of the mirrored robot observes."""
    indices, signs = list(range(5)), [1, -1, -1, 1, -1]  # up, gyro
    for first in (5, 17, 29):
        swapped = _legs_swapped(first)
        indices += swapped[0]
        signs += swapped[1]
    indices += range(41, 46)
    signs += [1, -1, -1, -1, -1]  # command, gait
    return np.array(indices), np.array(signs, np.float32)
