"""Training by PPO and what it writes; the parts with Stable-Baselines3 are skipped where it is not installed."""

import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

from robonewbie import curve, train

try:
    import stable_baselines3
except ImportError:
    stable_baselines3 = None


def layers(text):
    """Reads the layers of a policy."""
    lines = iter(text.splitlines())
    for line in lines:
        if line.startswith("layer "):
            _, _, outputs, bend = line.split()
            rows = np.array([[float(word) for word in next(lines).split()] for _ in range(int(outputs))])
            yield rows[:, 1:], rows[:, 0], {"tanh": np.tanh, "cut": lambda x: np.clip(x, -1, 1)}[bend]


class TrainTest(unittest.TestCase):
    def test_folded_layer_does_with_raw_numbers_what_the_other_does_with_normalised_ones(self):
        random = np.random.default_rng(1)
        weights, bias = random.normal(size=(3, 5)), random.normal(size=3)
        mean, variance, raw = random.normal(size=5), random.uniform(1, 9, size=5), random.normal(size=5)

        folded, shifted = train.fold(weights, bias, mean, variance, 1e-8)

        np.testing.assert_allclose(folded @ raw + shifted, weights @ ((raw - mean) / np.sqrt(variance + 1e-8)) + bias)

    def test_curve_is_a_picture_with_a_line_for_each_name(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "walk.policy.csv")
            file.write_text("generation,lessons,cycles,reward\n1,32,1000,-2\n2,32,1000,5\n", encoding="utf-8")

            picture = curve.svg([("walk", *curve.read(file))])

        root = ElementTree.fromstring(picture)
        self.assertIn("walk", [element.text for element in root.iter("{http://www.w3.org/2000/svg}text")])
        self.assertEqual(curve.smoothed([1, 3, 5], 2), [1, 2, 4])

    @unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
    def test_goes_on_and_writes_a_policy_that_does_what_the_model_does(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder, "my.policy")
            with self.assertRaisesRegex(SystemExit, "There is nothing to resume"):
                train.main(["Reach", "--out", str(out), "--resume"])
            words = ["Reach", "--robots", "2", "--round", "32", "--out", str(out)]
            train.main([*words, "--steps", "64"])
            with self.assertRaisesRegex(SystemExit, "There is a training in .* already. Go on with --resume"):
                train.main([*words, "--steps", "64"])
            train.main([*words, "--steps", "256", "--resume"])

            training = train.Training(train._arguments([*words, "--resume"]))
            self.assertEqual(training.model.num_timesteps, 256)
            raw = training.task.reset()[0]
            wanted, _ = training.model.predict(training.normalised.normalize_obs(raw), deterministic=True)
            training.task.close()
            values = raw.astype(float)
            for weights, bias, bend in layers(out.read_text(encoding="utf-8")):
                values = bend(weights @ values + bias)
            np.testing.assert_allclose(values, wanted, atol=2e-3)


if __name__ == "__main__":
    unittest.main()
