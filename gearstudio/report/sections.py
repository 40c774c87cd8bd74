"""The sections that a report may have; loads nothing heavy."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Section:
    """A part of the report: its key, its heading, and what is in it."""

    key: str
    title: str
    summary: str


SECTIONS = (
    Section("design", "Design", "Every field of the design with symbol, value and unit"),
    Section("sheet", "Geometry data sheet", "Dimensions of both members with the standard's names"),
    Section(
        "comparison", "Method comparison", "Deviations of all methods and variants, as a table and along the flank"
    ),
    Section("pictures", "Views", "The flanks of the three methods in perspective"),
    Section("deviation", "Deviation maps", "Where each method deviates from the exact flank"),
    Section("curvature", "Curvature", "Gaussian curvature of the surfaces and of theory"),
    Section("topography", "Topography", "The measuring grid with a bar at each point, both flanks"),
    Section("measurement", "Measurement", "Measured points against the theory: errors of the flanks, a map, the pitch"),
    Section("contact", "Tooth contact", "Contact pattern, ease-off and transmission error, drive and coast"),
    Section("convergence", "Convergence", "Largest deviation against poles and seconds of each method"),
    Section("exports", "Exports", "What was written beside the project, and what was found on reading it back"),
    Section("equations", "Equations", "The formulas used, the paper's departures, and this design's numbers"),
)
SECTION_KEYS = tuple(section.key for section in SECTIONS)
