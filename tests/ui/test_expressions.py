"""Sums typed into fields: values, units, and nothing that could do harm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress
from time import monotonic

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearstudio.design import all_field_specs
from ui import units
from ui.expressions import ExpressionError, evaluate
from ui.fields import read_number

MODULE = all_field_specs()["pair.outer_module"]
TEETH = all_field_specs()["pair.wheel_teeth"]


@pytest.fixture(autouse=True)
def _millimetres() -> Iterator[None]:
    units.use(units.Display())
    yield
    units.use(units.Display())


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("25.4*3", "mm", 76.2),
        ("25,4*3", "mm", 76.2),
        ("1/2in + 1", "mm", 13.7),
        ('1"', "mm", 25.4),
        ("250µm", "mm", 0.25),
        ("(1+2)in", "mm", 76.2),
        ("hypot(3,4)", "mm", 5.0),
        ("hypot(3,5;4)", "mm", math.hypot(3.5, 4)),
        ("2^3**2", "", 512.0),
        ("tan(20,5deg)", "", math.tan(math.radians(20.5))),
        ("atan2(17,40)", "°", math.degrees(math.atan2(17, 40))),
        ("20° + 1", "°", 21.0),
        ("0.5rad", "°", math.degrees(0.5)),
        ("\N{MINUS SIGN}2·3", "", -6.0),
    ],
)
def test_a_sum_has_the_value_of_the_closed_form(text: str, unit: str, value: float) -> None:
    assert evaluate(text, unit) == pytest.approx(value, rel=1e-11)


@pytest.mark.parametrize(
    "text",
    ["1/0", "9**9**9", "9**9**9**9", "(-1)**0.5", "sqrt(-1)", "tan(", "x+1", "3deg", "5mm*2mm", "2(3)", "0x1F", "1_0",
     "1j", "1+" * 200 + "1", "().__class__", "[1][0]", "'a'*9", "(lambda: 1)()", "__import__('os')", "1 if 1 else 2",
     "abs(x=1)", "1e400+1"],
)  # fmt: skip
def test_what_is_no_sum_says_why_and_does_nothing(text: str) -> None:
    with pytest.raises(ExpressionError) as raised:
        evaluate(text, "mm")
    assert len(str(raised.value)) > 10


@given(st.text(alphabet="0123456789.,;()+-*/^ einmdgrsqt_'\"°[]", max_size=40))
def test_any_text_has_a_finite_value_or_a_reason_at_once(text: str) -> None:
    start = monotonic()
    with suppress(ExpressionError):
        assert math.isfinite(evaluate(text, "°"))
    assert monotonic() - start < 1.0


@given(st.floats(-1e4, 1e4), st.floats(0.01, 1e4))
def test_sums_agree_with_python(one: float, other: float) -> None:
    assert evaluate(f"({one!r}) - {other!r}*2", "") == pytest.approx(one - 2 * other, rel=1e-12, abs=1e-12)


@given(st.floats(1e-3, 1e4).map(lambda value: float(f"{value:.9g}")))
def test_inches_come_back_as_the_same_millimetres(value: float) -> None:
    units.use(units.Display("in"))
    assert units.from_shown(units.to_shown(value, "mm"), "mm") == pytest.approx(value, rel=1e-11)
    assert units.to_shown(value, "°") == value
    assert evaluate(f"{value!r}*1", "mm") == pytest.approx(25.4 * value, rel=1e-11)
    assert evaluate(f"{value!r}mm", "mm") == pytest.approx(value, rel=1e-11)
    units.use(units.Display())


def test_decimals_follow_the_choice_and_inches_have_two_more() -> None:
    assert units.with_unit(12.5, "mm") == "12.500 mm"
    units.use(units.Display("in"))
    assert units.with_unit(12.7, "mm") == "0.50000 in"
    units.use(units.Display("mm", 1))
    assert units.value_text(12.57, "mm", 4) == "12.6" and units.value_text(0.1234, "", 4) == "0.1234"


def test_too_large_is_told_from_what_has_no_value() -> None:
    for text, reason in (("9**9**9", "finite"), ("exp(1000)", "finite"), ("sqrt(-1)", "arguments"), ("1/0", "zero")):
        with pytest.raises(ExpressionError, match=reason):
            evaluate(text, "mm")


def test_wide_digits_of_chinese_input_count() -> None:
    assert read_number("３．２５", MODULE) == (3.25, "") and read_number("３，２５", MODULE) == (3.25, "")
    assert read_number("（１＋２）＊２", MODULE) == (6.0, "")


def test_a_whole_number_is_one_however_it_is_written() -> None:
    for text in ("17", "17.0", "17,", "1.7e1", "34/2"):
        assert read_number(text, TEETH) == (17, "") and isinstance(read_number(text, TEETH)[0], int), text
    assert read_number("1e300", TEETH) == (1e300, "") and read_number("17.5", TEETH) == (17.5, "")


def test_a_field_reads_numbers_sums_and_nonsense() -> None:
    assert read_number("20+21", TEETH) == (41, "")
    assert isinstance(read_number("20+21", TEETH)[0], int)
    assert read_number("3,25", MODULE) == (3.25, "")
    assert read_number("abc", MODULE) == ("abc", "")
    value, problem = read_number("4/0", MODULE)
    assert value == "4/0" and "zero" in problem
    units.use(units.Display("in"))
    assert read_number("0.25", MODULE) == (6.35, "") and read_number("4mm", MODULE) == (4.0, "")
