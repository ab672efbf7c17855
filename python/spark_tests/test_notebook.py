"""The notebook of the tutorial runs, from its first cell to its last, and finds what there is."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import beespace

_NOTEBOOK = Path(__file__).resolve().parents[2] / "docs/notebooks/flights-on-a-cluster.ipynb"


def test_the_notebook_runs(session):
    cells = json.loads(_NOTEBOOK.read_text())["cells"]
    names = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            assert cell["outputs"] == [] and cell["execution_count"] is None
            exec("".join(cell["source"]), names)
    try:
        # As one machine says of the same fixes.
        rows = names["fixes"].toPandas().sort_values("seconds", kind="stable")
        numbers = {name: at for at, name in enumerate(sorted(rows.callsign.unique()))}
        positions = beespace.to_ecef(rows.lon.to_numpy(), rows.lat.to_numpy(), rows.height.to_numpy())
        recording = beespace.Recording(rows.callsign.map(numbers).to_numpy(), rows.seconds.to_numpy(), positions)
        wanted = recording.conflicts(3000, max_gap=60)
        assert len(wanted) > 20
        assert names["found"].count() == len(wanted)
        assert names["worst"]["closest_distance"] == wanted.closest_distance.min()
        assert session.read.parquet(f"{names['folder']}/gaps").count() == 44
        assert names["page"].risky
    finally:
        shutil.rmtree(names["folder"])
