"""Plays a policy on a running RCSSServerMJ, with what the server sends except the robot's true pose, which serves for measuring only.

In each cycle of 20 ms the player reads one message and sends one: a target, stiffness and damping for each of the 23 motors.
It runs the tilt filter in each cycle, and in every second cycle the policy, whose targets are held for two cycles.
"""

import re
import socket

import numpy as np

from ..league import Connection
from . import robot

SETTLING_CYCLES = 75
RAISING_CYCLES = 40
FALLEN_HEIGHT = 0.45
COMMAND_CYCLES = 150
_NUMBER = rb"(-?[\d.]+(?:e[-+]?\d+)?|nan)"
_HINGE = re.compile(rb"\(HJ \(n \w+\)\(ax " + _NUMBER + rb"\)\(vx " + _NUMBER + rb"\)\)")
_GYRO = re.compile(rb"torso_gyro\) \(rt ([^)]*)\)")
_ACCELEROMETER = re.compile(rb"torso_acc\) \(a ([^)]*)\)")
_POSITION = re.compile(rb"torso_pos\) \(p ([^)]*)\)")
_ORIENTATION = re.compile(rb"torso_quat\) \(q ([^)]*)\)")


def _vector(pattern, message):
    return np.array(pattern.search(message)[1].split(), float)


def _true_heading(message):
    w, x, y, z = _vector(_ORIENTATION, message)
    return np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


class Walker:
    """The walk of one robot: sensor readings in, targets out."""

    def __init__(self, act):
        self._act = act
        self._tilt, self._clock = robot.TiltFilter(), robot.GaitClock()
        self._action, self._command = np.zeros((1, 12)), np.zeros((1, 3))
        self._cycle = 0

    def sense(self, gyro, acceleration):
        """Adds the readings of a cycle to the tilt filter."""
        self._tilt.update(gyro[None], acceleration[None])

    def targets(self, gyro, angles, speeds, command):
        """Returns the targets of all motors in degrees. Call this method once per cycle."""
        if self._cycle % robot.CYCLES_PER_ACTION == 0:
            legs = slice(robot.FIRST_LEG_MOTOR, None)
            self._command = robot.approached(self._command, np.array([command], float))
            self._clock.update(self._command)
            observed = robot.observation(
                self._tilt.up, gyro[None], angles[None, legs], speeds[None, legs], self._action, self._command, self._clock.sine_and_cosine()
            )
            self._action = self._act(observed)
        self._cycle += 1
        return robot.target_degrees(self._action, self._clock.sine_and_cosine(), self._command)[0]


def _order(targets):
    return b"".join(
        b"(%s %.2f 0 %g %g 0)" % (motor.encode(), target, kp, kd)
        for motor, target, kp, kd in zip(robot.MOTORS, targets, robot.STIFFNESS, robot.DAMPING)
    )


def play(act, address, seconds, command=None, heading=0, seed=1, place=(-20, 0)):
    """Lets one robot walk on a server, and returns a summary as a dictionary.

    :param command: constant command (forward, left, turn); random ones, a new one every 3 s, if it is omitted
    :param heading: direction at the start in degrees
    """
    random = np.random.default_rng(seed)
    server = Connection(socket.create_connection(address))
    server.send(b"(init T1 RoboNewbie 2)")
    walker, track, fallen_after = Walker(act), [], None
    now = np.zeros(3)
    try:
        for cycle in range(SETTLING_CYCLES + round(seconds / robot.CYCLE_SECONDS)):
            message = server.receive()
            if cycle == 0:
                server.send(b"(beam %g %g %g)" % (*place, heading))
                continue
            gyro, acceleration = _vector(_GYRO, message), _vector(_ACCELEROMETER, message)
            joints = np.array(_HINGE.findall(message), float)
            walker.sense(gyro, acceleration)
            walking = cycle - SETTLING_CYCLES
            if walking < 0:
                targets = robot.STANCE_DEGREES * min(1, cycle / RAISING_CYCLES)
            else:
                if walking % COMMAND_CYCLES == 0:
                    now = np.array(command if command is not None else _random_command(random), float)
                targets = walker.targets(gyro, joints[:, 0], joints[:, 1], now)
                position = _vector(_POSITION, message)
                track.append([*position, _true_heading(message), *now])
                if fallen_after is None and position[2] < FALLEN_HEIGHT:
                    fallen_after = walking * robot.CYCLE_SECONDS
            server.send(_order(targets))
    finally:
        server.close()
    return _summary(np.array(track), fallen_after)


def _random_command(random):
    if random.uniform() < 0.25:
        return np.zeros(3)
    drawn = random.uniform([-robot.MAX_BACKWARD, *-robot.MAX_COMMAND[1:]], robot.MAX_COMMAND)
    return robot.limited(drawn * (random.uniform(size=3) < 0.6))


def _summary(track, fallen_after):
    until = len(track) if fallen_after is None else max(2, int(fallen_after / robot.CYCLE_SECONDS))
    track = track[:until]
    heading = np.unwrap(track[:, 3])
    moved = np.diff(track[:, :2], axis=0)
    cosine, sine = np.cos(heading[:-1]), np.sin(heading[:-1])
    seconds = len(moved) * robot.CYCLE_SECONDS
    ahead, left = (cosine * moved[:, 0] + sine * moved[:, 1]).sum(), (cosine * moved[:, 1] - sine * moved[:, 0]).sum()
    wanted = track[:-1, 4:].sum(axis=0) * robot.CYCLE_SECONDS
    return {
        "seconds": round(seconds, 2),
        "fallen_after": fallen_after,
        "metres_forward_left": (round(float(ahead), 2), round(float(left), 2)),
        "turned_degrees": round(float(np.degrees(heading[-1] - heading[0])), 1),
        "wanted": tuple(round(float(number), 2) for number in wanted),
        "lowest_torso": round(float(track[:, 2].min()), 3),
    }
