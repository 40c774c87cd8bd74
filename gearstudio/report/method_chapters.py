"""Chapters about the three methods: comparison, maps, topography, convergence."""

from __future__ import annotations

from gearstudio.analysis.convergence import COUNTED
from gearstudio.catalogue import MEMBERS, METHOD_INFOS, PAPER_MEANS_UM, VARIANTS, MemberName, Variant
from gearstudio.report import charts, maps
from gearstudio.report.blocks import Block, Table, Text, rows
from gearstudio.report.content import Content
from gearstudio.report.language import FLANKS_SAID, MEMBERS_SAID, inline, number, told, tr
from gearstudio.report.store import Store
from gearstudio.theory.flank import FLANKS

_DIGITS = 3


def comparison(content: Content, store: Store) -> list[Block]:
    """All methods and variants of both members in a table, and the deviation along the flank."""
    head = (
        tr("Method"), tr("Variant"), tr("Largest"), tr("Mean"), tr("RMS"), tr("Edges"), tr("Poles"), tr("Degree"),
        tr("Time [ms]"),
    )  # fmt: skip
    made: list[tuple[str, ...]] = []
    reasons: list[Block] = []
    for member in MEMBERS:
        made.append((tr(MEMBERS_SAID[member]),))
        for method in METHOD_INFOS:
            for variant in VARIANTS:
                key, title = (member, method.id, variant), tr(method.title)
                if key in content.failures:
                    made.append((title, tr(variant), tr("not built"), "", "", "", "", "", ""))
                    where = f"{tr(MEMBERS_SAID[member])}, {title}, {tr(variant)}"
                    reasons.append(Text(f"{where}: {told(content.failures[key])}"))
                elif key in content.results:
                    made.append((title, tr(variant), *_figures(content, key)))
    means = " / ".join(number(mean, "g") for mean in PAPER_MEANS_UM.values())
    intro = Text(
        tr(
            "Deviation of the CAD surface from the exact flank in µm, normal to it, over both flanks on a grid of "
            "49 × 49 points that includes the edges. The paper states means of {means} µm for its own gear, whose data "
            "it does not print.",
            means=means,
        )
    )
    caption = tr(
        "{member}: deviation at 7 × 7 points of each flank; dotted: the means that the paper states.",
        member=tr(MEMBERS_SAID[content.member]),
    )
    series = store.add("series.svg", charts.deviation_series(content), caption)
    return [intro, Table(head, rows(made), "llddddccd"), *reasons, series]


def _figures(content: Content, key: tuple[MemberName, str, Variant]) -> tuple[str, ...]:
    r = content.results[key]
    edge = max(one.edge_um for one in r.flanks.values())
    sizes = (r.statistics.max_um, r.statistics.mean_um, r.statistics.rms_um, edge)
    poles, degree = (f"{a} × {b}" for a, b in (r.poles, r.degree))
    return (*(decimal(x) for x in sizes), poles, degree, f"{r.seconds * 1e3:.0f}")


def decimal(value: float) -> str:
    """Three digits that count, without an exponent."""
    rounded = f"{value:.{_DIGITS - 1}e}"
    places = max(0, _DIGITS - 1 - int(rounded.partition("e")[2]))
    return number(float(rounded), f".{min(places, 9)}f")


def deviation(content: Content, store: Store) -> list[Block]:
    """Where each method deviates."""
    return [
        store.add(
            f"deviation-{flank}.svg", maps.deviation_maps(content, flank),
            tr(
                "{flank}, {member}: signed deviation, plus is metal added; each map has a scale of its own.",
                flank=tr(FLANKS_SAID[flank]), member=inline(MEMBERS_SAID[content.member]),
            ),
        )
        for flank in FLANKS
    ]  # fmt: skip


def curvature(content: Content, store: Store) -> list[Block]:
    """Gaussian curvature."""
    caption = tr(
        "{member}: Gaussian curvature, theory and the optimised surfaces on one scale.",
        member=tr(MEMBERS_SAID[content.member]),
    )
    return [store.add("curvature.svg", maps.curvature_maps(content), caption)]


def topography(content: Content, store: Store) -> list[Block]:
    """The measuring grid of each method."""
    return [
        store.add(
            f"topography-{method.id}.svg", maps.topography(content, method.id),
            tr(
                "{member}, {method}: 5 × 9 points, plus is upwards.",
                member=tr(MEMBERS_SAID[content.member]), method=inline(method.title),
            ),
        )
        for method in METHOD_INFOS
    ]  # fmt: skip


def convergence(content: Content, store: Store) -> list[Block]:
    """What precision costs."""
    titles = {method.id: tr(method.title) for method in METHOD_INFOS}
    tolerance = content.design.methods.tolerance_um
    made = []
    for study in content.studies:
        reached = study.reaching(tolerance)
        found = (tr("not reached"), "", "", "")
        if reached is not None:
            count = f"{reached.count} {tr(COUNTED[study.method])}"
            found = (count, str(reached.poles), f"{reached.seconds * 1e3:.0f}", decimal(reached.max_um))
        made.append((titles[study.method], *found))
    head = (
        tr("Method"), tr("Reaches {tolerance} µm with", tolerance=number(tolerance, "g")), tr("Poles"),
        tr("Time [ms]"), tr("Largest [µm]"),
    )  # fmt: skip
    caption = tr(
        "{member}: largest deviation over both flanks against the effort.", member=tr(MEMBERS_SAID[content.member])
    )
    return [
        Text(tr("Every method built with more and more positions, sections or points, and nothing else refined.")),
        Table(head, rows(made), "llddd"),
        store.add("convergence.svg", charts.convergence(content), caption),
    ]
