"""Second derivatives of conjugate flanks against differences of high order of the first, and against curvature."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

from gearstudio.design import Design
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.modified import flank_of
from tests.strategies import offset_designs
from tests.theory.hypoid.curvatures import curvatures

Floats = np.ndarray
HYPOID = [key for key, preset in PRESETS_BY_KEY.items() if preset.design.pair.offset]
TAKEN = {
    "lengthwise_crowning_um": 30.0,
    "profile_crowning_um": 12.0,
    "bias_um": -8.0,
    "spiral_angle_correction_um": 5.0,
}
U, V = np.linspace(0.1, 0.9, 5)[:, None], np.linspace(0.1, 0.9, 6)
EIGHTH = ((1, 4 / 5), (2, -1 / 5), (3, 4 / 105), (4, -1 / 280))
"""Steps and weights of central differences of eighth order."""


def pinion_flanks(design: Design) -> list[ConjugateFlank]:
    flanks = [flank_of(pair_geometry(design).pinion, name) for name in FLANKS]
    assert all(isinstance(flank, ConjugateFlank) for flank in flanks)
    return flanks  # type: ignore[return-value]


def relieved(design: Design) -> Design:
    return Design.model_validate({**design.model_dump(), "modifications": {"pinion": dict.fromkeys(FLANKS, TAKEN)}})


def difference(of: Callable[[float], Floats], step: float) -> Floats:
    return np.asarray(sum(weight * (of(k * step) - of(-k * step)) for k, weight in EIGHTH) / step)


def assert_derivatives(flank: ConjugateFlank, accuracy: float) -> None:
    psi, rho = flank.coordinates(U, V)
    size = flank.member.mean_cone_distance
    a, b, aa, ab, bb = flank.derivatives_at(psi, rho)
    h, k = 2e-3, 2e-3 * size
    wanted = (
        difference(lambda d: flank.at(psi + d, rho), h),
        difference(lambda d: flank.at(psi, rho + d), k),
        difference(lambda d: flank.derivatives_at(psi + d, rho)[0], h),
        difference(lambda d: flank.derivatives_at(psi + d, rho)[1], h),
        difference(lambda d: flank.derivatives_at(psi, rho + d)[1], k),
    )
    other = difference(lambda d: flank.derivatives_at(psi, rho + d)[0], k)
    scales = (size, 1.0, size, 1.0, 1 / size)
    for found, expected, scale in zip((a, b, aa, ab, bb), wanted, scales, strict=True):
        assert np.abs(found - expected).max() < accuracy * scale * max(1.0, np.abs(expected).max() / scale)
    assert np.abs(ab - other).max() < accuracy * max(1.0, np.abs(other).max())


@pytest.mark.parametrize("modify", [False, True])
@pytest.mark.parametrize("key", HYPOID)
def test_derivatives_of_presets(key: str, modify: bool) -> None:
    design = PRESETS_BY_KEY[key].design
    for flank in pinion_flanks(relieved(design) if modify else design):
        assert_derivatives(flank, 1e-8)


@settings(max_examples=8, deadline=None, suppress_health_check=list(HealthCheck))
@given(offset_designs())
def test_second_derivatives_give_the_curvature_in_closed_form(design: Design) -> None:
    for flank in pinion_flanks(design):
        psi, rho = flank.coordinates(U, V)
        a, b, aa, ab, bb = flank.derivatives_at(psi, rho)
        normal = flank.normals_at(psi, rho)
        first = [[np.sum(x * y, -1) for y in (a, b)] for x in (a, b)]
        second = [[-np.sum(x * normal, -1) for x in row] for row in ((aa, ab), (ab, bb))]
        square = first[0][0] * first[1][1] - first[0][1] ** 2
        gauss = (second[0][0] * second[1][1] - second[0][1] ** 2) / square
        mean = first[0][0] * second[1][1] - 2 * first[0][1] * second[0][1] + first[1][1] * second[0][0]
        high, low = curvatures(flank, psi, rho)
        scale = np.maximum(np.abs(high), np.abs(low))
        assert np.abs(mean / (2 * square) - (high + low) / 2).max() < 1e-9 * scale.max()
        assert np.abs(gauss - high * low).max() < 1e-9 * (scale**2).max()


@pytest.mark.parametrize("key", HYPOID)
def test_normals_of_modified_flanks_are_square_to_their_derivatives(key: str) -> None:
    for flank in pinion_flanks(relieved(PRESETS_BY_KEY[key].design)):
        psi, rho = flank.coordinates(U, V)
        normal = flank.normals_at(psi, rho)
        size = flank.member.mean_cone_distance
        for along, scale in (
            (difference(lambda d: flank.at(psi + d, rho), 1e-3), size),  # noqa: B023
            (difference(lambda d: flank.at(psi, rho + d), 1e-3 * size), 1.0),  # noqa: B023
        ):
            assert np.abs(np.sum(normal * along, axis=-1)).max() < 1e-10 * scale
