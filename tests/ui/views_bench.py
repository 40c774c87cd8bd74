"""A window with real 3D views and made-up results in them, for tests; and what its pictures are compared by."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage

from tests.ui.made_up import result_of
from tests.ui.stand_ins import Bench

AMOUNTS = {"rotating_line": 30.0, "profile_sweep": -30.0, "point_cloud": 0.0}


def bench_with_views(qtbot) -> Iterator[Bench]:
    """The default wheel with a made-up result of each method in the views."""
    from ui.color_bar import ColorBar
    from ui.mesh_bar import MeshBar
    from ui.roll_slider import RollSlider
    from ui.view_grid import ViewGrid

    made = Bench()
    made.window.resize(1280, 800)
    made.window.show()
    made.window.area.adopt(ViewGrid(), ColorBar(), RollSlider(), MeshBar())
    made.controller.views_ready()
    session = made.session
    session.select(variant="published")
    for method, amount in AMOUNTS.items():
        result = result_of(session.pair.member("wheel"), lambda u, v, a=amount: a + 0 * u, method=method)
        session.put_result(session.design, result)
    made.controller.presenter.redraw()
    made.window.area.grid.set_view("concave")
    qtbot.wait(300)
    yield made
    made.close()


def grid_of(bench):
    return bench.window.area.grid


def show(qtbot, bench, **changes) -> np.ndarray:
    grid = grid_of(bench)
    bench.controller.display.show_appearance(replace(grid.appearance, **changes))
    qtbot.wait(400)
    return pixels(grid.viewport.grabFramebuffer())


def pixels(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_RGBA8888)
    return np.array(image.constBits()).reshape(image.height(), image.width(), 4).astype(int)


def flank_place(grid, pane: int) -> QPointF:
    layer = next(x for x in grid.panels[pane].layers if x.key == "deviation/concave")
    x, y = grid.viewport.looks[pane].project(layer.points[len(layer.points) // 2])
    return grid.viewport.place_of(pane, float(x), float(y))


def changed(one: np.ndarray, other: np.ndarray) -> float:
    return float((np.abs(one - other).max(axis=2) > 24).mean())
