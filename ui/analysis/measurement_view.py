"""From measured points to topography, pitch chart and words; no widget."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement import MeasurementResult
from gearstudio.analysis.measurement_errors import NAMED_ERRORS, NamedError
from gearstudio.analysis.nets import cell_means
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.modified import flank_of
from ui.analysis.measurement_data import ALL_TEETH, Measurement
from ui.charts.maps import FlankMap, Line, MapData
from ui.charts.raster import frame, outline, points_flat
from ui.charts.records import Axis, ChartData, Entry, Series, Table
from ui.formatting import fixed, micrometres
from ui.units import small_text
from ui.words import tr

Floats = NDArray[np.float64]
SHEAR, TILT, LONGEST_BAR = 0.24, 0.36, 0.2
"""How the flank is drawn, and the length of the longest bar: parts of the face width."""


def topography(measurement: Measurement, tooth: int = ALL_TEETH) -> tuple[MapData, float]:
    """Both flanks drawn flat with a bar at each point, all to one scale; and the longest bar [µm]."""
    member, result = measurement.member, measurement.result
    chosen = np.ones(len(result.tooth), dtype=bool) if tooth == ALL_TEETH else result.tooth == tooth
    nets = {name: _nodes(member, result, chosen & (result.side == flank_of(member, name).side)) for name in FLANKS}
    largest = max(float(np.nanmax(np.abs(error), initial=0.0)) for _, error in nets.values())
    data = MapData(
        f"topography-{member.name}",
        tuple(_bars(member, name, *net, largest or 1.0) for name, net in nets.items()),
        lambda image: np.zeros((*image.shape, 4), dtype=np.uint8),
        across=True,
        table=lambda: points_table(result),
    )
    return data, largest


def _nodes(member: MemberGeometry, result: MeasurementResult, chosen: NDArray[np.bool_]) -> tuple[Floats, Floats]:
    """Places (n, m, 2) and deviations (n, m) [µm] of the points, brought to a net."""
    face, profile = result.face_place[chosen], result.profile_place[chosen]
    x, y = _tilted(member, result.pose.undo(result.points[chosen]))
    x, y, error = (cell_means(values, face, profile) for values in (x, y, result.deviation_um[chosen]))
    return np.stack([x, y], axis=-1), error


def _bars(member: MemberGeometry, name: FlankName, feet: Floats, error: Floats, largest: float) -> FlankMap:
    flank, longest = flank_of(member, name), LONGEST_BAR * member.face_width
    edge = outline(*_tilted(member, flank.points(*np.ix_(np.linspace(0, 1, 9), np.linspace(0, 1, 25)))))
    tips = feet + np.stack([np.zeros_like(error), error / largest * longest], axis=-1)
    strokes = np.stack([feet, tips], axis=-2)
    lines = (
        Line(_net(feet), "border_strong", 1.0, pairs=True),
        Line(_net(tips), "muted", 1.0, pairs=True),
        Line(strokes[error >= 0].reshape(-1, 2), "added", 2.6, pairs=True),
        Line(strokes[error < 0].reshape(-1, 2), "missing", 2.6, pairs=True),
    )
    title = tr(f"{name.capitalize()} flank") + ("" if np.any(np.isfinite(error)) else tr(": not measured"))
    return FlankMap(title, np.full((2, 2), np.nan), frame(edge), edge, lines, reach=longest)


def _net(nodes: Floats) -> Floats:
    """Strokes from node to neighbouring node, as pairs of points; gaps where there is no node."""
    along = np.stack([nodes[:, :-1], nodes[:, 1:]], axis=-2).reshape(-1, 2, 2)
    across = np.stack([nodes[:-1], nodes[1:]], axis=-2).reshape(-1, 2, 2)
    strokes = np.concatenate([along, across])
    return strokes[np.all(np.isfinite(strokes), axis=(1, 2))].reshape(-1, 2)


def _tilted(member: MemberGeometry, points: Floats) -> tuple[Floats, Floats]:
    """Places on the flank drawn flat and seen aslant, as a floor on which bars stand."""
    x, y = points_flat(points, member.pitch_angle)
    depth = member.addendum + member.dedendum
    return x + SHEAR * member.face_width * y / depth, TILT * member.face_width * y / depth


def pitch_chart(measurement: Measurement) -> ChartData:
    """Single and cumulative pitch errors of the teeth measured."""
    pitches = measurement.result.pitch
    series = [
        Series(tr("{name}, cumulative", name=tr(name.capitalize())), 1.0 + p.tooth, p.cumulative_um, name, symbols=True)
        for name, p in pitches.items()
    ]
    series += [
        Series(tr("{name}, single", name=tr(name.capitalize())), 1.0 + p.tooth, p.single_um, name, "dash")
        for name, p in pitches.items()
    ]
    few = all(len(p.tooth) < 2 for p in pitches.values())
    return ChartData(
        name=f"pitch-errors-{measurement.member.name}",
        x=Axis(tr("Tooth")),
        y=Axis(tr("Pitch error"), "µm"),
        series=() if few else tuple(series),
        legend=(*(Entry(s.name, s.color, s.stroke) for s in series),) if not few else (),
        note=tr("One tooth was measured: there is no pitch to compare") if few else "",
        span_y=(-0.5, 0.5),
    )


def points_table(result: MeasurementResult) -> Table:
    """Every point with its tooth, flank, place and deviation."""
    columns = (result.tooth + 1, result.flanks, *result.points.T, result.face_place, result.profile_place)
    rows = list(zip(*columns, result.deviation_um, strict=True))
    return Table(("tooth", "flank", "x [mm]", "y [mm]", "z [mm]", "face 0-1", "profile 0-1", "deviation [µm]"), rows)


def statistics_rows(measurement: Measurement) -> list[tuple[str, str]]:
    """What holds for all points: name and value."""
    result = measurement.result
    found = result.statistics
    return [
        (
            tr("Points"),
            f"{len(result.points)}" + (tr(" (+ {count} beside)", count=result.beside) if result.beside else ""),
        ),
        (tr("Teeth"), tr("{count} of {all}", count=len(measurement.teeth), all=measurement.member.teeth)),
        (tr("Turned by"), f"{fixed(float(np.degrees(result.pose.turn)), 6)}°"),
        (tr("Shifted by"), small_text(result.pose.shift)),
        (tr("Max"), micrometres(found.max_um)),
        (tr("Mean"), micrometres(found.mean_um)),
        (tr("Rms"), micrometres(found.rms_um)),
    ]


def error_rows(measurement: Measurement) -> list[tuple[str, ...]]:
    """Named errors [µm]: name, concave, convex."""
    form, pitch = measurement.result.form, measurement.result.pitch

    def text(error: NamedError, flank: FlankName) -> str:
        value = error.of(form[flank], pitch[flank]) if flank in form else None
        return "–" if value is None else fixed(value, 2)

    return [
        (tr(error.title), *(text(error, flank) for flank in FLANKS)) for error in NAMED_ERRORS if error.unit == "µm"
    ]
