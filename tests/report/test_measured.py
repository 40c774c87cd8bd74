"""Measured points in the report: their errors as numbers, the figures, and what is said when they do not fit."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from gearstudio.analysis.measurement import MeasuredPoints, measure
from gearstudio.design import Design, with_field
from gearstudio.report.blocks import Picture, Table, Text
from gearstudio.report.chapters import chapter
from gearstudio.report.content import Beside, gather
from gearstudio.report.document import Order, compose
from gearstudio.report.language import language, speaking, told
from gearstudio.report.measuring import Measured, MeasuredFile, compared, read_file
from gearstudio.report.store import Store, Taken
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.modified import flank_of

ADDED_MM = 5e-3
KEY = "measurement"


def _points(teeth: int = 2, added_mm: float = ADDED_MM) -> MeasuredPoints:
    """Of the wheel: a grid on both flanks of a few teeth, with metal added along the normals towards the heel."""
    wheel = pair_geometry(Design()).wheel
    u, v = np.linspace(0.1, 0.9, 4)[:, None], np.linspace(0.05, 0.95, 6)[None, :]
    found = []
    for flank in (flank_of(wheel, "concave"), flank_of(wheel, "convex")):
        points = flank.points(u, v) + added_mm * v[..., None] * flank.normals(u, v)
        for turn in 2 * np.pi / wheel.teeth * np.arange(teeth):
            cos, sin = np.cos(turn), np.sin(turn)
            matrix = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
            found.append((points @ matrix.T).reshape(-1, 3))
    return MeasuredPoints(np.concatenate(found))


def _file(points: MeasuredPoints, fit: tuple[bool, bool] = (False, False)) -> MeasuredFile:
    return MeasuredFile("part.csv", "wheel", (points,), fit)


def _blocks(file: MeasuredFile | Measured, store: Store) -> list[object]:
    content = gather(Design(), "pinion", (KEY,), lambda *_: None, Beside(measured=file))
    return list(chapter(KEY, content, store).blocks)


def test_the_numbers_are_those_of_the_measurement() -> None:
    points = _points()
    result = measure(pair_geometry(Design()), "wheel", [points], turn=False, shift=False)
    store = Store()
    blocks = _blocks(_file(points), store)
    whole, flanks = (block for block in blocks if isinstance(block, Table))
    shown = {row[0]: row[1:] for row in (*whole.rows, *flanks.rows)}
    assert float(shown["Largest deviation without its sign"][0]) == pytest.approx(result.statistics.max_um, abs=1e-3)
    assert shown["Teeth measured"][0] == "2 / 40" and shown["Points"][:2] == ("48", "48")
    for column, name in enumerate(("concave", "convex")):
        own = result.deviation_um[np.asarray(result.flanks) == name]
        assert float(shown["Highest deviation"][column]) == pytest.approx(own.max(), abs=0.006)
        assert float(shown["Spiral angle"][column]) == pytest.approx(result.form[name].spiral_um, abs=0.006)  # type: ignore[index]
    assert {block.file for block in blocks if isinstance(block, Picture)} == {"measured.svg", "pitch.svg"}
    assert set(store.files) == {"measured.svg", "pitch.svg"}
    assert any("There was no best fit" in block.text for block in blocks if isinstance(block, Text))


def test_one_tooth_has_no_pitch_and_scattered_points_are_drawn_too() -> None:
    store = Store()
    one = _points(1).points
    _blocks(_file(MeasuredPoints(one[np.random.default_rng(1).permutation(len(one))[:30]])), store)
    assert set(store.files) == {"measured.svg"}


def test_points_of_one_flank_alone() -> None:
    one = _points()
    half = MeasuredPoints(one.points[: len(one.points) // 2])
    assert any(isinstance(block, Table) for block in _blocks(_file(half), Store()))


def test_points_of_another_gear_are_noted_and_the_rest_is_made() -> None:
    design = with_field(Design(), "pair.wheel_teeth", 61)
    order = Order(("design", KEY), "wheel", "en", Beside(measured=_file(_points(9), (True, True))))
    pages = compose(design, order, Taken, lambda *_: None)
    assert [one.key for one in pages.chapters] == ["design", KEY]
    assert any(name == "Note" for name, _ in pages.facts)
    assert "see the notes" in pages.chapters[1].blocks[0].text  # type: ignore[union-attr]


@pytest.mark.parametrize("code", ["en", "de", "zh"])
def test_points_that_may_be_of_another_gear_are_warned_of(code: str) -> None:
    """The same cutter radius as the window and `measure` name, in the chapter and on the first page."""
    cut = with_field(Design(), "lengthwise.cutter_radius", 78.0)
    order = Order((KEY,), "wheel", code, Beside(measured=_file(_points(9, 0.0), (True, True))))
    (doubt,) = compared(cut, pair_geometry(cut), order.beside.measured).result.warnings  # type: ignore[arg-type]
    assert doubt.field == "lengthwise.cutter_radius" and "78 mm it would be 0.00 µm" in doubt.message
    with speaking(language(code)):
        said = told(doubt.message)
    assert (said == doubt.message) == (code == "en")
    pages = compose(cut, order, Taken, lambda *_: None)
    said = said if pages.language == code else doubt.message
    assert f"{said}." in [value for _, value in pages.facts]
    assert any(said in block.text for block in pages.chapters[0].blocks if isinstance(block, Text))


def test_points_that_fit_are_not_warned_of() -> None:
    pages = compose(Design(), Order((KEY,), "wheel", "en", Beside(measured=_file(_points()))), Taken, lambda *_: None)
    assert not any(name == "Warning" for name, _ in pages.facts)
    assert not any(block.text.startswith("Warning") for block in pages.chapters[0].blocks if isinstance(block, Text))


def test_without_points_there_is_no_section() -> None:
    pages = compose(Design(), Order(("design", KEY), "wheel"), Taken, lambda *_: None)
    assert [one.key for one in pages.chapters] == ["design"]


def test_a_file_is_read_and_what_is_compared_stays(tmp_path: Path) -> None:
    path = tmp_path / "part.csv"
    np.savetxt(path, _points().points, delimiter=",", header="x,y,z", comments="")
    pair = pair_geometry(Design())
    file = read_file(path, pair, "wheel", lambda *_: None)
    assert file.name == "part.csv" and sum(len(part.points) for part in file.chunks) == 96
    found = compared(Design(), pair, replace(file, fit=(False, False)))
    assert compared(Design(), pair, found) is found
    assert found.result.statistics.max_um == pytest.approx(1e3 * ADDED_MM * 0.95, rel=0.02)
