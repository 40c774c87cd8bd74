"""Numbers as the window shows and reads them."""

from __future__ import annotations

import pytest

from ui import formatting as words


@pytest.mark.parametrize(
    ("text", "value"),
    [("17", 17), (" 17 ", 17), ("+3", 3), ("-4", -4), ("−4", -4), ("1.5", 1.5), ("1,5", 1.5), (".5", 0.5), ("2.", 2.0),
     ("1e-3", 0.001), ("1E3", 1000.0), ("017", 17)],
)  # fmt: skip
def test_numbers_are_understood(text: str, value: float) -> None:
    assert words.parse_number(text) == value
    assert type(words.parse_number(text)) is type(value)


@pytest.mark.parametrize(
    "text",
    ["", " ", "abc", "1,234.5", "1 000", "1_000", "nan", "inf", "1e999", "0x10", "١٧", "--1", "1e", "9" * 5000, "\0"],
)
def test_what_is_no_number_stays_as_typed(text: str) -> None:
    assert words.parse_number(text) == text


@pytest.mark.parametrize("value", [0.1, 1e-7, 12345.678, 17, 80.0, 0.30, 1e15])
def test_a_number_reads_back_as_it_was_shown(value: float) -> None:
    assert words.parse_number(words.number_text(value)) == value


@pytest.mark.parametrize(
    ("value", "text"),
    [(54.63, "54.6 µm"), (1234.5, "1230 µm"), (0.5, "0.500 µm"), (0.0312, "31.2 nm"), (-0.0312, "−31.2 nm"),
     (5.4e-5, "0.054 nm"), (1e-9, "< 0.001 nm"), (0.0, "0 nm"), (0.09999, "100 nm"), (float("nan"), "– nm")],
)  # fmt: skip
def test_deviations_are_shown_with_digits_that_matter(value: float, text: str) -> None:
    assert words.micrometres(value) == text


def test_extremes_share_a_unit() -> None:
    assert words.span(-46.7, 42.71) == "−46.7 … +42.7 µm"
    assert words.span(-4e-5, 1e-5) == "−0.040 … +0.010 nm"


def test_small_words() -> None:
    assert words.seconds(0.0123) == "12 ms" and words.seconds(2.345) == "2.35 s"
    assert words.fixed(-1e-9, 3) == "0.000" and words.fixed(-1.5, 1) == "−1.5"
    assert words.subscripts("R_m < δ_f") == "R<sub>m</sub> &lt; δ<sub>f</sub>"
    assert words.settings_text({"grid": [12, 14], "cut_off": True, "step": 0.1234567}) == (
        "grid 12 × 14, cut off yes, step 0.1235"
    )
    assert words.choice_title("something_new") == "Something new"
