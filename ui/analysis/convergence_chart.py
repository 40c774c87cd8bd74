"""From convergence studies to a chart: deviation against effort; no widget."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from gearstudio.analysis.convergence import COUNTED, ConvergenceStudy
from gearstudio.catalogue import METHOD_IDS
from ui.charts.records import Axis, ChartData, Entry, Reference, Series, Table, micrometre_tick, plain
from ui.formatting import METHOD_TITLES, micrometres
from ui.words import inline, tr

EFFORTS = (
    ("count", "Count", "Positions, sections, or points along each side of the grid"),
    ("poles", "Poles", "Control points of the heavier flank"),
    ("seconds", "Seconds", "Time to build both flanks"),
)
SIZES = (
    ("max_um", "Largest", "Largest deviation over both flanks"),
    ("mean_um", "Mean", "Mean of the absolute deviations"),
    ("rms_um", "Rms", "Root of the mean square"),
    ("seconds", "Seconds", "Time to build both flanks"),
    ("poles", "Poles", "Control points of the heavier flank"),
)
LEAST_UM = 1e-7
_TICKS = {"count": (4, 6, 10, 20, 40), "poles": (10, 30, 100, 300, 1000, 3000)}
_SECONDS = (1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0)


def convergence_chart(
    studies: Mapping[str, ConvergenceStudy], effort: str, size: str, member: str, tolerance_um: float
) -> ChartData:
    """Sizes of deviation (or cost) against effort, both logarithmic, with the tolerance as a line."""
    found = {method: studies[method] for method in METHOD_IDS if method in studies and studies[method].points}
    deviation = size.endswith("_um")
    series = tuple(
        Series(
            tr(METHOD_TITLES[method]),
            np.array([float(getattr(point, effort)) for point in study.points]),
            np.maximum([getattr(point, size) for point in study.points], LEAST_UM if deviation else 1e-9),
            method,
            symbols=True,
        )
        for method, study in found.items()
    )
    titles = {name: title for name, title, _ in (*EFFORTS, *SIZES)}
    words = tr("tolerance {value}", value=micrometres(tolerance_um))
    return ChartData(
        name=f"convergence-{member}-{size}-{effort}",
        x=Axis(tr(titles[effort]), "", True, _writer(effort)),
        y=Axis(tr("Deviation, {kind}", kind=inline(titles[size])) if deviation else tr(titles[size]), "", True,
               micrometre_tick if deviation else _writer(size)),
        series=series,
        references=(Reference(tolerance_um, words, "warning"),) if deviation and series else (),
        legend=tuple(Entry(_legend(study, tolerance_um), method) for method, study in found.items()),
        note="" if series else tr("Run the study: each method is built with growing effort"),
        ticks=[(float(np.log10(value)), _writer(effort)(value)) for value in _TICKS.get(effort, _SECONDS)],
        table=_table(found),
    )  # fmt: skip


def _legend(study: ConvergenceStudy, tolerance_um: float) -> str:
    """The method, and from which count on it keeps the tolerance."""
    reached, title = study.reaching(tolerance_um), tr(METHOD_TITLES[study.method])
    return title if reached is None else f"{title}: {reached.count} {tr(COUNTED[study.method])}"


def summary(studies: Mapping[str, ConvergenceStudy], tolerance_um: float) -> str:
    """At which effort each method reaches the tolerance, in a line."""
    parts = []
    for method in METHOD_IDS:
        if method in studies:
            reached = studies[method].reaching(tolerance_um)
            words = "–" if reached is None else f"{reached.count} {tr(COUNTED[method])}, {reached.poles} {tr('poles')}"
            parts.append(f"{tr(METHOD_TITLES[method])}: {words}")
    return tr("Within {value}: {efforts}", value=micrometres(tolerance_um), efforts="; ".join(parts)) if parts else ""


def _writer(effort: str) -> Callable[[float], str]:
    return _time if effort == "seconds" else plain


def _time(seconds: float) -> str:
    return f"{plain(seconds * 1e3)} ms" if seconds < 1 else f"{plain(seconds)} s"


def _table(studies: Mapping[str, ConvergenceStudy]) -> Table:
    head = ("method", "count", "poles", "seconds", "max [µm]", "mean [µm]", "rms [µm]")
    rows = [
        (method, p.count, p.poles, p.seconds, p.max_um, p.mean_um, p.rms_um)
        for method, study in studies.items()
        for p in study.points
    ]
    return Table(head, rows)
