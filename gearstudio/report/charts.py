"""Figures of the report with lines: deviation along the flank, effort against error."""

from __future__ import annotations

import numpy as np

from gearstudio.catalogue import METHOD_INFOS, PAPER_MEANS_UM, VARIANTS
from gearstudio.report.content import Content
from gearstudio.report.language import FLANKS_SAID, tr
from gearstudio.report.style import COLORS, Frame, few_ticks, figure, svg
from gearstudio.theory.flank import FLANKS

_SERIES = 7
_LEAST_UM = 1e-5


def deviation_series(content: Content) -> bytes:
    """Deviation at 7 x 7 points of either flank, all methods and variants, the paper's means as lines."""
    with figure(Frame(2.35, 1, 2, foot=0.36, left=0.68)) as (drawn, axes):
        for ax, flank in zip(axes[0], FLANKS, strict=True):
            for method in METHOD_INFOS:
                for variant in VARIANTS:
                    result = content.results.get((content.member, method.id, variant))
                    if result is None:
                        continue
                    error = result.flanks[flank].deviation_um
                    rows, columns = (np.linspace(0, n - 1, _SERIES).round().astype(int) for n in error.shape)
                    series = np.maximum(np.abs(error[np.ix_(rows, columns)].T.ravel()), _LEAST_UM)
                    dash = "-" if variant == "optimised" else "--"
                    ax.plot(
                        np.arange(1, series.size + 1), series, dash, color=COLORS[method.id],
                        label=f"{tr(method.title)}, {tr(variant)}",
                    )  # fmt: skip
                ax.axhline(PAPER_MEANS_UM[method.id], color=COLORS[method.id], lw=0.6, ls=":")
            ax.set_yscale("log")
            ax.set_title(tr(FLANKS_SAID[flank]))
            ax.set_xlabel(tr("point of the 7 × 7 series, toe to heel"))
        few_ticks(axes[0, 0].yaxis, *axes[0, 0].get_ylim())
        axes[0, 0].set_ylabel(tr("deviation [µm]"))
        handles, labels = axes[0, 0].get_legend_handles_labels()
        if handles:
            drawn.legend(handles, labels, loc="lower center", ncols=3)
        return svg(drawn)


def convergence(content: Content) -> bytes:
    """Largest deviation against poles and against seconds, all methods, with the tolerance of the design."""
    titles = {method.id: tr(method.title) for method in METHOD_INFOS}
    efforts = {"poles": tr("poles"), "seconds": tr("seconds for both flanks")}
    with figure(Frame(2.5, 1, 2, own_x=True, left=0.68)) as (drawn, axes):
        for ax, (effort, label) in zip(axes[0], efforts.items(), strict=True):
            for study in content.studies:
                effort_of = [getattr(point, effort) for point in study.points]
                worst = [max(point.max_um, _LEAST_UM) for point in study.points]
                ax.plot(effort_of, worst, "o-", ms=2.5, color=COLORS[study.method], label=titles[study.method])
            ax.axhline(content.design.methods.tolerance_um, color="#30343a", lw=0.7, ls="--", label=tr("tolerance"))
            ax.set_xscale("log")
            ax.set_yscale("log")
            ax.set_xlabel(label)
            few_ticks(ax.xaxis, *ax.get_xlim())
        few_ticks(axes[0, 0].yaxis, *axes[0, 0].get_ylim())
        axes[0, 0].set_ylabel(tr("largest deviation [µm]"))
        axes[0, 0].legend()
        return svg(drawn)
