"""Properties of solids in a chosen material, a column for each member."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ui.fields import set_severity
from ui.formatting import MEMBER_TITLES, number_text, parse_number
from ui.materials import CUSTOM, MATERIALS, properties
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.results import SolidResult

HEAVIEST = 30000.0
_ROW_HEIGHT = 23
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class PropertiesTable(QWidget):
    """Material and density above, numbers below."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._members: tuple[str, ...] = ()
        self._results: tuple[SolidResult | None, ...] = ()
        self.material = QComboBox()
        self.material.setAccessibleName(tr("Material"))
        self.material.setToolTip(tr("Material that the mass is computed with"))
        for material in MATERIALS:
            self.material.addItem(tr(material.name), material.density)
        self.material.addItem(tr(CUSTOM), None)
        self._density = MATERIALS[0].density
        self.density_field = QLineEdit(number_text(self._density))
        self.density_field.setAccessibleName(tr("Density"))
        self.density_field.setToolTip(tr("Density of the material in kg/m³"))
        self.density_field.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.density_field.setFixedWidth(64)
        unit = QLabel("kg/m³")
        unit.setProperty("role", "muted")
        self.material.currentIndexChanged.connect(self._on_material)
        self.density_field.textEdited.connect(self._on_density)
        choice = QHBoxLayout()
        choice.setSpacing(6)
        choice.addWidget(self.material, 1)
        choice.addWidget(self.density_field)
        choice.addWidget(unit)
        self.table = QTableWidget(0, 2)
        self.table.setAccessibleName(tr("Properties of the solids"))
        self.table.setToolTip(tr("Volume, mass and moments of the solids that are built"))
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(_ROW_HEIGHT)
        self.table.setShowGrid(False)
        self.table.setAlternatingRowColors(True)
        self.table.setWordWrap(False)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        heading = QLabel(tr("Properties"))
        heading.setProperty("role", "heading")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        layout.addWidget(heading)
        layout.addLayout(choice)
        layout.addWidget(self.table)

    def show_results(self, results: dict[str, SolidResult | None]) -> None:
        """Show solids by member; None where there is none yet."""
        shown = [*map(id, self._results)], self._members
        self._members, self._results = tuple(results), tuple(results.values())
        if shown != ([*map(id, self._results)], self._members):
            self._refresh()

    def text_table(self) -> str:
        """All properties as tab-separated text."""
        rows = properties(self._results, self._density)
        head = "\t".join(["", *(tr(MEMBER_TITLES[member]) for member in self._members), ""])
        return "\n".join([head, *("\t".join([row.title, *row.texts, row.unit]) for row in rows)])

    def _refresh(self) -> None:
        rows = properties(self._results, self._density)
        self.table.setColumnCount(1 + len(self._members))
        self.table.setHorizontalHeaderLabels(["", *(tr(MEMBER_TITLES[member]) for member in self._members)])
        header = self.table.horizontalHeader()
        for column in range(self.table.columnCount()):
            mode = QHeaderView.ResizeMode.Stretch if column == 0 else QHeaderView.ResizeMode.Fixed
            header.setSectionResizeMode(column, mode)
            if column:
                self.table.setColumnWidth(column, 60 if len(self._members) > 1 else 110)
                self.table.horizontalHeaderItem(column).setTextAlignment(_RIGHT)
        self.table.setRowCount(len(rows))
        for index, row in enumerate(rows):
            title = f"{row.title}, {row.unit}" if row.unit else row.title
            for column, text in enumerate((title, *row.texts)):
                item = QTableWidgetItem(text)
                item.setToolTip(row.tip or title)
                if column:
                    item.setTextAlignment(_RIGHT)
                self.table.setItem(index, column, item)
        height = header.sizeHint().height() + len(rows) * _ROW_HEIGHT + 4
        self.table.setFixedHeight(height)

    @property
    def density(self) -> float:
        """Density in use [kg/m³]."""
        return self._density

    def _on_material(self) -> None:
        density = self.material.currentData()
        if density is not None:
            self.density_field.setText(number_text(density))
            self._take(density)

    def _on_density(self, text: str) -> None:
        density = parse_number(text)
        if isinstance(density, str) or not 0 < density <= HEAVIEST:
            set_severity(self.density_field, "error")
            self.density_field.setToolTip(tr("A number above 0, at most {most:g} kg/m³", most=HEAVIEST))
            return
        known = [index for index, material in enumerate(MATERIALS) if material.density == density]
        with QSignalBlocker(self.material):
            self.material.setCurrentIndex(known[0] if known else self.material.count() - 1)
        self._take(float(density))

    def _take(self, density: float) -> None:
        set_severity(self.density_field, "")
        self.density_field.setToolTip("")
        self._density = density
        self._refresh()
