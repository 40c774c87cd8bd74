"""Chapters about the three methods: comparison, maps, topography, convergence."""

from __future__ import annotations

from gearstudio.analysis.convergence import COUNTED
from gearstudio.catalogue import MEMBERS, METHOD_INFOS, PAPER_MEANS_UM, VARIANTS, MemberName, Variant
from gearstudio.report import charts, maps
from gearstudio.report.blocks import Block, Table, Text, rows
from gearstudio.report.content import Content
from gearstudio.report.store import Store
from gearstudio.theory.flank import FLANKS

_MEANS = " / ".join(f"{mean:g}" for mean in PAPER_MEANS_UM.values())
_PUBLISHED = f"The paper states means of {_MEANS} µm for its own gear, whose data it does not print."
_DIGITS = 3


def comparison(content: Content, store: Store) -> list[Block]:
    """All methods and variants of both members in a table, and the deviation along the flank."""
    head = ("Method", "Variant", "Largest", "Mean", "RMS", "Edges", "Poles", "Degree", "Time [ms]")
    made: list[tuple[str, ...]] = []
    reasons: list[Block] = []
    for member in MEMBERS:
        made.append((member.capitalize(),))
        for method in METHOD_INFOS:
            for variant in VARIANTS:
                key = (member, method.id, variant)
                if key in content.failures:
                    made.append((method.title, variant, "not built", "", "", "", "", "", ""))
                    reasons.append(Text(f"{member.capitalize()}, {method.title}, {variant}: {content.failures[key]}"))
                elif key in content.results:
                    made.append((method.title, variant, *_figures(content, key)))
    intro = Text(
        "Deviation of the CAD surface from the exact flank in µm, normal to it, over both flanks on a grid of "
        f"49 × 49 points that includes the edges. {_PUBLISHED}"
    )
    series = store.add("series.svg", charts.deviation_series(content),
                       f"Deviation of the {content.member} at 7 × 7 points of each flank; dotted: the means that the "
                       "paper states.")  # fmt: skip
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
    return f"{float(rounded):.{min(places, 9)}f}"


def deviation(content: Content, store: Store) -> list[Block]:
    """Where each method deviates."""
    caption = "{0} flank of the {1}: signed deviation, plus is metal added; each map has a scale of its own."
    return [
        store.add(f"deviation-{f}.svg", maps.deviation_maps(content, f), caption.format(f.capitalize(), content.member))
        for f in FLANKS
    ]


def curvature(content: Content, store: Store) -> list[Block]:
    """Gaussian curvature."""
    caption = f"Gaussian curvature of the {content.member}: theory and the optimised surfaces, on one scale."
    return [store.add("curvature.svg", maps.curvature_maps(content), caption)]


def topography(content: Content, store: Store) -> list[Block]:
    """The measuring grid of each method."""
    made: list[Block] = []
    for method in METHOD_INFOS:
        caption = f"{content.member.capitalize()}, {method.title.lower()}: 5 × 9 points, plus is upwards."
        made.append(store.add(f"topography-{method.id}.svg", maps.topography(content, method.id), caption))
    return made


def convergence(content: Content, store: Store) -> list[Block]:
    """What precision costs."""
    titles = {method.id: method.title for method in METHOD_INFOS}
    tolerance = content.design.methods.tolerance_um
    made = []
    for study in content.studies:
        reached = study.reaching(tolerance)
        found = ("not reached", "", "", "")
        if reached is not None:
            count = f"{reached.count} {COUNTED[study.method]}"
            found = (count, str(reached.poles), f"{reached.seconds * 1e3:.0f}", decimal(reached.max_um))
        made.append((titles[study.method], *found))
    head = ("Method", f"Reaches {tolerance:g} µm with", "Poles", "Time [ms]", "Largest [µm]")
    caption = f"{content.member.capitalize()}: largest deviation over both flanks against the effort."
    return [
        Text("Every method built with more and more positions, sections or points, and nothing else refined."),
        Table(head, rows(made), "llddd"),
        store.add("convergence.svg", charts.convergence(content), caption),
    ]
