"""Evaluation of a walk on seeds that training does not use."""

import numpy as np

from . import robot
from .environment import COMMAND_ACTIONS, Variation, WalkingRobots

FIRST_SEED = 900_000_001  # training uses multiples of 10,000,000
SECONDS = 20
COMMANDS = {
    "forward 0.6 m/s": (0.6, 0, 0),
    "forward 0.3 m/s": (0.3, 0, 0),
    "backward 0.2 m/s": (-0.2, 0, 0),
    "left 0.3 m/s": (0, 0.3, 0),
    "right 0.3 m/s": (0, -0.3, 0),
    "turn left 45 °/s": (0, 0, 45),
    "turn right 45 °/s": (0, 0, -45),
    "stand": (0, 0, 0),
    "forward 0.3 m/s, turn left 22 °/s": (0.3, 0, 22),
}


def evaluate(act, robots, seed=FIRST_SEED, command=None, variation=Variation(), seconds=SECONDS):
    """Lets robots walk, and returns what was measured; means are those of robots that have not fallen, after the first second.

    :param act: function from observations to actions
    :param command: constant command (forward, left, turn); random ones, a new one every 3 s, if it is omitted
    """
    world = WalkingRobots(robots, seed, variation, command, restart=False)
    observed = world.reset()
    fallen = np.zeros(robots, bool)
    errors, velocities, air, tilt, steps = [], [], [], [], np.zeros(robots)
    touched = world.touch.copy()
    for action in range(round(seconds / robot.ACTION_SECONDS)):
        wanted = world.wanted.copy()
        world.step_async(act(observed))
        observed, *_ = world.step_wait()
        fallen |= world.fallen
        steps += (world.touch & ~touched).sum(axis=1)
        touched = world.touch.copy()
        if action * robot.ACTION_SECONDS < 1:
            continue
        velocities.append(world.moved.T)
        air.append(~world.touch.any(axis=1))
        tilt.append(np.degrees(np.arcsin(np.minimum(1, np.linalg.norm(world.true_up(), axis=1)))))
        if action % COMMAND_ACTIONS == COMMAND_ACTIONS - 1:
            last = np.mean(velocities[-robot.GAIT_ACTIONS * 2 :], axis=0).T
            errors.append(np.abs(last - wanted))
    world.close()
    up = ~fallen
    mean = np.mean(velocities, axis=0).T
    none = np.full(3, np.nan)
    return {
        "robots": robots,
        "falls": int(fallen.sum()),
        "velocity": mean[up].mean(axis=0) if up.any() else none,
        "error": np.mean(errors, axis=0)[up].mean(axis=0) if up.any() else none,
        "steps_per_second": steps[up].mean() / seconds if up.any() else np.nan,
        "no_foot_down": np.mean(air, axis=0)[up].mean() if up.any() else np.nan,
        "tilt_degrees": np.mean(tilt, axis=0)[up].mean() if up.any() else np.nan,
    }


def report(act, robots, seed=FIRST_SEED):
    """Prints a table: random commands with all that varies in training, at each delay, and then each command alone."""
    print(f"{'':36} falls   forward   left   turn °/s   steps/s   no foot down   tilt")
    total = 0
    for delay in (0, 1, 2):
        found = evaluate(act, robots, seed + delay, variation=Variation(delay_cycles=(delay, delay)))
        total += found["falls"]
        _print(f"random, delay {20 * delay} ms: error", found, found["error"])
    for name, command in COMMANDS.items():
        found = evaluate(act, max(4, robots // 4), seed + 10, command)
        _print(name, found, found["velocity"])
    return total


def _print(name, found, triple):
    forward, left, turn = triple
    print(
        f"{name:36} {found['falls']:2d}/{found['robots']:<3d} {forward:7.2f} {left:7.2f} {turn:8.1f} {found['steps_per_second']:10.1f} "
        f"{found['no_foot_down']:12.1%} {found['tilt_degrees']:8.1f}",
        flush=True,
    )
