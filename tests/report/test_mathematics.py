"""Symbols and formulas of the program as the typesetter's mathematics."""

import pytest
import typst

from gearstudio.analysis.datasheet import data_sheet
from gearstudio.design import Design, all_field_specs
from gearstudio.equations import EQUATIONS
from gearstudio.report.mathematics import mathematics, prose
from gearstudio.report.method_chapters import decimal


@pytest.mark.parametrize(
    ("plain", "set_"),
    [
        ("R_e", "R_(e)"),
        ("h_fe", "h_(f e)"),
        ("δₐ₁", "δ_(a 1)"),
        ("z_mate", 'z_("mate")'),
        ("hₐ*", "h_(a)^*"),
        ("Rₘ²", "R_(m)^2"),
        ("ψ_t′(ρ)", "ψ'_(t) ( ρ )"),
        ("of the mate", '"of the mate"'),
        ("a/b", r"a \/ b"),
        ("√(a² + b)", "sqrt( a^2 + b )"),
    ],
)
def test_plain_text_becomes_mathematics(plain: str, set_: str) -> None:
    assert " ".join(mathematics(plain).split()) == set_


def test_every_symbol_and_formula_of_the_program_can_be_set() -> None:
    texts = [text for spec in all_field_specs().values() for text in (spec.symbol, spec.equation)]
    texts += [text for line in data_sheet(Design()).lines() for text in (line[0].symbol, line[0].formula)]
    lines = [f"$ {mathematics(text)} $" for text in texts if text]
    assert len(lines) > 100
    assert typst.compile("\n\n".join(lines).encode(), format="pdf").startswith(b"%PDF")


def test_sentences_keep_their_words_and_have_their_symbols_set() -> None:
    assert prose("divided by sin δ_b: an angle") == (
        ("text", "divided by sin "), ("mathematics", "δ_(b)"), ("text", ": an angle"),
    )  # fmt: skip
    for one in EQUATIONS:
        for sentence in (one.meaning, one.departure, one.evidence):
            words = [content for kind, content in prose(sentence) if kind == "text"]
            assert "_" not in "".join(words) and not set("ₐₑₘₙ₀₁₂") & set("".join(words))


@pytest.mark.parametrize(
    ("value", "text"), [(134.2, "134"), (0.000059912, "0.0000599"), (9.996, "10.0"), (0.0, "0.00")]
)
def test_three_digits_count(value: float, text: str) -> None:
    assert float(decimal(value)) == pytest.approx(value, rel=0.006)
    assert decimal(value) == text
