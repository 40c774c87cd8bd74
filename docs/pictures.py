"""Makes the pictures of README and guide from the real program: ``python docs/pictures.py`` on a screen.

Without one: ``bash tools/screen.sh .venv/bin/python docs/pictures.py``.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from PySide6.QtCore import Qt  # noqa: E402
from PySide6.QtWidgets import QApplication  # noqa: E402

from ui.app import Studio, make_application  # noqa: E402
from ui.layers import LAYER_SETS  # noqa: E402
from ui.screenshot import window_image  # noqa: E402
from ui.theme import Theme  # noqa: E402

SIZE = (1600, 960)
PATIENCE_S = 120.0


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


def main() -> None:
    """Save one picture after the other in docs/images."""
    theme = Theme(make_application(["gearstudio"]))
    theme.choose(Qt.ColorScheme.Light)
    studio = Studio(theme)
    session, window, controller = studio.session, studio.window, studio.controller
    window.resize(*SIZE)
    window.reset_layout()
    window.show()

    def ready() -> bool:
        return window.area.grid is not None and session.pair is not None and not session.missing_keys()

    def save(name: str) -> None:
        window_image(window).save(str(ROOT / "docs" / "images" / f"{name}.png"))

    wait_for(ready)
    save("window")
    session.select(member="pinion", method="rotating_line")
    wait_for(ready)
    layers = dict(LAYER_SETS)["Generation"]
    window.layer_panel.set_chosen.emit(layers)
    window.area.roll_slider.set_roll(0.55)
    controller.presenter.set_roll(0.55)
    wait_for(ready)
    save("generation")
    window.layer_panel.set_chosen.emit(dict(LAYER_SETS)["Deviation"])
    session.select(member="wheel")
    wait_for(ready)
    window.analysis.show_tab("contact")
    wait_for(ready, 4.0)
    save("contact")
    window.analysis.show_tab("comparison")
    controller.solid_mode.build("pair")
    wait_for(lambda: len(controller.solid_mode.keys) == 2, 12.0)
    save("pair")
    session.mark_saved(ROOT, session.design)
    window.close()


if __name__ == "__main__":
    main()
