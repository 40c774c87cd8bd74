"""Solids in a real window: made in a thread, the newest order alone is put up; what is pinned on them is told."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPointF

from tests.ui.made_up_solid import solid_of
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.stand_ins import Bench
from tests.ui.views_bench import bench_with_views
from ui.solids import meshed

pytestmark = NEEDS_SCREEN
PATIENCE_MS = 20_000


@pytest.fixture
def bench(qtbot) -> Iterator[Bench]:
    yield from bench_with_views(qtbot)


def show(bench: Bench, qtbot, name: str = "gear"):
    """The mode with its solids in sight."""
    mode = bench.controller.solid_mode
    mode.set_mode(name)
    for key in mode.keys:
        mode.solids.built[key] = meshed(bench.session.design, solid_of(bench.session.design, key.member))
    mode.redraw()
    qtbot.waitUntil(lambda: len(mode.sight.view.gears) == len(mode.keys), timeout=PATIENCE_MS)
    return mode


def test_gears_come_and_flanks_return_as_they_were(bench: Bench, qtbot) -> None:
    grid = bench.window.area.grid
    before, look = [panel.key for panel in grid.panels], grid.viewport.look
    mode = show(bench, qtbot)
    assert [panel.key for panel in grid.panels] == ["solid"] and grid.viewport.look is not look
    mode.set_mode("flanks")
    qtbot.waitUntil(lambda: [panel.key for panel in grid.panels] == before, timeout=PATIENCE_MS)
    assert np.allclose(grid.viewport.look.focal, look.focal)
    assert mode.sight.view.plane is None and not mode.sight.view.gears


def test_what_is_put_up_was_made_elsewhere(bench: Bench, qtbot, monkeypatch) -> None:
    from ui.solid_workshop import Workshop

    threads, make = [], Workshop.make

    def watched(self, order):
        threads.append(threading.current_thread())
        return make(self, order)

    monkeypatch.setattr(Workshop, "make", watched)
    mode = show(bench, qtbot)
    assert threads and threading.main_thread() not in threads
    layer = next(layer for layer in mode.sight.view.layers if layer.kind == "surface")
    assert {"bounds", "single", "pick_mesh"} <= vars(layer).keys()


def test_a_moving_section_ends_with_the_newest_place_cut_finely(bench: Bench, qtbot) -> None:
    mode = show(bench, qtbot)
    panel = bench.window.solid_panel
    panel.section.box.setChecked(True)
    shown: list = []
    mode.sight.stage.changed.connect(lambda order, _other: shown.append(order))
    for value in range(100, 300, 4):
        panel.section.slider.setValue(value)
    axis, place, _ = panel.section.plane
    qtbot.waitUntil(lambda: bool(shown) and shown[-1].cut == "fine", timeout=PATIENCE_MS)
    assert mode.sight.view.plane.axis == axis and mode.sight.view.plane.place == place
    assert len(shown) < 20
    cut = next(layer for layer in mode.sight.view.layers if layer.part == "wheel cut")
    assert np.allclose(cut.points[:, axis], place)
    panel.section.box.setChecked(False)
    qtbot.waitUntil(lambda: mode.sight.view.plane is None, timeout=PATIENCE_MS)
    assert not any(layer.part == "wheel cut" for layer in mode.sight.view.layers)


def test_an_older_gear_is_not_put_up_after_the_mode_is_left(bench: Bench, qtbot) -> None:
    mode = show(bench, qtbot)
    mode._panel._edges.setChecked(False)
    mode.set_mode("flanks")
    qtbot.wait(300)
    assert all(panel.key != "solid" for panel in bench.window.area.grid.panels)


def test_the_scale_of_solids_is_that_of_their_deviation(bench: Bench, qtbot) -> None:
    bar, display = bench.window.area.color_bar, bench.controller.display
    display.show_appearance(replace(bench.window.area.grid.appearance, quantity="gaussian", exaggeration=100))
    qtbot.waitUntil(lambda: bar._factor == 100, timeout=PATIENCE_MS)
    assert bar.quantity.id == "gaussian"
    show(bench, qtbot)
    bench.window.solid_panel._deviation.setChecked(True)
    qtbot.waitUntil(lambda: bar.isVisible() and bar._factor == 1, timeout=PATIENCE_MS)
    assert bar.quantity.is_deviation and bar.range[0] == -bar.range[1]
    bench.controller.solid_mode.set_mode("flanks")
    qtbot.waitUntil(lambda: bar._factor == 100, timeout=PATIENCE_MS)
    assert bar.quantity.id == "gaussian"


def test_a_pinned_place_is_told_with_face_coordinates_and_methods(bench: Bench, qtbot) -> None:
    mode, grid = show(bench, qtbot), bench.window.area.grid
    card, pointing = bench.controller.display.picks.card, grid.pointing
    view = grid.viewport
    flanks = mode.sight.view.gears[0].fine.flanks
    seen = view.look.project(flanks.points)
    for x, y in seen[:: max(len(seen) // 60, 1)]:
        view.clicked.emit(view.place_of(0, float(x), float(y)))
        if pointing.pin is not None and pointing.pin.side:
            break
    pin = pointing.pin
    assert pin is not None and pin.member == "wheel" and pin.tooth is not None
    qtbot.waitUntil(lambda: bool(card.rows()) and card.isVisible(), timeout=PATIENCE_MS)
    assert f"{pin.side} flank, tooth {pin.tooth}" in card.where()
    names = [row[0] for row in card.rows()]
    assert names[1] == "This solid" and names[-1] == "Theory" and len(names) == 6
    assert f"r {np.hypot(*pin.xyz[:2]):.4f} mm" in card.coordinates()[0]
    mode.set_mode("flanks")
    qtbot.waitUntil(lambda: pointing.pin is None and not card.isVisible(), timeout=PATIENCE_MS)


def test_while_measuring_a_click_pins_nothing(bench: Bench, qtbot) -> None:
    mode, grid = show(bench, qtbot), bench.window.area.grid
    bench.window.solid_panel._measure.setChecked(True)
    grid.viewport.clicked.emit(QPointF(0.5 * grid.width(), 0.75 * grid.height()))
    assert grid.pointing.pin is None and len(mode.sight.measuring.points) == 1
    bench.window.solid_panel._measure.setChecked(False)
    grid.viewport.clicked.emit(QPointF(0.5 * grid.width(), 0.75 * grid.height()))
    assert grid.pointing.pin is not None
