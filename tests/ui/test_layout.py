"""No word is cut and nothing overlaps: panels, pages and dialogs at the smallest size, in every language.

``docs/gallery.py`` shows the same scenes, and those that need the CAD process, in all themes and sizes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication, QCheckBox, QHBoxLayout, QLabel, QPushButton, QWidget

from docs.scenes import dialogs, pages, panels
from docs.scenes.stage import Stage, spin
from gearstudio.catalogue import METHOD_IDS, VARIANTS
from tests.ui.layout_check import LEAST, faults
from tests.ui.made_up import member_of, result_of
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.stand_ins import FakeRunner
from ui import app
from ui.language import Language
from ui.loading import STAGES, Loader

pytestmark = NEEDS_SCREEN
SCENES = (panels.views, panels.form, dialogs.exports, dialogs.preferences)
MORE = (
    panels.derived_and_log, panels.messages, panels.solids, pages.charts, pages.contact, pages.data_sheet,
    pages.comparison, dialogs.outputs, dialogs.projects, dialogs.questions, dialogs.helping,
)  # fmt: skip
LONGEST = "de"
"""The language with the longest words plays all scenes."""
REST_S = 0.03
SYSTEM = "QFileDialog"


@pytest.fixture(params=["de", "en", "zh"])
def speaking(request: pytest.FixtureRequest, qapp: QApplication) -> Iterator[str]:
    language = Language(qapp, request.param)
    yield request.param
    language.speak("en")


def with_results(stage: Stage) -> None:
    """Results of all methods without a CAD kernel."""
    stage.controller.use_runner(FakeRunner())  # type: ignore[arg-type]
    made = result_of(member_of("default"), lambda u, v: 0.4 * u - 0.2 * v)
    for method in METHOD_IDS:
        for variant in VARIANTS:
            settings = {"sections": 7, "grid": [12, 14], "spacing": "non-uniform"}
            named = replace(made, method=method, variant=variant, settings=settings)
            stage.session.put_result(stage.session.design, named)


@pytest.mark.slow
def test_nothing_is_cut_in_any_language(speaking: str, theme, tmp_path: Path, monkeypatch) -> None:
    without_kernel = {name: modules for name, modules in STAGES.items() if name != "worker"}
    monkeypatch.setattr(app, "Loader", partial(Loader, without_kernel))
    found: dict[str, str] = {}

    def look(name: str) -> None:
        for _ in range(3):
            QApplication.processEvents()
        tops = [top for top in QApplication.topLevelWidgets() if top.isVisible() and not top.inherits(SYSTEM)]
        for top in tops if len(tops) == 1 else [one for one in tops if one is not stage.window]:
            found.update((fault, name) for fault in faults(top) if fault not in found)

    stage = Stage(theme, tmp_path, look, built=False, rest=REST_S)
    try:
        stage.open()
        with_results(stage)
        stage.resize(*LEAST)
        for scene in (*SCENES, *(MORE if speaking == LONGEST else ())):
            scene(stage)
            stage.close_all()
    finally:
        stage.leave()
    assert not found, "\n".join(f"{name}: {fault}" for fault, name in found.items())


class TestFaults:
    """The check finds what it is for."""

    @pytest.fixture
    def top(self, qtbot) -> QWidget:
        made = QWidget()
        qtbot.addWidget(made)
        made.resize(300, 100)
        made.show()
        return made

    def test_nothing_wrong(self, top: QWidget) -> None:
        layout = QHBoxLayout(top)
        for widget in (QLabel("A label"), QPushButton("A button"), QCheckBox("A box")):
            layout.addWidget(widget)
        spin(0.05)
        assert faults(top) == []

    @pytest.mark.parametrize("kind", [QLabel, QPushButton, QCheckBox])
    def test_words_that_are_cut(self, top: QWidget, kind: type) -> None:
        widget = kind("Words that are too long", top)
        widget.setGeometry(0, 0, 60, 30)
        widget.show()
        assert any("Words that are too long" in fault for fault in faults(top))

    def test_widgets_over_each_other_and_beyond_the_edge(self, top: QWidget) -> None:
        layout = QHBoxLayout(top)
        first, second = QPushButton("One"), QPushButton("Two")
        layout.addWidget(first)
        layout.addWidget(second)
        spin(0.05)
        second.setGeometry(first.geometry().translated(5, 0))
        assert any("lies over" in fault for fault in faults(top))
        second.move(280, 0)
        assert any("reaches out" in fault for fault in faults(top))

    def test_windows_larger_than_the_smallest_screen(self, top: QWidget) -> None:
        top.resize(1281, 300)
        assert any("smallest window" in fault for fault in faults(top))
