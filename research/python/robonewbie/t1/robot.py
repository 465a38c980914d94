"""The Booster T1 of RCSSServerMJ: its model, the stance and gains of its motors, and what its policy observes.

The model is read from the installed package ``rcsssmj`` (``pip install rcsssmj==0.2.1``).
"""

import importlib.util
import math
import re
from pathlib import Path

import numpy as np

CYCLE_SECONDS = 0.02
CYCLES_PER_ACTION = 2
ACTION_SECONDS = CYCLE_SECONDS * CYCLES_PER_ACTION
STEPS_PER_CYCLE = 4  # of the physics

LEG = ("hip pitch", "hip roll", "hip yaw", "knee pitch", "foot pitch", "foot roll")
MOTORS = (
    *("he1", "he2"),
    *("lae1", "lae2", "lae3", "lae4"),
    *("rae1", "rae2", "rae3", "rae4"),
    "te1",
    *("lle1", "lle2", "lle3", "lle4", "lle5", "lle6"),
    *("rle1", "rle2", "rle3", "rle4", "rle5", "rle6"),
)
FIRST_LEG_MOTOR = MOTORS.index("lle1")
LEG_MOTORS = MOTORS[FIRST_LEG_MOTOR:]

# Angles in degrees, gains in Nm/rad and Nm·s/rad. A damping of 5 makes the light feet rattle in the air.
_LEG_STANCE = (-20, 0, 0, 40, -20, 0)
STANCE_DEGREES = np.array([0, 0, 0, -80, 0, -23, 0, 80, 0, 23, 0, *_LEG_STANCE, *_LEG_STANCE], float)
STIFFNESS = np.array([40] * 10 + [200] * 13, float)
DAMPING = np.array([1.5] * 10 + [5] + [5, 5, 5, 5, 2, 2] * 2)
# An action of 1 moves the target this far from the stance.
RANGE_DEGREES = np.array([20, 12, 10, 22, 20, 12] * 2, float)

# Without a policy, the robot steps in place in a rhythm. The swinging leg is bent by this much at the hip and the foot, and twice as much
# at the knee.
LIFT_DEGREES = 14
# How far both hips roll to the left with the sine and with the cosine of the gait clock, and the share of it by which the feet roll back.
SWAY_DEGREES = np.array([1.2, -1.6])
FOOT_SHARE = 0.6
# How far the legs swing around the stance at the largest command: forward (hip pitch), left (hip roll) and in turns (hip yaw).
SWING_DEGREES = np.array([3, 3, 6])
GAIT_ACTIONS = 10  # actions per stride, which is two steps: 2.5 strides per second
MAX_COMMAND = np.array([0.6, 0.3, 45])  # forward and left in m/s, turn to the left in degrees/s
MAX_BACKWARD = 0.2
MAX_CHANGE = MAX_COMMAND / 12  # of the command, per action

GRAVITY_TRUST = CYCLE_SECONDS / 0.8
MIN_ACCELERATION, MAX_ACCELERATION = 5, 20

OBSERVATION_LIMIT = 5
#: Name and unit of each input of the policy: its observation is the quantity in this unit.
INPUTS = (
    *(("up.forward", "0.3"), ("up.left", "0.3")),
    *((f"gyro.{axis}", "100 degrees/s") for axis in ("forward", "left", "up")),
    *((f"angle-from-stance.{motor}", "30 degrees") for motor in LEG_MOTORS),
    *((f"speed.{motor}", "150 degrees/s") for motor in LEG_MOTORS),
    *((f"previous-action.{motor}", "1") for motor in LEG_MOTORS),
    *(("command.forward", "0.6 m/s"), ("command.left", "0.3 m/s"), ("command.turn", "45 degrees/s")),
    *(("gait.sine", "1"), ("gait.cosine", "1")),
)


def model_text():
    """Returns the server's model of the T1.

    :raises FileNotFoundError: if the server is not installed
    """
    found = importlib.util.find_spec("rcsssmj")
    if not found:
        raise FileNotFoundError("The model of the T1 is part of RCSSServerMJ: pip install rcsssmj==0.2.1")
    return (Path(found.origin).parent / "resources/robots/T1/robot.xml").read_text(encoding="utf-8")


def scene_text():
    """Returns an MJCF model with one T1 on a plane, with the motors, sensors and physics that it has on the server.

    The torque of the server's motors, ``kp (q* - q) - kd dq`` in each step of the physics, is that of MuJoCo's general actuators. Meshes
    that are only for display are left out. Two touch sensors and the positions of the feet are added for rewards.
    """
    text = re.sub(r"<!--.*?-->", "", model_text(), flags=re.S)
    text = re.sub(r"<mesh [^>]*/>", "", text)
    text = re.sub(r'<geom class="visual"[^>]*/>', "", text)
    joints = dict(re.findall(r'<position name="(\w+)_pos" joint="(\w+)"/>', text))
    motors = "".join(
        f'<general name="{motor}" joint="{joints[motor]}" gainprm="{kp}" biastype="affine" biasprm="0 {-kp} {-kd}"/>'
        for motor, kp, kd in zip(MOTORS, STIFFNESS, DAMPING)
    )
    text = re.sub(r"<actuator>.*</actuator>", f"<actuator>{motors}</actuator>", text, flags=re.S)
    feet = ""
    for side in ("left", "right"):
        text = re.sub(
            rf'(<geom class="collision" name="{side}_foot"[^>]*/>)',
            rf'\1<site name="{side}_sole" type="box" size="0.13 0.07 0.03" pos="0.01 0 -0.015"/>',
            text,
        )
        feet += f'<touch name="{side}_touch" site="{side}_sole"/><framepos name="{side}_foot" objtype="geom" objname="{side}_foot"/>'
    text = text.replace("</sensor>", feet + "</sensor>")
    text = text.replace("<worldbody>", '<worldbody><geom name="floor" type="plane" size="0 0 1"/>', 1)
    return text.replace("<default>", '<option timestep="0.005" density="1.2" viscosity="0.00002"/><default>', 1)


def target_degrees(action, clock, command):
    """Returns the targets of all motors, in the order of ``MOTORS``: the stance, the rhythm of the legs, and the action.

    :param action: actions of shape (robots, 12)
    :param clock: sine and cosine of the gait clock of each robot
    :param command: command of each robot
    """
    targets = np.tile(STANCE_DEGREES, (len(action), 1))
    ahead, left, turn = (command / MAX_COMMAND * SWING_DEGREES).T
    sway = clock @ SWAY_DEGREES
    for first, side in ((FIRST_LEG_MOTOR, 1), (FIRST_LEG_MOTOR + 6, -1)):
        lift = LIFT_DEGREES * np.maximum(0, side * clock[:, 0])
        swing = -side * clock[:, 1]  # -1 at the end of the stance, 1 at the end of the swing
        hip_roll, foot_roll = left * swing + sway, -left * swing - FOOT_SHARE * sway
        rhythm = [-lift - ahead * swing, hip_roll, turn * swing, 2 * lift, 0.7 * ahead * swing - lift, foot_roll]
        targets[:, first : first + 6] += np.column_stack(rhythm)
    targets[:, FIRST_LEG_MOTOR:] += np.clip(action, -1, 1) * RANGE_DEGREES
    return targets


def approached(command, wanted):
    """Returns the command of the next action: the wanted one, or one on the way to it, in half a second to the largest one."""
    return command + np.clip(wanted - command, -MAX_CHANGE, MAX_CHANGE)


class TiltFilter:
    """Estimates the direction of up in the torso's frame from gyroscope and accelerometer, once per cycle, for many robots at once.

    The gyroscope turns the estimate; the accelerometer, which at rest points up, corrects its drift with a time constant of 0.8 s.
    Readings below 5 and above 20 m/s² are impacts and ignored.
    """

    def __init__(self, robots=1):
        self.up = np.tile([0.0, 0, 1], (robots, 1))

    def update(self, gyro_degrees, acceleration):
        """Adds the readings of a cycle, both of shape (robots, 3)."""
        up = self.up + np.cross(self.up, np.radians(gyro_degrees)) * CYCLE_SECONDS
        strength = np.linalg.norm(acceleration, axis=1, keepdims=True)
        trusted = (strength > MIN_ACCELERATION) & (strength < MAX_ACCELERATION)
        up += GRAVITY_TRUST * trusted * (acceleration / np.maximum(strength, 1e-9) - up)
        self.up = up / np.linalg.norm(up, axis=1, keepdims=True)


class GaitClock:
    """Phase and amplitude of the gait, once per action, for many robots at once.

    The amplitude rises from 0 to 1 within a stride while there is a command, and falls back within a stride without one.
    """

    def __init__(self, robots=1):
        self.actions = np.zeros(robots, int)
        self.amplitude = np.zeros(robots)

    def update(self, command):
        """Advances the phase, which begins at 0 whenever the robot begins to walk."""
        moving = np.any(command != 0, axis=1)
        self.actions = np.where(self.amplitude > 0, self.actions + 1, 0) % GAIT_ACTIONS
        self.amplitude = np.clip(self.amplitude + np.where(moving, 1, -1) / GAIT_ACTIONS, 0, 1)
        self.amplitude[self.amplitude < 0.5 / GAIT_ACTIONS] = 0

    def sine_and_cosine(self):
        """Returns sine and cosine of the phase, times the amplitude. The left foot swings while the sine is positive, the right one while it is negative."""
        angle = 2 * math.pi * self.actions / GAIT_ACTIONS
        return np.column_stack([np.sin(angle), np.cos(angle)]) * self.amplitude[:, None]


def observation(up, gyro_degrees, leg_degrees, leg_speeds, previous_action, command, clock):
    """Returns the inputs of the policy, in the order of ``INPUTS``. Each argument has one row per robot."""
    parts = [
        up[:, :2] / 0.3,
        gyro_degrees / 100,
        (leg_degrees - STANCE_DEGREES[FIRST_LEG_MOTOR:]) / 30,
        leg_speeds / 150,
        previous_action,
        command / MAX_COMMAND,
        clock,
    ]
    return np.clip(np.concatenate(parts, axis=1), -OBSERVATION_LIMIT, OBSERVATION_LIMIT).astype(np.float32)


def limited(command):
    """Scales commands down to the limits of the walk, as WalkVelocity.within: half of one maximum leaves half of the others."""
    most = np.where(command < 0, [MAX_BACKWARD, *MAX_COMMAND[1:]], MAX_COMMAND)
    return command / np.maximum(1, np.abs(command / most).sum(axis=-1, keepdims=True))
