"""Scenes of the window's panels: views, layers, display, form, derived values, log, solids, messages."""

from __future__ import annotations

import logging

from PySide6.QtCore import QPoint, QPointF
from PySide6.QtWidgets import QDockWidget, QScrollArea

from docs.scenes.stage import Stage, spin, wait_for
from ui.session import ALL
from ui.views.zebra import Stripes
from ui.words import tr

LONG = "A sentence as long as those that tell which file could not be written, and where, and what is to be done now"
GROUPS = (
    "pair.pinion_teeth", "pair.pinion_hand", "lengthwise.curve", "tooth.profile_shift", "tooth.ends",
    "modifications.pinion.concave.lengthwise_crowning_um", "methods.tolerance_um",
)  # fmt: skip


def views(stage: Stage) -> None:
    """What the 3D views show, and the panels that say so."""
    window, session = stage.window, stage.session
    stage.show("window")
    stage.dock("Layers", True)
    stage.show("layers")
    swatch = window.layer_panel.swatch("pitch_cone" if "pitch_cone" in window.layer_panel._swatches else "base_cone")
    stage.dialog("layer-look", swatch.click)
    window.commands["display"].setChecked(True)
    stage.show("layers-and-display")
    stage.dock("Layers", False)
    stage.show("display")
    stage.appear(zebra=True, stripes=Stripes(), combs="lengthwise", steps=8, contours=True)
    stage.show("display-zebra", 1.0)
    _scroll(window.area, 10_000)
    stage.show("display-below")
    stage.appear(quantity="mean", against="relative", contours=True)
    stage.show("display-curvature", 1.0)
    stage.appear()
    window.commands["display"].setChecked(False)
    stage.layers("Generation")
    session.select(member="pinion", method="rotating_line")
    stage.settle()
    stage.show("generation", 0.8)
    stage.layers("Deviation")
    session.select(member="wheel", method="point_cloud", variant="published")
    stage.settle()
    stage.show("one-method", 0.6)
    session.select(method=ALL, variant="optimised")
    stage.settle()
    stage.dialog("range", lambda: _edit_range(stage))


def _edit_range(stage: Stage) -> None:
    bar = stage.window.area.color_bar
    bar._editor.open_at(bar.mapToGlobal(QPoint(0, 40)), 0.0, bar.limit, "µm", True)


def _scroll(widget: object, to: int) -> None:
    for area in widget.findChildren(QScrollArea):  # type: ignore[attr-defined]
        area.verticalScrollBar().setValue(to)


def picked(stage: Stage) -> None:
    """The point under the pointer, and the card of one that was picked."""
    grid = stage.window.area.grid
    layer = next(x for x in grid.panels[0].layers if x.key == "deviation/concave")
    x, y = grid.viewport.look.project(layer.points[len(layer.points) // 2])
    place = QPointF(grid.viewport.place_of(0, float(x), float(y)))
    grid.pointing._on_moved(place)
    grid.pointing._on_clicked(place)
    stage.show("picked", 1.0)
    grid.pointing.drop_pin()
    grid.pointing.clear()


def form(stage: Stage) -> None:
    """All groups of parameters; wrong, idle, hypoid, searched and explained ones."""
    window = stage.window
    window.form.fold(())
    for number, path in enumerate(GROUPS):
        window.form.go_to(path)
        area = window.form._scroll
        area.verticalScrollBar().setValue(window.form.rows[path].mapTo(area.widget(), QPoint(0, 0)).y() - 40)
        stage.show(f"form-{number + 1}")
    stage.dialog("explained", lambda: stage.studio.habits.explain("pair.face_width"))
    window.form.search.setText("xyzzy")
    stage.show("form-nothing-found")
    window.form.search.clear()
    stage.controller.edits.change("pair.pinion_teeth", 3)
    stage.controller.edits.change("pair.face_width_factor", 0.45)
    stage.controller.edits.change("lengthwise.spiral_angle_deg", "abc")
    window.form.go_to("pair.pinion_teeth")
    stage.show("form-errors", 1.2)
    window.form.go_to("lengthwise.spiral_angle_deg")
    stage.show("form-errors-below")
    stage.preset("default")
    stage.studio.habits.preferences.set(length="in")
    stage.show("inches")
    stage.studio.habits.preferences.set(length="mm")
    stage.preset("hypoid-car")
    for key in ("pair.offset", "pair.pinion_hand"):
        if key in window.form.rows:
            window.form.go_to(key)
            stage.show(f"hypoid-{key.split('.')[1]}")
    stage.preset("default")
    window.form.go_to("pair.pinion_teeth")


def derived_and_log(stage: Stage) -> None:
    """Derived values from top to bottom, and the log."""
    window = stage.window
    view = window.derived.view
    view.verticalScrollBar().setValue(10_000)
    stage.show("derived-below")
    view.verticalScrollBar().setValue(0)
    log = stage.studio.upkeep.log
    log.show()
    logging.getLogger("gearstudio").warning("the sections cross at the toe: %s", LONG)
    log.raise_()
    stage.show("log")
    log.hide()
    window.findChild(QDockWidget, "Derived values").setFloating(True)
    stage.show("undocked")
    window.reset_layout()


def messages(stage: Stage) -> None:
    """Messages over the views, and work in progress in the status bar."""
    bar, status = stage.window.messages, stage.window.status
    for severity in ("error", "warning", "info"):
        bar.show_message(severity, LONG, "More is known:\n" + LONG)
        stage.show(f"message-{severity}")
    bar._more.setChecked(True)
    stage.show("message-details")
    bar.clear()
    stage.window.commands["cancel"].setEnabled(True)
    status.show_work(tr("wheel") + ": " + LONG[:40], 0.4)
    for state in ("starting", "busy", "replaced", "stopped"):
        status.show_worker(state)
        stage.show(f"status-{state}")
    status.show_work(None)
    status.show_worker("ready")
    missing = stage.folder / "newer.gear.toml"
    missing.write_text("format = 99\n", encoding="utf-8")
    stage.studio.files.open_path(missing)
    wait_for(lambda: bool(bar.text))
    stage.show("newer-format")
    bar.clear()


def solids(stage: Stage) -> None:
    """Gear and pair with their panel, bar of the mesh, section and measuring."""
    mode, panel = stage.controller.solid_mode, stage.window.solid_panel
    mode.set_mode("gear")
    stage.show("gear-not-built")
    if stage.built:
        mode.build("gear")
        stage.show("gear-building")
        wait_for(lambda: len(mode.keys) == 1 and all(mode.solids.is_current(key) for key in mode.keys))
        stage.show("gear", 1.5)
    mode.set_mode("pair")
    if stage.built:
        mode.build("pair")
        wait_for(lambda: len(mode.keys) == 2 and all(mode.solids.is_current(key) for key in mode.keys))
    panel.section.box.setChecked(True)
    panel._measure.setChecked(True)
    panel._deviation.setChecked(True)
    stage.show("pair", 1.5)
    _scroll(panel, 10_000)
    stage.show("pair-below")
    panel.section.box.setChecked(False)
    panel._measure.setChecked(False)
    panel._deviation.setChecked(False)
    mode.set_mode("flanks")
    spin(0.3)


PANELS = (views, picked, form, derived_and_log, messages, solids)
