"""Models of the robot; those that need MuJoCo are skipped without it."""

import unittest
from pathlib import Path

import numpy as np

from robonewbie import model_path

try:
    import mujoco
except ImportError:
    mujoco = None

NAMES = ["nao0", "nao1", "nao2", "nao3", "nao4"]


class ModelTest(unittest.TestCase):
    def test_each_robot_type_has_a_file(self):
        self.assertEqual([Path(model_path(name)).stem for name in NAMES], NAMES)
        self.assertEqual(Path(model_path()).stem, "nao0")

    def test_unknown_robots_are_refused(self):
        for name in ["nao5", "", "../model", "NAO0"]:
            with self.assertRaisesRegex(ValueError, "Choose one of nao0, nao1"):
                model_path(name)

    @unittest.skipUnless(mujoco is not None, "mujoco is not installed")
    def test_robot_stands_for_ten_seconds(self):
        for name in NAMES:
            model = mujoco.MjModel.from_xml_path(model_path(name))
            data = mujoco.MjData(model)
            mujoco.mj_forward(model, data)
            height = data.body("torso").xpos[2]

            mujoco.mj_step(model, data, round(10 / model.opt.timestep))

            self.assertAlmostEqual(data.body("torso").xpos[2], height, delta=0.01, msg=name)
            self.assertGreater(data.body("torso").xmat[8], 0.99, name)
            weight = sum(data.sensor(foot).data[0] for foot in ("lf", "rf", "lf1", "rf1")[: 4 if name == "nao4" else 2])
            self.assertAlmostEqual(weight, 9.81 * model.body("torso").subtreemass[0], delta=0.5, msg=name)

    @unittest.skipUnless(mujoco is not None, "mujoco is not installed")
    def test_motors_and_sensors_have_the_names_of_the_messages(self):
        model = mujoco.MjModel.from_xml_path(model_path())
        motors = [model.actuator(i).name for i in range(model.nu)]
        sensors = [model.sensor(i).name for i in range(model.nsensor)]

        self.assertEqual(len(motors), 22)
        self.assertTrue({"he1", "lae4", "rle6"} <= set(motors))
        self.assertTrue({"torso_gyro", "torso_acc", "lf", "rf", "hj1", "llj4", "llj4_speed"} <= set(sensors))

    @unittest.skipUnless(mujoco is not None, "mujoco is not installed")
    def test_arm_moves_at_the_speed_it_is_given(self):
        model = mujoco.MjModel.from_xml_path(model_path())
        data = mujoco.MjData(model)
        data.ctrl[model.actuator("lae1").id] = 1

        mujoco.mj_step(model, data, round(1 / model.opt.timestep))

        self.assertAlmostEqual(np.degrees(data.sensor("laj1").data[0]), np.degrees(1), delta=2)


if __name__ == "__main__":
    unittest.main()
