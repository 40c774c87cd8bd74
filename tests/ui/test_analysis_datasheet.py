"""The data sheet in the window: values, explanations, copies, and the published values."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtGui import QGuiApplication

from gearstudio.design import Design
from ui.session import Session

pytestmark = pytest.mark.ui


@pytest.fixture
def session() -> Session:
    made = Session()
    made.load(Design())
    return made


@pytest.fixture
def page(qtbot, theme, session):
    from ui.analysis.datasheet_page import DatasheetPage

    made = DatasheetPage()
    qtbot.addWidget(made)
    made.resize(900, 300)
    made.show()
    made.show_session(session)
    return made


def shown(page, key: str) -> list[str]:
    page.table.choose(key)
    table = page.table.table
    return [table.item(table.currentRow(), column).text() for column in range(5)]


def test_values_of_both_members_stand_side_by_side(page) -> None:
    assert shown(page, "delta") == ["Pitch angle", "δ", "23.02549", "66.97451", "°"]
    assert shown(page, "R_e") == ["Outer cone distance", "R_e", "86.9253", "", "mm"]


def test_a_row_explains_itself(page) -> None:
    shown(page, "R_e")
    text = page.explanation.text()
    assert "m<sub>et</sub> z / (2 sin δ)" in text and "4.0000&nbsp;mm" in text and "86.9253" in text
    assert "section 2" in text and "equation 7 of the paper" in text
    shown(page, "delta")
    assert "Pinion" in page.explanation.text() and "Wheel" in page.explanation.text()


def test_an_edit_changes_the_numbers_and_keeps_the_row(page, session) -> None:
    shown(page, "delta")
    session.edit("pair.wheel_teeth", 51)
    page.show_session(session)
    table = page.table.table
    assert table.item(table.currentRow(), 0).text() == "Pitch angle"
    assert table.item(table.currentRow(), 2).text() == "18.43495"
    assert "18.43495" in page.explanation.text()


@pytest.mark.parametrize(
    ("format_", "mark"), [("text", "Pitch angle"), ("csv", "group,name"), ("latex", r"\begin{tabular}")]
)
def test_it_is_copied_and_saved(page, tmp_path: Path, format_: str, mark: str) -> None:
    page.copy(format_)
    assert mark in QGuiApplication.clipboard().text()
    page.save(tmp_path / "sheet", format_)
    assert mark in (tmp_path / "sheet").read_text(encoding="utf-8")
    said: list[str] = []
    page.said.connect(lambda kind, _text: said.append(kind))
    page.save(tmp_path / "no" / "sheet", format_)
    assert said == ["error"]


def test_published_values_are_shown_with_a_verdict(page) -> None:
    page.show_view("published")
    table = page.published.table
    rows = [[table.item(r, c).text() for c in range(5)] for r in range(table.rowCount()) if table.item(r, 1)]
    assert ["pinion: pitch angle", "26.56505", "26.56505", "°", "✓ pass"] in rows
    assert not [row for row in rows if row[4] == "✗ fail"]
    assert ["largest", "71.3", "–", "µm", "not computable"] in rows
    assert "agree" in page.published.summary.text()
    assert "\tpass" in page.text("csv") or "✓ pass" in page.text("csv")


@pytest.mark.parametrize(
    ("equation", "words"),
    [
        ("2 [7]", "Theory, section 2; equation 7 of the paper"),
        ("5.1", "Theory, section 5.1"),
        ("ISO 23509", "ISO 23509"),
        ("hypoid", "Offset axes"),
    ],
)
def test_a_formula_says_where_it_stands(equation: str, words: str) -> None:
    from ui.analysis.explanation import where

    assert where(equation) == words
