"""Something is learned from nothing, and holds for what was never seen; about a minute."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

EXAMPLE = Path(__file__).parents[1] / "examples" / "learn_to_reach.py"


class LearningTest(unittest.TestCase):
    def test_arm_comes_nearer_to_targets_that_it_has_never_seen(self):
        ended = subprocess.run([sys.executable, str(EXAMPLE), "12"], capture_output=True, text=True)

        self.assertEqual(ended.returncode, 0, ended.stderr)
        told = re.search(r"([0-9.]+) cm before, ([0-9.]+) cm after learning", ended.stdout)
        before, after = map(float, told.groups())
        self.assertGreater(before, 12)
        self.assertLess(after, 9)


if __name__ == "__main__":
    unittest.main()
