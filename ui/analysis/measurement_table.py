"""Statistics and named errors of a measurement."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QVBoxLayout, QWidget

from ui.quiet_table import LEFT, RIGHT, add_heading, cell, quiet_table
from ui.words import tr

if TYPE_CHECKING:
    from ui.analysis.measurement_data import Measurement

HEADS = ("", "Concave", "Convex")


class MeasurementTable(QWidget):
    """Errors of both flanks in µm, and below them what holds for all points."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = quiet_table(HEADS, (86, 86), tr("Errors and statistics of the measured points"))
        for column in (1, 2):
            self.table.horizontalHeaderItem(column).setTextAlignment(RIGHT)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.table)
        self.setVisible(False)

    def clear(self) -> None:
        """Show nothing."""
        self.table.setRowCount(0)
        self.hide()

    def show_measurement(self, measurement: Measurement) -> None:
        """Fill in a measurement."""
        from ui.analysis.measurement_view import error_rows, statistics_rows

        errors, statistics = error_rows(measurement), statistics_rows(measurement)
        self.table.clearSpans()
        self.table.setRowCount(len(errors) + len(statistics) + 2)
        add_heading(self.table, 0, tr("Errors [µm]"))
        for row, texts in enumerate(errors, start=1):
            for column, text in enumerate(texts):
                self.table.setItem(row, column, cell(text, RIGHT if column else LEFT))
        start = len(errors) + 1
        add_heading(self.table, start, tr("All points"))
        for row, (name, value) in enumerate(statistics, start=start + 1):
            for column, text in enumerate((name, value, "")):
                self.table.setItem(row, column, cell(text, RIGHT if column else LEFT))
            self.table.setSpan(row, 1, 1, 2)
        self.show()
