"""Build a variant of a method on both flanks of a member and measure it."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial

from gearstudio.analysis.deviation import deviation_map, statistics
from gearstudio.catalogue import Variant
from gearstudio.design import Design
from gearstudio.errors import GeometryError, ModellingError
from gearstudio.methods import Construction, Target, method
from gearstudio.results import FlankResult, VariantResult
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS, Flank
from gearstudio.theory.modified import flank_of

DEFAULT_SAMPLES = (61, 61)


def build_variant(
    design: Design, member: str, method_id: str, variant: Variant, samples: tuple[int, int] = DEFAULT_SAMPLES
) -> VariantResult:
    """Model both flanks of one tooth and compare them with theory.

    Parameters
    ----------
    design : Design
    member : {"pinion", "wheel"}
    method_id, variant : str
        Of interface.md.
    samples : (int, int)
        Points along and across each flank at which the deviation is taken.

    Raises
    ------
    ModellingError
        The kernel could not make a flank, or the tolerance was not reached.
    """
    return _compared(
        design,
        member,
        method_id,
        variant,
        samples,
        lambda flank, target: method(method_id).build(flank, variant, target),
    )


def build_with_count(
    design: Design, member: str, method_id: str, count: int, samples: tuple[int, int] = DEFAULT_SAMPLES
) -> VariantResult:
    """As `build_variant`, optimised, with a given effort instead of a tolerance that is met (`Method.build_with`)."""
    return _compared(
        design, member, method_id, "optimised", samples,
        lambda flank, target: method(method_id).build_with(flank, count, target),
    )  # fmt: skip


def _compared(
    design: Design,
    member: str,
    method_id: str,
    variant: Variant,
    samples: tuple[int, int],
    build: Callable[[Flank, Target], Construction],
) -> VariantResult:
    geometry = pair_geometry(design).member(member)
    target = Target.for_cone_distance(
        design.methods.tolerance_um, geometry.outer_cone_distance, design.methods.point_cloud_degree
    )
    started = time.perf_counter()
    flanks = [flank_of(geometry, name) for name in FLANKS]
    built = [(flank, _built(flank, method_id, variant, partial(build, flank, target))) for flank in flanks]
    seconds = time.perf_counter() - started
    results: dict[str, FlankResult] = {
        flank.name: _measure(flank, construction, samples) for flank, construction in built
    }
    heaviest = max((c for _, c in built), key=lambda c: c.surface.poles.size)
    return VariantResult(
        member=member,
        method=method_id,
        variant=variant,
        flanks=results,
        statistics=statistics(result.deviation_um for result in results.values()),
        poles=heaviest.surface.poles.shape[:2],
        degree=(heaviest.surface.degree_u, heaviest.surface.degree_v),
        seconds=seconds,
        settings=heaviest.settings,
    )


def _built(flank: Flank, method_id: str, words: str, build: Callable[[], Construction]) -> Construction:
    try:
        return build()
    except GeometryError as error:
        raise ModellingError(method_id, f"{words} {flank.name} flank", str(error)) from error


def _measure(flank: Flank, construction: Construction, samples: tuple[int, int]) -> FlankResult:
    points, deviation_um = deviation_map(flank, construction.surface, samples)
    return FlankResult(
        flank=flank.name,
        surface=construction.surface,
        points=points,
        deviation_um=deviation_um,
        statistics=statistics([deviation_um]),
        edge_um=flank.edge_deviation(points) * 1e3,
        curves=construction.curves,
    )
