"""Numbers follow the language of the window, wherever it shows one, and at once when it changes."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QTextDocument
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QGraphicsTextItem,
    QGraphicsView,
    QLineEdit,
    QPlainTextEdit,
    QWidget,
)

from docs.scenes import dialogs, pages, panels
from docs.scenes.stage import Stage
from tests.ui.reading import texts_of
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.test_layout import SYSTEM, with_results
from ui import app
from ui.loading import STAGES, Loader

FOREIGN = {"de": re.compile(r"\d\.\d"), "en": re.compile(r"\d,\d")}
OWN = {"de": re.compile(r"\d,\d"), "en": re.compile(r"\d\.\d")}


@pytest.fixture
def painted(monkeypatch) -> list[str]:
    """What painters have written."""
    found: list[str] = []
    draw = QPainter.drawText

    def noting(painter: QPainter, *given: object) -> object:
        found.extend(text for text in given if isinstance(text, str))
        return draw(painter, *given)

    monkeypatch.setattr(QPainter, "drawText", noting)
    return found


def plain(text: str) -> str:
    if not Qt.mightBeRichText(text):
        return text
    document = QTextDocument()
    document.setHtml(text)
    return document.toPlainText()


def shown_in(top: QWidget) -> Iterator[tuple[str, str]]:
    """Texts of a window, those that stand in its fields and its charts too."""
    yield from texts_of(top)
    for widget in (top, *top.findChildren(QWidget)):
        name = type(widget).__name__
        if isinstance(widget, QLineEdit | QAbstractSpinBox):
            yield name, widget.text()
        elif isinstance(widget, QPlainTextEdit):
            yield name, widget.toPlainText()
        elif isinstance(widget, QGraphicsView):
            items = widget.scene().items()
            yield from ((f"{name} item", item.toPlainText()) for item in items if isinstance(item, QGraphicsTextItem))


def preferences(stage: Stage) -> None:
    """Its pages; what stands beside them tells versions."""
    for page in range(3):
        stage.dialog(f"preferences-{page}", lambda page=page: stage.studio.habits.open_preferences(page))


def numbers_in(texts: list[tuple[str, str]], sign: re.Pattern[str]) -> list[str]:
    return [f"{where}: {text[:200]}" for where, text in texts if sign.search(text)]


class Reader:
    """Looks at every scene and notes numbers of another language."""

    def __init__(self, language: str, painted: list[str]) -> None:
        self.language, self._painted = language, painted
        self.foreign: list[str] = []
        self.own = 0

    def __call__(self, scene: str) -> None:
        for _ in range(3):
            QApplication.processEvents()
        tops = [one for one in QApplication.topLevelWidgets() if one.isVisible() and not one.inherits(SYSTEM)]
        texts = [(where, plain(text)) for top in tops for where, text in shown_in(top)]
        texts += [("painted", text) for text in self._painted]
        self._painted.clear()
        self.own += len(numbers_in(texts, OWN[self.language]))
        self.foreign += [f"{scene}: {one}" for one in numbers_in(texts, FOREIGN[self.language])]


class TestTheWindow:
    pytestmark = NEEDS_SCREEN

    @pytest.fixture
    def open_stage(self, theme, tmp_path: Path, monkeypatch, painted) -> Iterator[Callable[[str], Stage]]:
        without_kernel = {name: modules for name, modules in STAGES.items() if name != "worker"}
        monkeypatch.setattr(app, "Loader", partial(Loader, without_kernel))
        opened: list[Stage] = []

        def make(language: str) -> Stage:
            stage = Stage(theme, tmp_path, Reader(language, painted), built=False, rest=0.03)
            opened.append(stage)
            stage.open()
            with_results(stage)
            stage.resize(1280, 720)
            return stage

        yield make
        for stage in opened:
            stage.window = stage.studio.window
            stage.leave()

    @pytest.mark.slow
    @pytest.mark.parametrize("language", ["de", "en"])
    def test_no_number_is_written_as_in_another_language(self, language: str, open_stage, speak) -> None:
        speak(language)
        stage = open_stage(language)
        scenes = (
            panels.views, panels.picked, panels.form, panels.derived_and_log, panels.solids, pages.charts,
            pages.contact, pages.data_sheet, pages.measurement, dialogs.exports, dialogs.projects, preferences,
        )  # fmt: skip
        for scene in scenes:
            scene(stage)
            stage.close_all()
        assert stage.look.own > 1000, "the sweep has seen numbers"
        assert not stage.look.foreign, "\n".join(dict.fromkeys(stage.look.foreign))

    def test_numbers_follow_while_the_window_is_open(self, open_stage, speak, qtbot) -> None:
        stage = open_stage("en")
        studio, session = stage.studio, stage.session
        typed = {"pair.outer_module": 4.25, "tooth.profile_shift": "1x", "lengthwise.spiral_angle_deg": 33.3}
        for path, value in typed.items():
            studio.window.form.field_edited.emit(path, value)
        studio.window.analysis.show_tab("contact")
        studio.window.analysis.page.controls.rows["offset"].box.setValue(0.125)
        draft = dict(session.draft)
        for language in ("de", "en", "de"):
            studio.speak(language)
            qtbot.waitUntil(lambda: studio.window.area.grid is not None, timeout=20_000)
            window, look = studio.window, Reader(language, [])
            assert session.draft == draft
            sign = "," if language == "de" else "."
            rows = window.form.rows
            assert rows["pair.outer_module"].field.text() == f"4{sign}25"
            assert rows["tooth.profile_shift"].field.text() == "1x", "what is no number stays as typed"
            assert {path: rows[path].field.value() for path in typed} == typed
            assert f"33{sign}3°" in window.commands["undo"].text().replace(" ", "")
            assert window.analysis.page.controls.rows["offset"].box.text().startswith(f"0{sign}125")
            look("switched")
            assert look.own > 100 and not look.foreign, "\n".join(look.foreign)
