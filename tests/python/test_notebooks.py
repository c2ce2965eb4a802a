"""Every notebook runs from its first cell to its last, and warns of nothing."""

import nbclient
import nbformat
import pytest
from conftest import ROOT, TARGET

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(notebook, tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", str(TARGET.absolute() / "package"))
    monkeypatch.setenv("MPLBACKEND", "agg")
    content = nbformat.read(notebook, as_version=4)
    assert not any(cell.get("outputs") for cell in content.cells), "kept without outputs"
    executed = nbclient.NotebookClient(
        content, timeout=120, resources={"metadata": {"path": str(tmp_path)}}
    ).execute()
    code = [cell for cell in executed.cells if cell.cell_type == "code"]
    said = [output for cell in code for output in cell.outputs if output.get("name") == "stderr"]
    assert not said, said
