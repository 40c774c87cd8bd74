"""Properties of solids in a chosen material, a column for each member."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
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
from ui.formatting import MEMBER_TITLES, number, number_text, parse_number, typed
from ui.materials import CUSTOM, MATERIALS, density_unit, properties
from ui.quiet_table import RIGHT, ROW_HEIGHT, quieten
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.results import SolidResult

HEAVIEST = 30000.0


class DensityField(QLineEdit):
    """A number that the table keeps, not its text."""


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
        self.density_field = DensityField()
        self.density_field.setAccessibleName(tr("Density"))
        self.density_field.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.density_field.setFixedWidth(64)
        self._unit = QLabel()
        self._unit.setProperty("role", "muted")
        self.material.currentIndexChanged.connect(self._on_material)
        self.density_field.textEdited.connect(self._on_density)
        choice = QHBoxLayout()
        choice.setSpacing(6)
        choice.addWidget(self.material, 1)
        choice.addWidget(self.density_field)
        choice.addWidget(self._unit)
        self.table = QTableWidget(0, 2)
        self.table.setAccessibleName(tr("Properties of the solids"))
        self.table.setToolTip(tr("Volume, mass and moments of the solids that are built"))
        quieten(self.table)
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
        self._unit.setText(density_unit()[0])
        self.density_field.setText(_density_text(self._density))
        self._say_density()

    def show_results(self, results: dict[str, SolidResult | None]) -> None:
        """Show solids by member; None where there is none yet."""
        shown = [*map(id, self._results)], self._members
        self._members, self._results = tuple(results), tuple(results.values())
        if shown != ([*map(id, self._results)], self._members):
            self._refresh()

    def show_units(self) -> None:
        """Show sizes, density and masses in the units chosen."""
        unit, _ = density_unit()
        self._unit.setText(unit)
        self.density_field.setText(_density_text(self._density))
        self._say_density()
        self._refresh()

    def keep_state(self) -> float:
        """The density, for `take_state`."""
        return self._density

    def take_state(self, state: object) -> None:
        """Take a density."""
        if isinstance(state, int | float):
            self._density = float(state)
            self.show_units()

    def _refresh(self) -> None:
        rows = properties(self._results, self._density)
        self.table.setColumnCount(1 + len(self._members))
        self.table.setHorizontalHeaderLabels(["", *(tr(MEMBER_TITLES[member]) for member in self._members)])
        header = self.table.horizontalHeader()
        for column in range(self.table.columnCount()):
            stretched = column == len(self._members)
            mode = QHeaderView.ResizeMode.Stretch if stretched else QHeaderView.ResizeMode.ResizeToContents
            header.setSectionResizeMode(column, mode)
            if column:
                self.table.horizontalHeaderItem(column).setTextAlignment(RIGHT)
        self.table.setRowCount(len(rows))
        for index, row in enumerate(rows):
            title = f"{row.title}, {row.unit}" if row.unit else row.title
            for column, text in enumerate((title, *row.texts)):
                item = QTableWidgetItem(text)
                item.setToolTip(row.tip or title)
                if column:
                    item.setTextAlignment(RIGHT)
                self.table.setItem(index, column, item)
        height = header.sizeHint().height() + len(rows) * ROW_HEIGHT + 4
        self.table.setFixedHeight(height)

    @property
    def density(self) -> float:
        """Density in use [kg/m³]."""
        return self._density

    def _on_material(self) -> None:
        density = self.material.currentData()
        if density is not None:
            self.density_field.setText(_density_text(density))
            self._take(density)

    def _on_density(self, text: str) -> None:
        value, (unit, factor) = parse_number(text), density_unit()
        if isinstance(value, str) or not 0 < value / factor <= HEAVIEST:
            set_severity(self.density_field, "error")
            most = f"{number(HEAVIEST * factor)} {unit}"
            self.density_field.setToolTip(tr("A number above 0, at most {most}", most=most))
            return
        shown = [_density_text(material.density) for material in MATERIALS]
        known = [index for index, one in enumerate(shown) if parse_number(one) == value]
        density = MATERIALS[known[0]].density if known else value / factor
        with QSignalBlocker(self.material):
            self.material.setCurrentIndex(known[0] if known else self.material.count() - 1)
        self._take(float(density))

    def _say_density(self) -> None:
        self.density_field.setToolTip(tr("Density of the material in {unit}", unit=density_unit()[0]))

    def _take(self, density: float) -> None:
        set_severity(self.density_field, "")
        self._say_density()
        self._density = density
        self._refresh()


def _density_text(density: float) -> str:
    """A density [kg/m³] as one would type it."""
    _, factor = density_unit()
    return number_text(density) if factor == 1 else typed(density * factor, 5)
