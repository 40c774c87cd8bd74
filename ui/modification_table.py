"""The micro-geometry of all four flanks as a table: a row for each kind, a column for each flank."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QWidget

from gearstudio.design import FOLDED_GROUPS, FieldSpec
from gearstudio.errors import Issue
from ui.fields import set_severity
from ui.form_rows import FieldRow
from ui.formatting import MEMBER_TITLES
from ui.units import unit_shown
from ui.words import tr

MODIFICATIONS = "Micro-geometry"
FLANK_TITLES = {"concave": "concave", "convex": "convex"}
LABEL_WIDTH = 96


def section_of(spec: FieldSpec) -> str:
    """The section of the form that a field stands in: the groups of the four flanks share one."""
    return MODIFICATIONS if spec.group in FOLDED_GROUPS else spec.group


class FieldCell(FieldRow):
    """A field of the table: the editor alone; its label is the row's, its message is told by the table.

    Signals
    -------
    said()
        Another message belongs to this field.
    """

    said = Signal()

    def say(self, issues: Sequence[Issue]) -> None:
        super().say(issues)
        self._message.hide()
        self.said.emit()

    @property
    def note(self) -> str:
        """What is to be said of the field, and how grave it is by its colour."""
        return self._message.text()

    @property
    def severity(self) -> str:
        """``"error"``, ``"warning"`` or empty."""
        return str(self._message.property("severity") or "")

    def show_changed(self, changed: bool) -> None:
        """Bold while it differs from the default; the context menu resets it."""
        super().show_changed(changed)
        self.reset.hide()
        font = self.field.font()
        font.setBold(changed)
        self.field.setFont(font)

    def set_found(self, found: bool) -> None:
        """The table stays whole while fields are searched for."""

    def _arrange(self) -> None:
        for widget in (self._label, self._message, self._unit, self.reset):
            widget.setParent(self)
            widget.hide()
        member, flank = self.spec.path.split(".")[1:3]
        where = f"{tr(MEMBER_TITLES[member])}, {tr(FLANK_TITLES[flank])}"
        self.field.setAccessibleName(f"{tr(self.spec.title)}, {where}")
        self.field.setProperty("role", "cell")
        self.field.setMinimumWidth(40)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.field)


class ModificationTable(QWidget):
    """Cells made from the fields' own descriptions, with headings, units and one line for what is wrong."""

    def __init__(self, specs: Sequence[FieldSpec], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.cells = tuple(FieldCell(spec) for spec in specs)
        kinds = list(dict.fromkeys(spec.path.split(".")[3] for spec in specs))
        flanks = list(dict.fromkeys(tuple(spec.path.split(".")[1:3]) for spec in specs))
        self._note = QLabel()
        self._note.setWordWrap(True)
        self._note.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        grid = QGridLayout(self)
        grid.setContentsMargins(18, 0, 0, 0)
        grid.setHorizontalSpacing(4)
        grid.setVerticalSpacing(3)
        members = list(dict.fromkeys(member for member, _ in flanks))
        for place, member in enumerate(members):
            wide = sum(owner == member for owner, _ in flanks)
            grid.addWidget(_heading(tr(MEMBER_TITLES[member])), 0, 1 + place * wide, 1, wide)
        for column, (_, flank) in enumerate(flanks, start=1):
            grid.addWidget(_heading(tr(FLANK_TITLES[flank])), 1, column)
            grid.setColumnStretch(column, 1)
        for cell in self.cells:
            _, member, flank, kind = cell.spec.path.split(".")
            row = 2 + kinds.index(kind)
            if grid.itemAtPosition(row, 0) is None:
                grid.addWidget(_title(cell.spec), row, 0)
                grid.setColumnMinimumWidth(0, max(grid.columnMinimumWidth(0), cell.longest_word))
            grid.addWidget(cell, row, 1 + flanks.index((member, flank)))
            cell.said.connect(self._tell)
        grid.addWidget(self._note, 2 + len(kinds), 0, 1, 1 + len(flanks))
        by_row = sorted(self.cells, key=lambda cell: kinds.index(cell.spec.path.split(".")[3]))
        for before, after in pairwise(by_row):
            QWidget.setTabOrder(before.field, after.field)
        self._tell()

    def _tell(self) -> None:
        said = [cell for cell in self.cells if cell.note]
        self._note.setText("\n".join(f"{cell.field.accessibleName()}: {cell.note}" for cell in said))
        grave = [cell.severity for cell in said]
        set_severity(self._note, "error" if "error" in grave else "warning" if "warning" in grave else "")
        self._note.setVisible(bool(said))


def _title(spec: FieldSpec) -> QLabel:
    unit = unit_shown(spec.unit)
    label = QLabel(f"{tr(spec.title)} [{unit}]" if unit else tr(spec.title))
    label.setWordWrap(True)
    label.setMinimumWidth(LABEL_WIDTH)
    label.setToolTip(tr(spec.description))
    return label


def _heading(text: str) -> QLabel:
    label = QLabel(text, alignment=Qt.AlignmentFlag.AlignCenter)
    label.setProperty("role", "muted")
    return label
