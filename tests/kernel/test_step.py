"""STEP files of flanks: the same surfaces after reading back, with their names."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gearstudio.analysis.comparison import build_variant
from gearstudio.catalogue import VARIANTS
from gearstudio.design import Design
from gearstudio.errors import FileError
from gearstudio.kernel.step import read_flanks_step, write_flanks_step
from gearstudio.methods import METHODS

pytestmark = pytest.mark.kernel


@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("method", METHODS, ids=[m.info.id for m in METHODS])
def test_round_trip(method, variant: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    surfaces = {
        name: flank.surface for name, flank in build_variant(Design(), "pinion", method.info.id, variant).flanks.items()
    }
    path = tmp_path / "Ritzel – Zähne.step"
    write_flanks_step(path, surfaces, "pinion-flanks")
    found = read_flanks_step(path)
    assert set(found) == {"concave", "convex"}
    places = np.linspace(0.0, 1.0, 23)
    for name, surface in surfaces.items():
        back = found[name].uniform_grid(23, 23)
        assert np.abs(back - surface.grid(places, places)).max() < 1e-9
        assert (found[name].degree_u, found[name].degree_v) == (surface.degree_u, surface.degree_v)
    assert capfd.readouterr().out == ""


def test_the_file_is_ap242_in_millimetres_with_names(tmp_path: Path) -> None:
    result = build_variant(Design(), "wheel", "point_cloud", "optimised")
    path = tmp_path / "wheel.step"
    write_flanks_step(path, {name: flank.surface for name, flank in result.flanks.items()}, "wheel-flanks")
    text = path.read_text(encoding="ascii")
    assert "AP242" in text.split("DATA;")[0]
    assert "SI_UNIT(.MILLI.,.METRE.)" in text
    for name in ("'concave'", "'convex'", "'wheel-flanks'"):
        assert name in text
    assert text.count("ADVANCED_FACE(") == 2


@pytest.mark.parametrize("content", [None, b"", b"no STEP file at all", b"ISO-10303-21;\nHEADER;\n"])
def test_what_is_no_step_file_is_said(content: bytes | None, tmp_path: Path) -> None:
    path = tmp_path / "broken.step"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(FileError, match=r"broken\.step"):
        read_flanks_step(path)


def test_a_folder_that_is_not_there_is_said(tmp_path: Path) -> None:
    result = build_variant(Design(), "wheel", "point_cloud", "published")
    with pytest.raises(FileError):
        write_flanks_step(
            tmp_path / "missing" / "wheel.step", {n: f.surface for n, f in result.flanks.items()}, "wheel-flanks"
        )
