"""The tasks with MuJoCo's physics; skipped without MuJoCo."""

import io
import pickle
import re
import unittest
from contextlib import redirect_stdout
from pathlib import Path
from unittest import mock

import numpy as np
from gymnasium.utils.env_checker import check_env

from robonewbie import RoboNewbieEnv, RoboNewbieError
from robonewbie.evaluate import PlayedPolicy, evaluate

try:
    import mujoco

    from robonewbie.mujoco import NaoMujocoEnv, Physics, main
except ImportError:
    mujoco = None

try:
    import jax
    from mujoco import mjx
except ImportError:
    mjx = None

PROJECT = Path(__file__).parents[3]
POLICIES = PROJECT / "core/agent/src/main/resources/policies"
TASKS = ["Walk", "Stand", "Follow", "EngineRun", "WalkGait", "GetUp", "QuickGetUp", "Kick", "KickTo", "Reach"]


@unittest.skipUnless(mujoco is not None, "mujoco is not installed")
class MujocoTest(unittest.TestCase):
    def environment(self, *arguments, kind=None, **options):
        environment = (kind or NaoMujocoEnv)(*arguments, **options)
        self.addCleanup(environment.close)
        return environment

    def test_spaces_names_units_and_first_observation_are_those_of_the_simulator(self):
        for task in TASKS:
            with self.subTest(task):
                there, here = self.environment(task), self.environment(task, kind=RoboNewbieEnv)

                self.assertEqual(there.description, here.description)
                self.assertEqual((there.observation_space, there.action_space), (here.observation_space, here.action_space))
                np.testing.assert_array_equal(there.reset(seed=3)[0], here.reset(seed=3)[0])

    def test_what_the_task_sees_is_the_state_in_mujoco(self):
        environment = self.environment("Follow")
        environment.reset(seed=1)
        for _ in range(30):
            truth = environment.step(environment.action_space.sample())[-1]
        place, angles = environment.data.body("torso").xpos.copy(), np.degrees(environment.data.actuator_length)

        observation = environment.step(np.zeros(12))[0]

        np.testing.assert_allclose([truth["x"], truth["y"], truth["height"]], place, atol=1e-9)
        joints = [i for i, name in enumerate(environment.observation_names) if name.startswith("joint.")]
        np.testing.assert_allclose(np.sort(observation[joints]), np.sort(angles), atol=0.006)

    def test_equal_seeds_give_equal_episodes(self):
        environment = self.environment("Walk")

        def episode():
            environment.reset(seed=5)
            environment.action_space.seed(1)
            return [environment.step(environment.action_space.sample())[:2] for _ in range(40)][-1]

        first, again = episode(), episode()

        np.testing.assert_array_equal(first[0], again[0])
        self.assertEqual(first[1], again[1])

    def test_robot_stands_on_both_feet_and_falls_when_it_is_pushed(self):
        feet = ["leftFoot.force.up", "rightFoot.force.up"]
        for push, fallen in ((0, False), (60, True)):
            environment = self.environment("Stand", push=push)
            environment.reset(seed=1)
            for _ in range(200):
                observation, _, terminated, _, truth = environment.step(np.zeros(12))
                if terminated:
                    break
            self.assertEqual(truth["fallen"], fallen)
            if not fallen:
                weight = 9.81 * environment.model.body("torso").subtreemass[0]
                forces = [observation[environment.observation_names.index(foot)] for foot in feet]
                self.assertAlmostEqual(sum(forces), weight, delta=2)
                self.assertGreater(min(forces), 0.3 * weight)

    def test_shipped_walk_walks_in_both_worlds(self):
        policy = PlayedPolicy((POLICIES / "walk.policy").read_text(encoding="utf-8"))
        options = {"forward": 0.5, "push": 0, "seconds": 5}

        ours, theirs = (evaluate("WalkGait", policy, 3, options=options, physics=physics) for physics in (None, Physics()))

        self.assertFalse(theirs.falls.any())
        np.testing.assert_allclose(theirs.speeds, ours.speeds, atol=0.1)

    def test_ball_rolls_when_it_is_kicked(self):
        environment = self.environment("KickTo", ball_x=-1, ball_y=0)
        environment.reset(seed=1)
        environment.step(np.zeros(12))
        self.assertAlmostEqual(environment.data.body("ball").xpos[0], -1, delta=0.011)

        environment = self.environment("Kick")
        environment.reset(seed=1)
        travelled = environment.step(np.zeros(12))[-1]["ball_x"]
        self.assertAlmostEqual(travelled, environment.data.body("ball").xpos[0], places=9)

    def test_programs_of_the_page_with_either_interface_are_environments(self):
        page = (PROJECT / "docs" / "mujoco.md").read_text(encoding="utf-8").split("## The tasks in MuJoCo")[1]
        programs = re.findall(r"```python\n(.*?)```", page, re.DOTALL)[:2]
        for program, base in zip(programs, ("NaoMujocoEnv", "MujocoEnv")):
            with self.subTest(base):
                names = {}
                exec(program, names)
                environment = names.get("environment") or names["NaoWalk"]()
                self.addCleanup(environment.close)
                self.assertEqual(type(environment).__base__.__name__, base)
                check_env(environment, skip_render_check=True)

    def test_environments_are_picklable_and_refuse_what_mujoco_does_not_have(self):
        environment = self.environment("Reach")
        copied = pickle.loads(pickle.dumps(environment))
        self.addCleanup(copied.close)
        np.testing.assert_array_equal(copied.reset(seed=2)[0], environment.reset(seed=2)[0])

        with self.assertRaisesRegex(RoboNewbieError, "no option friction.*model and data"):
            NaoMujocoEnv("Walk", friction=0.5)
        with self.assertRaisesRegex(RoboNewbieError, "this scene has 2"):
            NaoMujocoEnv("Match1v1")

    def test_command_prints_a_policy_in_both_worlds(self):
        with redirect_stdout(io.StringIO()) as printed:
            main([str(POLICIES / "kick-to.policy"), "--seeds", "2"])

        self.assertRegex(printed.getvalue(), r"(?m)^\| kick-to \| `KickTo` \| [0-9.]+ \| [0-9.]+ \| \d of 2 \| \d of 2 \|")


@unittest.skipUnless(mjx is not None, "mujoco-mjx is not installed")
class MjxTest(unittest.TestCase):
    def test_step_of_mjx_equals_that_of_mujoco(self):
        from robonewbie import model_path

        model = mujoco.MjModel.from_xml_path(model_path())
        data = mujoco.MjData(model)
        data.ctrl[:] = 0.5
        mujoco.mj_step(model, data, 20)
        device = mjx.put_data(model, data)
        step = jax.jit(mjx.step)
        on_device = mjx.put_model(model)

        for _ in range(5):
            mujoco.mj_step(model, data)
            device = step(on_device, device)

        np.testing.assert_allclose(device.qpos, data.qpos, atol=1e-4)
        np.testing.assert_allclose(device.qvel, data.qvel, atol=1e-2)


if __name__ == "__main__":
    unittest.main()
