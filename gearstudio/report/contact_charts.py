"""Figures of the report for tooth contact: pattern, ease-off, transmission error."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearstudio.analysis.contact_result import ContactResult, FlankPattern
from gearstudio.report.content import Content
from gearstudio.report.language import DIRECTIONS_SAID, MEMBERS_SAID, inline, number, tr
from gearstudio.report.maps import name_axes
from gearstudio.report.style import DIVERGING, PATTERN, SIDES, Frame, figure, length_unit, rounded_up, scale, svg

_LEAST_ARCSEC = 1e-3
_LEAST_UM = 1e-3


def patterns(content: Content, contact: ContactResult) -> bytes:
    """Contact pattern on both members, drive and coast: where the gap stays within the marking thickness."""
    with figure(Frame(2.8, 2, 2, "each", own_x=True, own_y=True)) as (drawn, axes):
        for row, side in zip(axes, (contact.drive, contact.coast), strict=True):
            for ax, pattern in zip(row, (side.pinion, side.wheel), strict=True):
                words = (inline(MEMBERS_SAID[pattern.member]), tr(pattern.flank))
                ax.set_title(f"{tr(DIRECTIONS_SAID[side.direction])}: {', '.join(words)}")
                _pattern(drawn, ax, content, pattern, contact.thickness_um)
        for ax in axes[0]:
            ax.tick_params(labelbottom=False)
        name_axes(axes)
        return svg(drawn)


def transmission_error(contact: ContactResult) -> bytes:
    """Transmission error over three pitches."""
    with figure(Frame(2.0, left=0.68)) as (drawn, axes):
        ax = axes[0, 0]
        for side in (contact.drive, contact.coast):
            label = tr(
                "{direction}, {size}″ peak to peak",
                direction=tr(DIRECTIONS_SAID[side.direction]), size=arcsec(side.peak_to_peak_arcsec),
            )  # fmt: skip
            ax.plot(side.turn_deg, side.error_arcsec, color=SIDES[side.direction], label=label)
        low, high = ax.get_ylim()
        if high - low < _LEAST_ARCSEC:
            ax.set_ylim(-0.5, 0.5)
        ax.set_ylim(ax.get_ylim()[0], ax.get_ylim()[1] + 0.22 * float(np.ptp(ax.get_ylim())))
        ax.set_xlabel(tr("turn of the pinion [°]"))
        ax.set_ylabel(tr("lag of the wheel [″]"))
        ax.legend(loc="upper right", ncols=2)
        return svg(drawn)


def arcsec(value: float) -> str:
    """A size of the transmission error [arcsec]; what is lost in rounding is not shown as figures."""
    return number(value, ".3g") if value >= _LEAST_ARCSEC else f"< {number(_LEAST_ARCSEC, 'g')}"


def ease_off_maps(content: Content, contact: ContactResult) -> bytes:
    """Ease-off over the pinion's flanks, with the lines of contact."""
    with figure(Frame(1.9, 1, 2, "each")) as (drawn, axes):
        for ax, side in zip(axes[0], (contact.drive, contact.coast), strict=True):
            x, y = _flat(content, side.pinion)
            height = np.asarray(side.ease_off_um)
            limit = rounded_up(max(float(np.nanmax(np.abs(height))), _LEAST_UM))
            unit, factor = length_unit(limit)
            end = limit * factor
            shown = ax.pcolormesh(
                x, y, height * factor, cmap=DIVERGING, vmin=-end, vmax=end, shading="gouraud", rasterized=True
            )
            ax.contour(x, y, np.asarray(side.roll_deg), 9, colors="#30343a", linewidths=0.4)
            direction = tr(DIRECTIONS_SAID[side.direction])
            ax.set_title(tr("{direction}: ease-off and lines of contact", direction=direction))
            ax.grid(False)
            scale(drawn, ax, shown, unit, (-end, -end / 2, 0.0, end / 2, end))
        name_axes(axes)
        return svg(drawn)


def _pattern(drawn: Any, ax: Any, content: Content, pattern: FlankPattern, thickness_um: float) -> None:
    x, y = _flat(content, pattern)
    gap = np.where(np.isfinite(pattern.gap_um), np.maximum(pattern.gap_um, 0.0), 10 * thickness_um)
    shown = ax.contourf(x, y, gap, np.linspace(0.0, thickness_um, 9), cmap=PATTERN)
    ax.plot(np.r_[x[0], x[:, -1], x[-1, ::-1], x[::-1, 0]], np.r_[y[0], y[:, -1], y[-1, ::-1], y[::-1, 0]], "k", lw=0.6)
    scale(drawn, ax, shown, tr("gap µm"), (0.0, float(f"{thickness_um / 2:.3g}"), float(f"{thickness_um:.3g}")))
    ax.grid(False)


def _flat(content: Content, pattern: FlankPattern) -> tuple[Any, Any]:
    member = content.pair.member(pattern.member)
    delta = np.radians(pattern.delta_deg)
    return pattern.rho - member.inner_cone_distance, pattern.rho * (delta - member.pitch_angle)
