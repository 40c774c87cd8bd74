"""Derived values of pairs with an offset: base cone and pressure angle of both flanks, each of its own."""

from __future__ import annotations

import math

import pytest
from pytestqt.qtbot import QtBot

from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.modified import flank_member
from ui.derived_panel import QUANTITIES, SYMBOL, DerivedPanel, pair_rows, quantities

pytestmark = pytest.mark.ui


def rows_of(panel: DerivedPanel) -> list[tuple[str, ...]]:
    view = panel.view
    cells = [[view.item(row, column) for column in (0, 1, 2)] for row in range(view.rowCount())]
    return [tuple(item.text().strip() if item else "" for item in row) for row in cells]


def test_both_flanks_are_shown_and_none_without_an_offset(qtbot: QtBot) -> None:
    panel = DerivedPanel()
    qtbot.addWidget(panel)
    bevel, hypoid = (pair_geometry(PRESETS_BY_KEY[key].design) for key in ("default", "hypoid-car"))
    for pair in (bevel, hypoid, bevel):
        panel.show_pair(pair)
        rows = rows_of(panel)
        assert len(rows) == len(quantities(pair)) + len(pair_rows(pair)) == panel.view.rowCount()
        (at,) = [number for number, row in enumerate(rows) if row[0] == "Base angle"]
        assert any(rows[at][1:]) == (not pair.has_offset)
        spans = [panel.view.columnSpan(row, 1) for row in range(panel.view.rowCount())]
        assert spans == [1] * len(quantities(pair)) + [2] * len(pair_rows(pair))
        symbols = [panel.view.item(row, 0).data(SYMBOL) for row in range(len(quantities(pair)))]
        assert symbols == [quantity.symbol for quantity in quantities(pair)]
    assert quantities(bevel) == QUANTITIES
    panel.show_pair(hypoid)
    rows = rows_of(panel)
    at = next(number for number, row in enumerate(rows) if row[0] == "Base angle")
    for (name, *shown), flank in zip(rows[at + 1 : at + 3], ("concave", "convex"), strict=True):
        assert name == f"{flank} flank"
        for text, member in zip(shown, (hypoid.pinion, hypoid.wheel), strict=True):
            side = member.hand if flank == "concave" else -member.hand
            assert float(text) == pytest.approx(math.degrees(flank_member(member, side).base_angle), abs=1e-3)
    assert rows[at + 1][1:] != rows[at + 2][1:]
    assert "Base angle, convex" in {quantity.name for quantity in quantities(hypoid)}
