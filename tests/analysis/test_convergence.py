"""Convergence studies: of a made-up method of known order, and of the three."""

from __future__ import annotations

import json

import pytest

from gearstudio import cli
from gearstudio.analysis.convergence import (
    COUNTED,
    ConvergencePoint,
    convergence_point,
    convergence_study,
    studies_of,
)
from gearstudio.catalogue import METHOD_IDS
from gearstudio.design import Design
from gearstudio.errors import GeometryError, ModellingError
from tests.designs import GOLDEN


def made_up(count: int) -> ConvergencePoint:
    """A method of fourth order in its count that the kernel refuses below 5, and that ends at 0.01 µm."""
    if count < 5:
        raise ModellingError("profile_sweep", "skin", "gave up")
    error = max(1e4 / count**4, 0.01)
    return ConvergencePoint(count, count**2, 1e-3 * count, error, error / 3, error / 2)


def test_known_order_and_effort() -> None:
    told: list[float] = []
    study = convergence_study("profile_sweep", made_up, [40, 5, 3, 10, 20, 80], lambda stage, part: told.append(part))
    assert [point.count for point in study.points] == [5, 10, 20, 40, 80]
    assert list(study.failures) == [3] and "gave up" in study.failures[3]
    assert told == [k / 6 for k in range(6)]
    assert study.order("count") == pytest.approx(4) and study.order("poles") == pytest.approx(2)
    assert study.order("seconds") == pytest.approx(4)
    for tolerance, count in ((1.0, 10), (0.99, 20), (0.01, 40), (17, 5)):
        reached = study.reaching(tolerance)
        assert reached is not None and reached.count == count
    assert study.reaching(0.001) is None


def test_a_tolerance_is_reached_only_when_it_stays_so() -> None:
    errors = {6: 0.5, 8: 2.0, 10: 0.4, 12: 0.1}
    study = convergence_study(
        "point_cloud", lambda n: ConvergencePoint(n, n * n, 0.1, errors[n], 0.0, 0.0), list(errors)
    )
    reached = study.reaching(1.0)
    assert reached is not None and reached.count == 10


def test_an_order_takes_three_constructions() -> None:
    with pytest.raises(GeometryError, match="three"):
        convergence_study("profile_sweep", made_up, [10, 20]).order()
    study = studies_of([("point_cloud", made_up(20)), ("point_cloud", made_up(10)), ("profile_sweep", made_up(5))])
    assert [point.count for point in study["point_cloud"].points] == [10, 20] and len(study) == 2


@pytest.mark.kernel
@pytest.mark.parametrize("method", METHOD_IDS)
@pytest.mark.parametrize("name", [None, *list(GOLDEN)[:3]])
def test_methods_converge(method: str, name: str | None) -> None:
    design = Design() if name is None else GOLDEN[name][0]
    study = convergence_study(method, lambda n: convergence_point(design, "wheel", method, n), [4, 8, 16, 40])
    assert not study.failures
    counted = {"positions": "positions", "sections": "sections"}.get(COUNTED[method], "grid")
    for point in study.points:
        told = point.settings[counted]
        assert told == (point.count if counted != "grid" else [point.count, point.count])
        assert 0 < point.rms_um <= point.max_um and point.seconds > 0
    coarse, *_, fine = study.points
    assert fine.poles > coarse.poles and fine.max_um < 0.1 * coarse.max_um
    assert study.reaching(design.methods.tolerance_um) is not None
    assert study.order("count") > 3


@pytest.mark.kernel
def test_the_command_writes_the_study(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("gearstudio.analysis.convergence.convergence_study.__defaults__", ((5, 8, 12), None))
    assert cli.main(["compare", "preset:default", "--member", "wheel", "--convergence", "--json", "-"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert set(record["members"]["wheel"]) == set(METHOD_IDS) == set(record["convergence"]["wheel"])
    for study in record["convergence"]["wheel"].values():
        assert [point["count"] for point in study["points"]] == [5, 8, 12]
        assert {"poles", "seconds", "max_um", "mean_um", "rms_um", "settings"} <= study["points"][0].keys()
        assert study["reaching"]["max_um"] <= study["tolerance_um"] == 0.05
    assert cli.main(["compare", "preset:default", "--member", "wheel", "--convergence"]) == 0
    text = capsys.readouterr().out
    assert "convergence, wheel" in text and text.count("stays within 0.05 µm: with") == 3
