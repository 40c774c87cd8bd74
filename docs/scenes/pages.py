"""Scenes of the analysis: comparison, charts, contact, data sheet and measurement."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from docs.scenes.stage import Stage, wait_for

FLANK = "modifications.pinion.concave"
CROWNING = {
    f"{FLANK}.lengthwise_crowning_um": 15.0,
    f"{FLANK}.profile_crowning_um": 6.0,
    f"{FLANK}.tip_relief_um": 12.0,
}


def charts(stage: Stage) -> None:
    """Every kind of chart."""
    page = stage.page("charts", 0.8)
    for kind in ("points", "histogram", "convergence", "curvature"):
        page.show_kind(kind)
        stage.show(f"charts-{kind}", 0.8)
    page.show_kind("points")
    stage.window.analysis.expand.setChecked(True)
    stage.show("charts-large", 0.8)
    stage.window.analysis.expand.setChecked(False)


def contact(stage: Stage) -> None:
    """Pattern and ease-off of a crowned pair, and of a hypoid one."""
    stage.controller.edits.change_many(CROWNING, "Crowning")
    page = stage.page("contact")
    wait_for(lambda: page.view is not None, 20)
    stage.show("contact", 2.0)
    page.shown.button("ease_off").click()
    stage.show("ease-off", 0.8)
    page.shown.button("pattern").click()
    stage.preset("hypoid-car")
    stage.show("contact-hypoid", 3.0)
    stage.preset("default")


def data_sheet(stage: Stage) -> None:
    """The sheet with an explanation, and the published values."""
    page = stage.page("datasheet", 0.8)
    page.table.choose("spiral_angle")
    stage.show("data-sheet")
    page.show_view("published")
    stage.show("data-sheet-published")
    page.show_view("sheet")


def measurement(stage: Stage) -> None:
    """Without points and with some of a wheel that is a little wrong."""
    page = stage.page("measurement", 0.8)
    stage.show("measurement-empty")
    page.save_nominal(stage.folder / "nominal.csv")
    page.open_path(measured_points(stage.folder))
    wait_for(lambda: page.measurement is not None, 60)
    for view in ("topography", "pitch", "space"):
        page.show_view(view)
        stage.show(f"measurement-{view}", 1.0)
    page.show_view("topography")
    stage.window.messages.clear()


def comparison(stage: Stage) -> None:
    """The table."""
    stage.page("comparison")
    stage.show("comparison")


def measured_points(folder: Path) -> Path:
    """Points as measured on a wheel with a slope along the face and some noise."""
    head, *rows = (folder / "nominal.csv").read_text(encoding="utf-8").splitlines()
    column = head.split(",").index("row")
    table = np.array([[float(cell) for cell in row.split(",")[:6]] for row in rows])
    steps = np.array([float(row.split(",")[column]) for row in rows])
    error = 0.004 * steps / steps.max() + np.random.default_rng(1).normal(0, 0.0006, len(rows))
    lines = [",".join(f"{value:.9f}" for value in row) for row in table[:, :3] + error[:, None] * table[:, 3:]]
    written = folder / "measured.csv"
    written.write_text("\n".join(["x,y,z", *lines]) + "\n", encoding="utf-8")
    return written


PAGES = (charts, contact, data_sheet, measurement, comparison)
