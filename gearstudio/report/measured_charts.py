"""Figures of the report for measured points: the deviation over both flanks, the pitch errors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement import MeasurementResult
from gearstudio.analysis.nets import cell_means
from gearstudio.report.language import FLANKS_SAID, tr
from gearstudio.report.maps import absent, bars, colored, longest_bar, name_axes
from gearstudio.report.style import DIVERGING, SIDES, Frame, figure, length_unit, rounded_up, scale, svg
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.vectors import spherical

Floats = NDArray[np.float64]
_LEAST_UM = 1e-3
_ROOM = 0.02


def topography(member: MemberGeometry, result: MeasurementResult) -> bytes:
    """Both flanks drawn flat: a bar at each node of the measured grid, and below it the same in colours."""
    nets = {name: _net(member, result, name) for name in FLANKS}
    largest = max(float(np.nanmax(np.abs(error), initial=0.0)) for _, _, error in nets.values())
    limit = rounded_up(max(largest, _LEAST_UM))
    unit, factor = length_unit(limit)
    end = limit * factor
    with figure(Frame(3.6, 2, 2, "row")) as (drawn, axes):
        for k, name in enumerate(FLANKS):
            x, y, error = nets[name]
            above, below = axes[0, k], axes[1, k]
            if not np.any(np.isfinite(error)):
                above.set_title(tr(FLANKS_SAID[name]))
                absent(above, tr("not measured"))
                absent(below, tr("not measured"))
                continue
            above.set_title(f"{tr(FLANKS_SAID[name])}: {longest_bar(float(np.nanmax(np.abs(error))))}")
            bars(above, x, y, error / (largest or 1.0), SIDES[name])
            room = _ROOM * float(np.nanmax(x) - np.nanmin(x))
            above.set_xlim(float(np.nanmin(x)) - room, float(np.nanmax(x)) + room)
            if min(error.shape) > 1 and np.all(np.isfinite(error)):
                shown = colored(below, x, y, error * factor, (-end, end), DIVERGING)
            else:
                shown = below.scatter(x, y, c=error * factor, cmap=DIVERGING, vmin=-end, vmax=end, s=12, ec="#60666e",
                                      linewidths=0.3)  # fmt: skip
                below.grid(False)
            scale(drawn, axes[1, -1], shown, unit, (-end, -end / 2, 0.0, end / 2, end))
        name_axes(axes)
        return svg(drawn)


def _net(member: MemberGeometry, result: MeasurementResult, name: FlankName) -> tuple[Floats, Floats, Floats]:
    """Places from the toe and above the pitch cone [mm] and mean deviations [µm], shape (n, m), NaN where none is."""
    chosen = np.asarray(result.flanks) == name
    rho, delta, _ = spherical(result.pose.undo(result.points[chosen]))
    values = (rho - member.inner_cone_distance, rho * (delta - member.pitch_angle), result.deviation_um[chosen])
    face, profile = result.face_place[chosen], result.profile_place[chosen]
    x, y, error = (cell_means(value, face, profile) for value in values)
    return x, y, error


def pitch(result: MeasurementResult) -> bytes:
    """Single errors as bars and cumulative errors as a line, over the numbers of the teeth."""
    with figure(Frame(2.2, 1, 2, left=0.6)) as (drawn, axes):
        for ax, name in zip(axes[0], FLANKS, strict=True):
            ax.set_title(tr(FLANKS_SAID[name]))
            found = result.pitch.get(name)
            if found is None:
                absent(ax, tr("not measured"))
                continue
            ax.bar(found.tooth + 1, found.single_um, color="#b9c0c9", label=tr("single"))
            ax.plot(found.tooth + 1, found.cumulative_um, "o-", ms=2.5, color=SIDES[name], label=tr("cumulative"))
            ax.set_xlabel(tr("tooth"))
            ax.legend(loc="best", ncols=2)
        axes[0, 0].set_ylabel(tr("pitch error [µm]"))
        return svg(drawn)
