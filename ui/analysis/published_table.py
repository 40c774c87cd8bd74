"""Published values beside those of the program: pass or fail."""

from __future__ import annotations

from PySide6.QtGui import QColor
from PySide6.QtWidgets import QLabel, QTableWidgetItem, QVBoxLayout, QWidget

from gearstudio.analysis.selfcheck import Check, self_check
from ui.formatting import written
from ui.quiet_table import LEFT, RIGHT, add_heading, cell, quiet_table
from ui.theme import tokens
from ui.words import tr

HEADS = ("Quantity", "Published", "Computed", "Unit", "")


class PublishedTable(QWidget):
    """The self-check gallery."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.checks = self_check()
        self.table = quiet_table(HEADS, (100, 100, 54, 130), tr("Published values and those computed"))
        for column in (1, 2):
            self.table.horizontalHeaderItem(column).setTextAlignment(RIGHT)
        self.summary = QLabel(summary(self.checks))
        self.summary.setContentsMargins(8, 4, 8, 4)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.summary)
        layout.addWidget(self.table)
        self.refresh_theme()

    def refresh_theme(self) -> None:
        """Fill in, in the colours of the theme in use."""
        table = self.table
        table.clearSpans()
        table.setRowCount(len(self.checks) + len({check.source for check in self.checks}))
        row, source = 0, ""
        for check in self.checks:
            if check.source != source:
                source = check.source
                add_heading(table, row, tr(source))
                row += 1
            texts = (_named(check.name), written(check.published), written(check.computed) or "–", tr(check.unit))
            for column, text in enumerate(texts):
                table.setItem(row, column, cell(text, RIGHT if column in (1, 2) else LEFT))
            table.setItem(row, 4, _verdict(check))
            row += 1

    def text_table(self) -> str:
        """All values as tab-separated text."""
        rows = [
            (tr(c.source), _named(c.name), c.published, c.computed or "–", tr(c.unit), verdict(c)) for c in self.checks
        ]
        head = (tr("Source"), *map(tr, HEADS[:4]), tr("Verdict"))
        return "\n".join("\t".join(row) for row in [head, *rows]) + "\n"


def _named(name: str) -> str:
    """``pinion: pitch angle`` in the window's language."""
    return ": ".join(map(tr, name.split(": ")))


def verdict(check: Check) -> str:
    """Pass, fail, or that there is nothing to compare."""
    return {True: tr("✓ pass"), False: tr("✗ fail"), None: tr("not computable")}[check.passed]


def summary(checks: tuple[Check, ...]) -> str:
    """How many agree, in a line."""
    passed = sum(check.passed is True for check in checks)
    failed = sum(check.passed is False for check in checks)
    words = tr("{passed} of {all} published values agree to the last printed digit", passed=passed, all=passed + failed)
    return tr("{words}; {failed} do not.", words=words, failed=failed) if failed else f"{words}."


def _verdict(check: Check) -> QTableWidgetItem:
    item = cell(verdict(check))
    colors = tokens()
    item.setForeground(QColor({True: colors.ok, False: colors.error, None: colors.faint}[check.passed]))
    if check.passed is None:
        item.setToolTip(tr("The publication does not print the data from which it could be computed"))
    return item
