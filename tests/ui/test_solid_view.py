"""Solids on a real screen: drawn, turned by matrices, cut, coloured, coarse while they move, measured."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QObject, QPointF

from gearstudio.design import Design
from gearstudio.theory.cones import pair_geometry
from tests.ui.made_up_solid import solid_of
from tests.ui.screen import NEEDS_SCREEN
from ui.session import Key

pytestmark = NEEDS_SCREEN
WORDS = ("Pair", "up to date")
PAIR_KEYS = tuple(Key(member, "rotating_line", "optimised") for member in ("pinion", "wheel"))


@pytest.fixture(scope="module")
def built():
    from ui.solids import meshed

    design = Design()
    return {key: meshed(design, solid_of(design, key.member)) for key in PAIR_KEYS}


def show(view, built, keys=PAIR_KEYS, **options) -> None:
    from ui.solid_layers import SolidOptions

    view.show(pair_geometry(Design()), keys, built, SolidOptions(**options), WORDS)


def picture(qtbot, view) -> np.ndarray:
    """Pixels as they are once the picture stands still, (height, width, 3)."""
    view.grid.viewport.update()
    qtbot.waitUntil(lambda: not view.grid.viewport._moving, timeout=3000)
    qtbot.wait(120)
    image = view.grid.viewport.grabFramebuffer().convertToFormat(
        view.grid.viewport.grabFramebuffer().Format.Format_RGB32
    )
    raw = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine() // 4, 4)
    return raw[:, : image.width(), 2::-1].astype(int)


def share(one: np.ndarray, other: np.ndarray) -> float:
    """Share of pixels that differ."""
    return float((np.abs(one - other).max(axis=2) > 12).mean())


def near(pixels: np.ndarray, color: str) -> float:
    """Share of pixels of a colour."""
    wanted = [int(color[i : i + 2], 16) for i in (1, 3, 5)]
    return float((np.abs(pixels - wanted).max(axis=2) < 10).mean())


def test_the_pair_is_drawn_and_turns_by_matrices_alone(qtbot, view, built) -> None:
    show(view, built)
    view.grid.set_view("pair")
    before = picture(qtbot, view)
    buffers = {
        slot: (buffer.layer, buffer.mesh.GetPoints().GetMTime()) for slot, buffer in view.grid.store._buffers.items()
    }
    frames = view.grid.viewport.frames
    view.turn(0.17)
    after = picture(qtbot, view)
    assert 0.02 < share(before, after) < 0.6
    assert view.grid.viewport.frames > frames
    now = {
        slot: (buffer.layer, buffer.mesh.GetPoints().GetMTime()) for slot, buffer in view.grid.store._buffers.items()
    }
    assert now == buffers
    view.turn(2 * np.pi / 17)
    assert share(before, picture(qtbot, view)) < 0.01


def test_it_is_coarse_only_while_it_moves(qtbot, view, built) -> None:
    show(view, built, keys=PAIR_KEYS[1:])
    view.grid.set_view("iso")
    view.grid.viewport.software = True
    seen: list[bool] = []
    view.grid.viewport.drawing.connect(seen.append)
    picture(qtbot, view)
    view.grid.viewport.set_moving()
    view.grid.viewport.update()
    qtbot.waitUntil(lambda: True in seen, timeout=3000)
    actors = view.grid.store._actors[0]
    qtbot.waitUntil(lambda: seen[-1] is False, timeout=3000)
    shown = {key for key, actor in actors.items() if actor.GetVisibility()}
    assert all(key.endswith("fine") for key in shown) and len(shown) == 4
    view.grid.store.set_coarse(True)
    assert {key for key, actor in actors.items() if actor.GetVisibility()} == {
        k for k in actors if k.endswith("coarse")
    }


def test_a_section_takes_metal_away_and_shows_flat_cut_faces(qtbot, view, built) -> None:
    from ui.section import Plane
    from ui.solid_layers import PAINTS

    show(view, built)
    view.grid.set_view("pair")
    whole = picture(qtbot, view)
    assert near(whole, PAINTS["wheel"].cut.light) < 0.002
    view.plane = Plane(1, 0.0, -1)
    show(view, built)
    cut = picture(qtbot, view)
    for member in ("pinion", "wheel"):
        assert near(cut, PAINTS[member].cut.light) > 0.01
    view.turn(0.4)
    show(view, built)
    assert near(picture(qtbot, view), PAINTS["pinion"].cut.light) > 0.01
    view.close()
    view.turn(0.0)
    show(view, built)
    assert share(whole, picture(qtbot, view)) < 0.01


def test_flanks_take_the_colours_of_their_deviation(qtbot, view, built) -> None:
    show(view, built, keys=PAIR_KEYS[1:])
    view.grid.set_view("iso")
    plain = picture(qtbot, view)
    view.grid.set_color_range(1e-9)
    show(view, built, keys=PAIR_KEYS[1:], deviation=True)
    colored = picture(qtbot, view)
    spread = colored.max(axis=2) - colored.min(axis=2)
    assert (spread > 90).mean() > 0.05 > (plain.max(axis=2) - plain.min(axis=2) > 90).mean()


def test_teeth_of_theory_stand_in_for_a_solid_to_come(qtbot, view, built) -> None:
    show(view, {})
    view.grid.set_view("pair")
    empty = view.grid.viewport.grabFramebuffer()
    picture(qtbot, view)
    assert empty.width() > 0 and len(view.layers) == 4 and not view.gears
    show(view, {PAIR_KEYS[0]: built[PAIR_KEYS[0]]})
    assert [gear.member for gear in view.gears] == ["pinion"]
    assert {layer.body for layer in view.layers} == {"pinion", "wheel"}


def test_two_clicks_measure_also_a_gear_that_has_turned(qtbot, view, built) -> None:
    from ui.solid_measure import SolidMeasure

    said: list[str] = []
    show(view, built)
    view.grid.set_view("pair")
    view.turn(0.3)
    picture(qtbot, view)
    owner = QObject()
    measuring = SolidMeasure(view, said.append, owner)
    measuring.switch(True)
    measuring.set_snapping(False)
    viewport = view.grid.viewport
    for place in ((0.62, 0.78), (0.55, 0.76)):
        viewport.clicked.emit(QPointF(viewport.width() * place[0], viewport.height() * place[1]))
    one, other = measuring.points
    for picked in (one, other):
        x, y = viewport.look.project(picked.point)
        assert picked.member == "wheel"
        assert np.linalg.norm(picked.local) == pytest.approx(np.linalg.norm(picked.point))
        assert abs(viewport.place_of(0, float(x), float(y)).y() / viewport.height() - 0.77) < 0.02
    distance = float(np.linalg.norm(one.point - other.point))
    assert f"{distance:.4f} mm" in said[-1] and "Azimuth" in said[-1]
    assert measuring._overlay.isVisible()
    viewport.clicked.emit(QPointF(3, 3))
    assert len(measuring.points) == 2
    measuring.switch(False)
    assert not measuring.points and not measuring._overlay.isVisible()


def test_a_measurement_snaps_to_corners_in_sight_and_never_to_hidden_ones(qtbot, view, built) -> None:
    from ui.solid_measure import SNAP_PIXELS, SolidMeasure

    show(view, built)
    view.grid.set_view("pair")
    view.turn(0.3)
    picture(qtbot, view)
    owner, said = QObject(), []
    measuring = SolidMeasure(view, said.append, owner)
    measuring.switch(True)
    viewport = view.grid.viewport

    def place_of(point) -> QPointF:
        return viewport.place_of(0, *(float(x) for x in viewport.look.project(point)))

    gear = next(gear for gear in view.gears if gear.member == "wheel")
    frame, seen, hidden = view.frames["wheel"], [], 0
    for corner in frame.turn.of(gear.fine.corners):
        place = place_of(corner)
        found = measuring._snapped(place + QPointF(2, -1))
        if found is None:
            hidden += 1
        elif np.linalg.norm(found[0].point - corner) < 1e-9:
            seen.append((corner, place))
        assert found is None or (place_of(found[0].point) - place).manhattanLength() < 2 * SNAP_PIXELS
    assert len(seen) > 20 and hidden > 20
    size = float(np.abs(gear.fine.corners).max())
    around = [QPointF(dx, dy) for dx in (-2, 0, 2) for dy in (-2, 0, 2)]  # outlines of coarse and fine meshes differ
    for corner, place in seen:
        eye, hits = viewport.look.eye, [measuring._picked(place + step) for step in around]
        nearest = np.linalg.norm(corner - eye) - 0.01 * size
        assert any(hit is None or np.linalg.norm(hit.point - eye) > nearest for hit in hits)
    corner, place = seen[0]
    viewport.pointer_moved.emit(place + QPointF(0.4, 0.3))
    qtbot.waitUntil(lambda: measuring.hint is not None, timeout=3000)
    assert measuring.hint[1] == "corner" and measuring._overlay.isVisible()
    viewport.clicked.emit(place + QPointF(0.4, 0.3))
    assert np.allclose(measuring.points[0].point, corner)
    viewport.clicked.emit(seen[-1][1] + QPointF(1, 1))
    assert "Between normals" not in said[-1] and "Azimuth" in said[-1]
    measuring.set_snapping(False)
    viewport.clicked.emit(place + QPointF(0.4, 0.3))
    assert not np.allclose(measuring.points[0].point, corner, atol=1e-6)
