"""Data sets as Parquet; skipped without pyarrow."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import pyarrow.parquet as pq

    from robonewbie.parquet import convert
except ImportError:
    pq = None

KINDS = {"run": "whole", "cycle": "whole", "true_tilt": "decimal", "heard": "text"}


def described(files, *names):
    return {"files": files, "columns": [{"name": name, "kind": KINDS[name]} for name in names]}


@unittest.skipUnless(pq is not None, "pyarrow is not installed")
class ParquetTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name) / "dataset"
        (self.folder / "cycles").mkdir(parents=True)
        tables = {"cycles": described("cycles/run-*.csv", *KINDS), "runs": described("runs.csv", "run")}
        (self.folder / "dataset.json").write_text(json.dumps({"agent": "Me", "runs": 2, "tables": tables}), encoding="utf-8")
        self.cycles = self.folder / "cycles" / "run-00001-to-00002.csv"
        self.cycles.write_text('run,cycle,true_tilt,heard\n1,1,0.1,\n1,2,,"say ""größer"", now"\n2,1,1.0E-5,\n', encoding="utf-8")
        (self.folder / "runs.csv").write_text("run\n1\n2\n", encoding="utf-8")

    def test_columns_have_the_kinds_of_the_description(self):
        reports = []

        convert(self.folder, reports.append)

        file = pq.ParquetFile(self.folder / "parquet" / "cycles" / "run-00001-to-00002.parquet")
        table = file.read()
        self.assertEqual([str(field.type) for field in table.schema], ["int64", "int64", "double", "string"])
        self.assertEqual(table["true_tilt"].to_pylist(), [0.1, None, 1e-5])
        self.assertEqual(table["heard"].to_pylist(), ["", 'say "größer", now', ""])
        self.assertEqual([file.metadata.row_group(i).num_rows for i in range(file.num_row_groups)], [2, 1])
        self.assertEqual(file.metadata.metadata[b"agent"], b"Me")
        self.assertEqual(pq.read_table(self.folder / "parquet" / "runs.parquet")["run"].to_pylist(), [1, 2])
        self.assertTrue(reports[0].startswith("1/2 ") and reports[1].endswith("runs.parquet, 2 rows"), reports)

    def test_what_cannot_be_read_is_named(self):
        self.cycles.write_text("run,cycle,true_tilt,heard\n1,one,,\n", encoding="utf-8")
        with self.assertRaisesRegex(ValueError, "run-00001-to-00002.csv cannot be read"):
            convert(self.folder)
        self.cycles.write_text("run,cycle\n1,1\n", encoding="utf-8")
        with self.assertRaisesRegex(ValueError, "does not have the columns that dataset.json lists"):
            convert(self.folder)

    def test_folder_without_a_data_set_is_refused_in_one_sentence(self):
        command = [sys.executable, "-m", "robonewbie.parquet", str(self.folder / "cycles")]

        refused = subprocess.run(command, capture_output=True, text=True)

        self.assertEqual(refused.returncode, 1)
        self.assertRegex(refused.stderr, r"^\S+cycles contains no data set of robonewbie record: \S+dataset.json is missing.\n$")


if __name__ == "__main__":
    unittest.main()
