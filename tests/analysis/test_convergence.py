"""Convergence studies: of a made-up method of known order, and of the three."""

from __future__ import annotations

import numpy as np
import pytest

from gearstudio.analysis.comparison import build_variant
from gearstudio.analysis.convergence import convergence_study
from gearstudio.catalogue import METHOD_IDS
from gearstudio.design import Design, with_field
from gearstudio.errors import GeometryError, ModellingError
from gearstudio.results import Statistics, VariantResult


def made_up(tolerance_um: float) -> VariantResult:
    """A method of fourth order in its poles that gives up below 0.01 µm."""
    if tolerance_um < 0.01:
        raise ModellingError("profile_sweep", "refinement", "gave up")
    sections = int(np.ceil((1e4 / tolerance_um) ** 0.25))
    error = 1e4 / sections**4
    statistics = Statistics(error, error / 2, error / 2, -error, error)
    return VariantResult(
        "wheel", "profile_sweep", "optimised", {}, statistics, (1, sections), (3, 3), 0.1, {"sections": sections}
    )


def test_known_order_and_effort() -> None:
    study = convergence_study("profile_sweep", made_up, [1.0, 100.0, 0.1, 10.0, 0.02, 0.001])
    assert study.order == pytest.approx(4)
    assert study.effort_name == "sections" and "gave up" in study.stopped
    assert [point.tolerance_um for point in study.points] == [100.0, 10.0, 1.0, 0.1, 0.02]
    reached = study.reaching(1.0)
    assert reached is not None and reached.effort == 10
    assert study.reaching(1e-6) is None


def test_equal_efforts_are_told_once() -> None:
    told: list[float] = []
    study = convergence_study("profile_sweep", made_up, [1.0, 1.0, 0.999999], lambda stage, done: told.append(done))
    assert len(study.points) == 2 and told == [0, 1 / 3, 2 / 3]
    with pytest.raises(GeometryError, match="two constructions"):
        _ = convergence_study("profile_sweep", made_up, [1.0]).order


@pytest.mark.kernel
@pytest.mark.parametrize("method", METHOD_IDS)
def test_methods_converge(method: str) -> None:
    def build(tolerance_um: float) -> VariantResult:
        design = with_field(Design(), "methods.tolerance_um", tolerance_um)
        return build_variant(design, "wheel", method, "optimised", (31, 31))

    study = convergence_study(method, build, [50.0, 2.0, 0.1, 0.005])
    assert study.stopped == ""
    assert [p.max_um for p in study.points] == sorted((p.max_um for p in study.points), reverse=True)
    assert all(point.max_um <= point.tolerance_um for point in study.points)
    assert study.points[-1].effort > 0 and study.points[-1].seconds > 0
