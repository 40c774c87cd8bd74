"""The pages of the analysis area and how they are made; importing this loads the charts' library."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtWidgets import QWidget

from ui.analysis.cad_jobs import CadJobs
from ui.analysis.charts_page import ChartsPage
from ui.analysis.contact_page import ContactPage
from ui.analysis.datasheet_page import DatasheetPage
from ui.analysis.measurement_page import MeasurementPage


def factories(jobs: CadJobs) -> Mapping[str, Callable[[], QWidget]]:
    """What makes each page; those that need the CAD process reach it through ``jobs``."""
    return {
        "charts": lambda: ChartsPage(jobs),
        "contact": ContactPage,
        "datasheet": DatasheetPage,
        "measurement": lambda: MeasurementPage(jobs),
    }
