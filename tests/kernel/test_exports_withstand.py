"""Exports of whole gears when another program, or the system, has a hand on the file."""

from __future__ import annotations

import errno
import os
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from gearstudio.errors import FileError
from gearstudio.methods.gear import ignore, solid_result
from tests.kernel.gears import changed
from tests.kernel.test_exchange import export

pytestmark = pytest.mark.kernel
NAMES = ("step", "brep", "stl", "glb")


@pytest.mark.skipif(os.name == "nt", reason="there an open file cannot be replaced; see the next test")
@pytest.mark.parametrize("kind", NAMES)
def test_a_reader_keeps_what_it_has_opened_and_the_new_file_is_there(kind: str, tmp_path: Path) -> None:
    older = tmp_path / f"pinion-gear.{kind}"
    older.write_text("older")
    with older.open(encoding="utf-8") as reader:
        (made,) = export(tmp_path, (kind,)).run(ignore)
        assert reader.read() == "older"
    assert made.check is not None
    assert older.stat().st_size == made.size > 1000


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("code", [errno.EACCES, errno.EROFS])
def test_a_file_that_must_not_be_replaced_stays_as_it_was(
    kind: str, code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As where the system refuses to replace what another program has opened, or a disk became read-only."""
    older = tmp_path / f"pinion-gear.{kind}"
    older.write_text("older")

    def refuse(*_: Any, **__: Any) -> None:
        raise OSError(code, os.strerror(code), str(older))

    monkeypatch.setattr(os, "replace", refuse)
    with pytest.raises(FileError, match=r"no permission|read-only|open") as told:
        export(tmp_path, (kind,)).run(ignore)
    assert str(older) in str(told.value)
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [(older.name, "older")]


def test_cutting_tells_how_far_it_is() -> None:
    told: list[tuple[str, float]] = []
    design = changed({"pair.pinion_teeth": 17, "pair.wheel_teeth": 18})
    result = solid_result(
        design, "pinion", "point_cloud", "optimised", "cut", lambda *one: told.append((one[0], one[1]))
    )
    assert (result.valid, result.closed) == (True, True)
    assert 0 < result.gap < 5e-5
    shares = [share for _, share in told]
    assert shares == sorted(shares)
    assert sum(stage.startswith("cutting tooth spaces") for stage, _ in told) == 3
    assert max(b - a for a, b in pairwise(shares)) < 0.35
