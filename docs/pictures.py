"""Makes the pictures of README and guide from the real program: ``python docs/pictures.py`` on a screen.

Without one: ``bash tools/screen.sh .venv/bin/python docs/pictures.py``.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from PySide6.QtCore import QBuffer, Qt  # noqa: E402
from PySide6.QtGui import QImage  # noqa: E402
from PySide6.QtWidgets import QApplication, QDialog  # noqa: E402

from gearstudio.design import Design  # noqa: E402
from gearstudio.presets import PRESETS_BY_KEY  # noqa: E402
from ui.app import Studio, make_application  # noqa: E402
from ui.export_dialog import ExportDialog  # noqa: E402
from ui.help.equations import EquationBrowser  # noqa: E402
from ui.layers import LAYER_SETS  # noqa: E402
from ui.palette import Palette  # noqa: E402
from ui.preferences_dialog import PreferencesDialog  # noqa: E402
from ui.reporting.dialog import ReportDialog  # noqa: E402
from ui.screenshot import window_image  # noqa: E402
from ui.theme import Theme  # noqa: E402

SIZE = (1600, 960)
PATIENCE_S = 120.0
FLANK = "modifications.pinion.concave"
CROWNING = {
    f"{FLANK}.lengthwise_crowning_um": 15.0,
    f"{FLANK}.profile_crowning_um": 6.0,
    f"{FLANK}.tip_relief_um": 12.0,
}


def wait_for(condition: Callable[[], bool], rest_s: float = 1.0) -> None:
    """Run events until a condition holds, then a little longer so that everything is drawn."""
    start = time.monotonic()
    while not condition():
        if time.monotonic() - start > PATIENCE_S:
            raise TimeoutError("the window did not get ready")
        QApplication.processEvents()
        time.sleep(0.005)
    end = time.monotonic() + rest_s
    while time.monotonic() < end:
        QApplication.processEvents()
        time.sleep(0.005)


class Painter:
    """A window that is driven from picture to picture."""

    def __init__(self) -> None:
        theme = Theme(make_application(["gearstudio"]))
        theme.choose(Qt.ColorScheme.Light)
        self.studio = Studio(theme)
        self.session, self.window, self.controller = self.studio.session, self.studio.window, self.studio.controller
        self.window.resize(*SIZE)
        self.window.show()
        self.window.reset_layout()

    def settle(self, rest_s: float = 1.0) -> None:
        """Wait until everything in sight is built and drawn."""
        session, area = self.session, self.window.area
        wait_for(lambda: area.grid is not None and session.pair is not None and not session.missing_keys(), rest_s)

    def save(self, name: str) -> None:
        """The window."""
        self.window.messages.clear()
        wait_for(lambda: True)
        write(window_image(self.window), name)

    def save_dialog(self, kind: type[QDialog], name: str) -> None:
        """A dialog that is open, which is closed then."""
        dialog = next(w for w in QApplication.topLevelWidgets() if isinstance(w, kind) and w.isVisible())
        wait_for(lambda: True)
        write(dialog.grab().toImage(), name)
        dialog.close()
        wait_for(lambda: True, 0.2)

    def layers(self, name: str) -> None:
        """A ready-made set of layers."""
        self.window.layer_panel.set_chosen.emit(dict(LAYER_SETS)[name])


def write(picture: QImage, name: str) -> None:
    """As a PNG of 256 colours in docs/images."""
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    picture.convertToFormat(QImage.Format.Format_RGB888).save(buffer, "PNG")
    made = Image.open(BytesIO(bytes(buffer.data().data())))
    made = made.quantize(256, method=Image.Quantize.MAXCOVERAGE, kmeans=1, dither=Image.Dither.NONE)
    made.save(ROOT / "docs" / "images" / f"{name}.png", optimize=True)


def views(painter: Painter) -> None:
    """The three methods, how a flank comes about, and quality of the surfaces."""
    session, window, controller = painter.session, painter.window, painter.controller
    painter.settle()
    painter.save("window")
    session.select(member="pinion", method="rotating_line")
    painter.layers("Generation")
    window.area.roll_slider.set_roll(0.55)
    controller.presenter.set_roll(0.55)
    painter.settle()
    painter.save("generation")
    painter.layers("Deviation")
    session.select(member="wheel", method="all")
    usual = window.area.grid.appearance
    controller.display.show_appearance(replace(usual, quantity="mean", zebra=True))
    window.commands["display"].trigger()
    window.area.grid.set_view("concave")
    painter.settle(2.0)
    painter.save("zebra")
    window.commands["display"].trigger()
    controller.display.show_appearance(usual)
    window.area.grid.set_view("tooth")


def analysis(painter: Painter, folder: Path) -> None:
    """Ease-off and measured points."""
    window = painter.window
    painter.session.select(member="wheel", method="rotating_line")
    window.analysis.show_tab("contact")
    painter.controller.edits.change_many(CROWNING, "Crowning")
    window.form.go_to(f"{FLANK}.root_relief_end")
    window.analysis.page.shown.button("ease_off").click()
    painter.settle(4.0)
    painter.save("ease-off")
    window.analysis.show_tab("measurement")
    page = window.analysis.page
    page.save_nominal(folder / "nominal.csv")
    page.open_path(measured_points(folder))
    wait_for(lambda: page.measurement is not None, 2.0)
    painter.save("measurement")
    window.analysis.show_tab("comparison")
    painter.controller.edits.undo()
    painter.settle()


def measured_points(folder: Path) -> Path:
    """Points as measured on a wheel that is a little wrong: a slope along the face and some noise."""
    head, *rows = (folder / "nominal.csv").read_text(encoding="utf-8").splitlines()
    names = head.split(",")
    table = np.array([[float(cell) for cell in row.split(",")[:6]] for row in rows])
    column = [float(row.split(",")[names.index("row")]) for row in rows]
    error = 0.004 * np.array(column) / max(column) + np.random.default_rng(1).normal(0, 0.0006, len(rows))
    lines = [",".join(f"{value:.9f}" for value in row) for row in table[:, :3] + error[:, None] * table[:, 3:6]]
    written = folder / "measured.csv"
    written.write_text("\n".join(["x,y,z", *lines]) + "\n", encoding="utf-8")
    return written


def dialogs(painter: Painter) -> None:
    """Export, report, preferences, palette and equations."""
    session, controller, habits = painter.session, painter.controller, painter.studio.habits
    ExportDialog(session, "~/gears", painter.window, None, "pair").open()
    painter.save_dialog(ExportDialog, "export")
    controller.reporting.open()
    report = controller.reporting.dialog
    report.make.click()
    wait_for(report.save.isEnabled, 0.5)
    painter.save_dialog(ReportDialog, "report")
    habits.open_preferences()
    painter.save_dialog(PreferencesDialog, "preferences")
    habits.open_palette()
    painter.save_dialog(Palette, "palette")
    controller.help.open_equations("base_angle")
    painter.save_dialog(EquationBrowser, "equations")


def hypoid(painter: Painter) -> None:
    """A hypoid pair in contact, and its pinion with a base cone of its own."""
    session, window = painter.session, painter.window
    mode = painter.controller.solid_mode
    session.load(PRESETS_BY_KEY["hypoid-car"].design)
    session.settle()
    session.select(member="pinion", method="profile_sweep")
    window.analysis.show_tab("contact")
    page = window.analysis.page
    page.shown.button("pattern").click()
    mode.build("pair")
    wait_for(lambda: len(mode.keys) == 2 and all(mode.solids.is_current(key) for key in mode.keys), 2.0)
    painter.settle(4.0)
    painter.save("hypoid")
    page.controls.pinions.button("own_cone").click()
    page.shown.button("ease_off").click()
    painter.settle(4.0)
    painter.save("own-cone")
    page.controls.pinions.button("conjugate").click()
    page.shown.button("pattern").click()
    window.analysis.show_tab("comparison")
    session.load(Design())
    session.settle()


def main() -> None:
    """Save one picture after the other in docs/images."""
    painter = Painter()
    with TemporaryDirectory() as folder:
        views(painter)
        analysis(painter, Path(folder))
    dialogs(painter)
    mode = painter.controller.solid_mode
    mode.build("pair")
    wait_for(lambda: len(mode.keys) == 2 and all(mode.solids.is_current(key) for key in mode.keys), 2.0)
    painter.save("pair")
    hypoid(painter)
    painter.session.mark_saved(ROOT, painter.session.design)
    painter.window.close()


if __name__ == "__main__":
    main()
