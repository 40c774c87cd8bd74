"""Deviations drawn many times as large: by how much, which way, and what is still told truly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearstudio.theory.modified import flank_of
from tests.ui.made_up import member_of, result_of
from ui.layers import Layer
from ui.picking import describe, first_hit
from ui.scene import result_layers
from ui.views.exaggeration import SHARE, displaced, factor_for, stretched, suitable
from ui.views.factors import AUTOMATIC, OFF, factor_text

pytestmark = pytest.mark.ui


def wave(u, v):
    return 0.1 * np.sin(4 * u) * np.cos(3 * v)


def surface(layers: tuple[Layer, ...], part: str) -> Layer:
    return next(x for x in layers if x.key == f"deviation/{part}")


@pytest.mark.parametrize("design", ["default", "tiny", "huge"])
@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_the_drawn_flank_is_off_theory_by_the_factor(design: str, member: str) -> None:
    geometry = member_of(design, member)
    result = result_of(geometry, wave)
    layers = result_layers(result)
    for name, flank in result.flanks.items():
        factor = factor_for(AUTOMATIC, [result])
        drawn = surface(displaced(layers, result, geometry, factor), name)
        off = 1e3 * flank_of(geometry, name).deviation(drawn.points)
        inner = np.zeros(flank.deviation_um.shape, dtype=bool)
        inner[2:-2, 2:-2] = True
        wanted = factor * flank.deviation_um.ravel()
        assert np.abs(off - wanted)[inner.ravel()].max() < 0.06 * np.abs(wanted).max()
        assert np.allclose(drawn.true_points, surface(layers, name).points)
        assert np.array_equal(drawn.scalars, surface(layers, name).scalars)


def test_off_changes_nothing_and_borders_go_along() -> None:
    geometry = member_of("default")
    result = result_of(geometry, wave)
    layers = result_layers(result)
    assert displaced(layers, result, geometry, OFF) == layers
    moved = displaced(layers, result, geometry, 200)
    for name in result.flanks:
        edge = next(x for x in moved if x.key == f"deviation/{name} edge")
        drawn = {tuple(point) for point in surface(moved, name).points}
        assert {tuple(point) for point in edge.points} <= drawn
    others = [x for x in layers if x.layer_id not in ("deviation", "cad_flank")]
    assert [x for x in moved if x.layer_id not in ("deviation", "cad_flank")] == others


def test_the_point_under_the_pointer_is_told_where_it_truly_is() -> None:
    geometry = member_of("default")
    result = result_of(geometry, lambda u, v: 20.0 + 0 * u)
    layers = result_layers(result)
    flank = flank_of(geometry, "concave")
    normal, target = flank.normals(0.5, 0.5), flank.points(0.5, 0.5)
    moved = surface(displaced(layers, result, geometry, 50), "concave")
    hit = first_hit((moved,), target + 9 * normal, -normal)
    plain = first_hit((surface(layers, "concave"),), target + 9 * normal, -normal)
    assert hit is not None and plain is not None
    assert (hit.point - plain.point) @ normal == pytest.approx(49 * 0.020, rel=0.02)
    told = describe(hit, "x")
    assert np.linalg.norm(np.array(told.xyz) - plain.point) < 0.03
    assert told.deviation_um == pytest.approx(20.0)


@pytest.mark.parametrize("size", [0.2, 9.0, 300.0])
@pytest.mark.parametrize("largest_um", [1e-4, 0.5, 40.0])
def test_an_automatic_factor_is_round_and_makes_a_fair_share(size: float, largest_um: float) -> None:
    factor = suitable(size, largest_um)
    assert str(factor).rstrip("0") in ("1", "2", "5")
    share = factor * largest_um * 1e-3 / size
    assert factor == OFF or 0.39 * SHARE < share <= SHARE * 1.000001 or factor == 10**8


def test_words_and_layers_that_know_their_offset() -> None:
    assert factor_text(10_000) == "×10\N{NARROW NO-BREAK SPACE}000"
    geometry = member_of("default")
    one = result_layers(result_of(geometry, wave))[0]
    known = replace(one, offset=np.ones_like(one.points))
    plain, moved = stretched((one, known), 11)
    assert plain is one and np.allclose(moved.points, one.points + 10) and moved.true_points is one.points


@pytest.mark.parametrize(("wanted", "read"), [("auto", 0), ("1", 1), ("500", 500)])
def test_the_command_takes_a_factor(wanted: str, read: int) -> None:
    from gearstudio.cli.parser import make_parser

    args = make_parser().parse_args(["screenshot", "preset:default", "--out", "a.png", "--exaggerate", wanted])
    assert args.exaggerate == read


@pytest.mark.parametrize("wrong", ["0", "-3", "many", "1.5"])
def test_the_command_refuses_what_is_no_factor(wrong: str, capsys) -> None:
    from gearstudio.cli.parser import make_parser

    with pytest.raises(SystemExit):
        make_parser().parse_args(["screenshot", "preset:default", "--out", "a.png", f"--exaggerate={wrong}"])
    assert "is no factor" in capsys.readouterr().err


def test_titles_leave_out_what_matters_least(qtbot) -> None:
    from PySide6.QtGui import QFont, QFontMetricsF

    from ui.view_overlay import fitted

    metrics = QFontMetricsF(QFont())
    words = "max 46.7 µm · deviation ×100 · mean 7.95 µm"
    assert fitted(words, metrics, 1e4) == (words,)
    three = metrics.horizontalAdvance("max 46.7 µm · ×100 · mean 7.95 µm") + 1
    assert fitted(words, metrics, three) == ("max 46.7 µm · ×100 · mean 7.95 µm",)
    two = metrics.horizontalAdvance("max 46.7 µm · ×100") + 1
    assert fitted(words, metrics, two) == ("max 46.7 µm · ×100",)
    one = metrics.horizontalAdvance("max 46.7 µm") + 1
    assert fitted(words, metrics, one) == ("max 46.7 µm",)
    assert fitted(words, metrics, one / 2)[0].endswith("…")
    lines = fitted("Rotating line · optimised", metrics, metrics.horizontalAdvance("Rotating line") + 2, breaks=True)
    assert lines == ("Rotating line", "optimised")
