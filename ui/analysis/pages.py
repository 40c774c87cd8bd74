"""The pages of the analysis area and how they are made; importing this loads the charts' library."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtWidgets import QWidget

from ui.analysis.charts_page import ChartsPage
from ui.analysis.contact_page import ContactPage
from ui.analysis.datasheet_page import DatasheetPage
from ui.analysis.measurement_page import MeasurementPage

FACTORIES: Mapping[str, Callable[[], QWidget]] = {
    "charts": ChartsPage,
    "contact": ContactPage,
    "datasheet": DatasheetPage,
    "measurement": MeasurementPage,
}
