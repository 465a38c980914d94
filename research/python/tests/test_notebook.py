"""The notebook runs and learns; skipped where Stable-Baselines3 is not installed."""

import ast
import unittest
from pathlib import Path

try:
    import stable_baselines3
except ImportError:
    stable_baselines3 = None

try:
    import nbclient
    import nbformat
except ImportError:
    nbclient = None

NOTEBOOK = Path(__file__).parents[1] / "examples" / "quick_start.ipynb"


@unittest.skipUnless(stable_baselines3, "stable-baselines3 is not installed")
@unittest.skipUnless(nbclient, "nbclient is not installed")
class NotebookTest(unittest.TestCase):
    def test_notebook_learns_and_shows_a_curve_and_a_picture(self):
        notebook = nbformat.read(NOTEBOOK, as_version=4)
        self.assertFalse(any(cell.get("outputs") for cell in notebook.cells), "Clear all outputs of the notebook.")

        nbclient.NotebookClient(notebook, timeout=600).execute()

        outputs = [output.get("data", {}) for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
        self.assertEqual(sum("image/png" in data for data in outputs), 2)
        results = [ast.literal_eval(data["text/plain"]) for data in outputs if set(data) == {"text/plain"}][-1]
        self.assertGreater(results["learned"], results["zero actions"] / 2)
        self.assertGreater(results["learned"], results["random actions"] / 2)


if __name__ == "__main__":
    unittest.main()
