"""The tasks of this package with MuJoCo's physics: the same start states, observations, actions and rewards, in a second simulator.

    python -m robonewbie.mujoco walk.policy Stand.policy --n-eval-episodes 20     policies in both worlds

The simulator runs the task, and asks MuJoCo for the motion of each cycle. The model is the exported NAO with a ball; docs/mujoco.md says what
differs.
"""

import argparse
from pathlib import Path

import mujoco
import numpy as np

from robonewbie.environment import RoboNewbieEnv
from robonewbie.evaluate import FIRST_SEED, PlayedPolicy, evaluate
from robonewbie.model import model_path
from robonewbie.simulator import RoboNewbieError
from robonewbie.train import options_of

_CYCLE_SECONDS = 0.02
_BALL = (
    '<body name="ball"><joint name="ball" type="free" armature="0" damping="0.01"/>'
    '<geom name="ball" class="scenery" type="sphere" size="0.042" mass="0.026"/></body></worldbody>'
)
_BALL_ANGULAR_DAMPING = 5e-5
_DAMPING = 25  # of the motors, N m s/rad; with that of the exported model, closed loops such as a walk oscillate
_FEET = ("lfoot", "rfoot", "ltoe", "rtoe")
_NOT_AVAILABLE = {"friction", "sole_friction", "mass", "strength", "true_state"}


class World:
    """A NAO and a ball in MuJoCo.

    :param robot: name of the robot, see :func:`robonewbie.model_path`
    """

    def __init__(self, robot):
        self.robot = robot
        text = Path(model_path(robot)).read_text(encoding="utf-8")
        self.model = model = mujoco.MjModel.from_xml_string(text.replace("</worldbody>", _BALL))
        self.data = mujoco.MjData(model)
        self._steps = round(_CYCLE_SECONDS / model.opt.timestep)
        joints = model.actuator_trnid[:, 0]
        self._angles, self._speeds = model.jnt_qposadr[joints], model.jnt_dofadr[joints]
        ball = model.joint("ball")
        self._ball_place, self._ball_motion = ball.qposadr[0], ball.dofadr[0]
        model.dof_damping[self._ball_motion + 3 : self._ball_motion + 6] = _BALL_ANGULAR_DAMPING
        model.actuator_biasprm[:, 2] = -_DAMPING
        self._lead = _DAMPING / model.actuator_gainprm[:, 0]  # seconds by which a target precedes its angle, since damping slows the motor
        self._links = slice(1, model.body("ball").id)
        names = [model.body(i).name for i in range(model.nbody)]
        self._feet = [names.index(foot) if foot in names else -1 for foot in _FEET]

    def advance(self, state, begins):
        """Advances a state of the simulator by one cycle, and returns the next state. docs/gym-protocol.md describes both."""
        data = self.data
        parts = np.split(state, [3, 7, 10, 13, 16, 19, 22, 25, 28, 28 + self.model.nu, 28 + 2 * self.model.nu])
        data.qpos[:3], data.qpos[3:7], data.qvel[:3], data.qvel[3:6] = parts[:4]
        data.qpos[self._ball_place : self._ball_place + 7] = [*parts[4], 1, 0, 0, 0]
        data.qvel[self._ball_motion : self._ball_motion + 6] = np.concatenate(parts[5:7])
        data.xfrc_applied[self._links.start] = np.concatenate(parts[7:9])
        data.qpos[self._angles], data.qvel[self._speeds], data.ctrl[:] = parts[9:]
        if begins:
            self._targets = parts[9]
            data.qacc_warmstart[:] = 0
        data.act[:] = self._targets + self._lead * data.ctrl
        self._targets = np.clip(self._targets + _CYCLE_SECONDS * data.ctrl, *self.model.actuator_actrange.T)
        contacts = np.zeros((len(_FEET), 7))  # force, point weighted by the force, weight
        for _ in range(self._steps):
            mujoco.mj_step(self.model, data)
            self._add_contacts(contacts)
        mujoco.mj_forward(self.model, data)
        return np.concatenate([self._motions().ravel(), self._ball(), self._readings(contacts).ravel()])

    def _add_contacts(self, sums):
        force = np.zeros(6)
        for i, bodies in enumerate(self.model.geom_bodyid[self.data.contact.geom]):
            for foot, body in enumerate(self._feet):
                if body in bodies:
                    mujoco.mj_contactForce(self.model, self.data, i, force)
                    contact = self.data.contact[i]
                    newtons = force[:3] @ contact.frame.reshape(3, 3) * (1 if body == bodies[1] else -1)
                    weight = np.linalg.norm(newtons)
                    sums[foot] += [*newtons, *(weight * contact.pos), weight]

    def _motions(self):
        """Returns position, rotation, velocity and angular velocity of each link."""
        data, links = self.data, self._links
        turn, velocity = data.cvel[links, :3], data.cvel[links, 3:]
        lever = data.xpos[links] - data.subtree_com[links.start]
        return np.hstack([data.xpos[links], data.xquat[links], velocity + np.cross(turn, lever), turn])

    def _ball(self):
        place, motion = self._ball_place, self._ball_motion
        turn = self.data.xmat[self._links.stop].reshape(3, 3) @ self.data.qvel[motion + 3 : motion + 6]
        return np.concatenate([self.data.qpos[place : place + 3], self.data.qvel[motion : motion + 3], turn])

    def _readings(self, sums):
        """Returns whether each foot has a contact, and the contact's mean point and force in the frame of the foot."""
        readings = np.zeros((len(_FEET), 7))
        for foot, body in enumerate(self._feet):
            weight = sums[foot, 6]
            if weight > 0:
                to_foot = self.data.xmat[body].reshape(3, 3).T
                point = sums[foot, 3:6] / weight - self.data.xpos[body]
                readings[foot] = [1, *(to_foot @ point), *(to_foot @ sums[foot, :3] / self._steps)]
        return readings


class Physics:
    """MuJoCo as the physics engine of the environments of a connection."""

    def __init__(self):
        self._worlds = {}

    def world(self, environment=0, robot="nao0"):
        """Returns the world of an environment."""
        world = self._worlds.get(environment)
        if world is None or world.robot != robot:
            world = self._worlds[environment] = World(robot)
        return world

    def advance(self, message):
        """Responds to the simulator's request to compute a cycle."""
        state = np.frombuffer(message, "<f8")
        environment, robot_type, begins = state[:3].astype(int)
        return self.world(environment, f"nao{robot_type}").advance(state[3:], begins).astype("<f8").tobytes()


class NaoMujocoEnv(RoboNewbieEnv):
    """A task for one robot whose physics MuJoCo computes. Everything else is as in :class:`robonewbie.RoboNewbieEnv`.

    ``model`` and ``data`` are those of MuJoCo; change ``model`` for other masses, motors or friction. ``data`` shows the state after the last step.

    >>> env = NaoMujocoEnv("WalkGait", forward=0.8)
    >>> env.model.geom("ground").friction[0] = 0.7
    """

    def __init__(self, task="Walk", reward="", render_mode=None, **options):
        refused = sorted(_NOT_AVAILABLE & options.keys())
        if refused:
            raise RoboNewbieError(f"MuJoCo has no option {refused[0]}. Use the fields model and data of the environment instead.")
        self._physics = Physics()
        super().__init__(task, reward, render_mode, **options)

    @property
    def model(self):
        """The MjModel of the robot."""
        return self._physics.world().model

    @property
    def data(self):
        """The MjData of the robot."""
        return self._physics.world().data


_COLUMNS = ("policy", "task", "speed (m/s)", "in MuJoCo", "falls", "in MuJoCo", "return", "in MuJoCo", "success", "in MuJoCo")


def _row(policy, task, ours, theirs):
    """Returns the row of a policy in the table of both worlds."""
    cells = [policy, f"`{task}`"]
    for measured in (
        lambda result: f"{np.mean(result.speeds):.2f}",
        lambda result: f"{np.sum(result.falls)} of {len(result.falls)}",
        lambda result: f"{np.mean(result.returns):.2f}",
        lambda result: f"{np.sum(result.successes)} of {len(result.successes)}",
    ):
        cells += [measured(ours), measured(theirs)]
    return cells


def main(words=None):
    """Runs the command line."""
    parser = argparse.ArgumentParser(prog="python -m robonewbie.mujoco", description="Plays policies in RoboNewbie and in MuJoCo, and compares them.")
    parser.add_argument("policy", nargs="+", type=Path, help="policy file")
    parser.add_argument("--task", help="task to play (default: the one that a policy has learned)")
    parser.add_argument("--n-eval-episodes", "--seeds", type=int, default=20, help="number of episodes (default: 20)")
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED, help=f"seed of the first episode (default: {FIRST_SEED})")
    parser.add_argument("--option", action="append", default=[], metavar="NAME=VALUE", help="option of the task, such as forward=0.8")
    wanted = parser.parse_args(words)
    print(f"| {' | '.join(_COLUMNS)} |\n|{'---|' * len(_COLUMNS)}")
    for file in wanted.policy:
        policy = PlayedPolicy(file.read_text(encoding="utf-8"))
        task = wanted.task or policy.task
        settings = wanted.n_eval_episodes, wanted.first_seed, options_of(wanted.option)
        results = [evaluate(task, policy, *settings, physics) for physics in (None, Physics())]
        print(f"| {' | '.join(_row(file.stem, task, *results))} |", flush=True)


if __name__ == "__main__":
    main()
