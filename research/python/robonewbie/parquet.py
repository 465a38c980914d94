"""Converts the tables of ``robonewbie record`` to Apache Parquet (needs ``pip install pyarrow``).

``python -m robonewbie.parquet dataset`` writes the folder ``dataset/parquet`` with the same tables and columns, typed as in
``dataset.json``. Missing decimals are null. In a table of several runs, each run starts a new row group.
"""

import json
import sys
from pathlib import Path

import pyarrow as pa
import pyarrow.csv as csv
import pyarrow.parquet as pq

_TYPES = {"whole": pa.int64(), "decimal": pa.float64(), "text": pa.string()}
_ROWS_PER_GROUP = 20_000


def description(folder):
    """Reads the ``dataset.json`` of a data set."""
    file = Path(folder) / "dataset.json"
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ValueError(f"{folder} contains no data set of robonewbie record: {file} is missing.") from None
    except ValueError as damaged:
        raise ValueError(f"{file} cannot be read: {damaged}.") from None


def read(file, columns):
    """Reads a table of a data set, CSV or Parquet, with the columns that ``dataset.json`` lists for it."""
    if file.suffix == ".parquet":
        return pq.read_table(file)
    types = {column["name"]: _TYPES[column["kind"]] for column in columns}
    try:
        table = csv.read_csv(
            file,
            parse_options=csv.ParseOptions(newlines_in_values=True),
            convert_options=csv.ConvertOptions(column_types=types, null_values=[""], strings_can_be_null=False),
        )
    except pa.ArrowInvalid as damaged:
        raise ValueError(f"{file} cannot be read: {damaged}") from None
    if table.column_names != list(types):
        raise ValueError(f"{file} does not have the columns that dataset.json lists.")
    return table


def convert(folder, report=print):
    """Converts all tables of a data set into its subfolder ``parquet``, and reports each one."""
    folder = Path(folder)
    known = description(folder)
    facts = {name: value for name, value in known.items() if isinstance(value, str)}
    tables = [(file, table) for table in known["tables"].values() for file in sorted(folder.glob(table["files"]))]
    if not tables:
        raise ValueError(f"{folder} contains no table yet.")
    for number, (file, table) in enumerate(tables, start=1):
        target = (folder / "parquet" / file.relative_to(folder)).with_suffix(".parquet")
        rows = read(file, table["columns"]).replace_schema_metadata(facts)
        _write(rows, target, by_run=file.parent != folder)
        report(f"{number}/{len(tables)} {target}, {len(rows)} rows")


def _write(table, target, by_run):
    target.parent.mkdir(parents=True, exist_ok=True)
    part = target.with_suffix(".part")
    runs = table["run"].to_pylist() if by_run else []
    begins = [0] + [i for i in range(1, len(runs)) if runs[i] != runs[i - 1]]
    with pq.ParquetWriter(part, table.schema, compression="gzip") as writer:
        for begin, end in zip(begins, begins[1:] + [len(table)]):
            writer.write_table(table.slice(begin, end - begin), row_group_size=_ROWS_PER_GROUP)
    part.replace(target)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("Usage: python -m robonewbie.parquet FOLDER-OF-ROBONEWBIE-RECORD")
    try:
        convert(sys.argv[1])
    except (OSError, ValueError) as failure:
        sys.exit(str(failure))
