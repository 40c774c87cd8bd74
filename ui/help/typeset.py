"""Equations as drawings, set in the colours of the theme."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from ui.formatting import MEMBER_TITLES
from ui.language import decimal
from ui.theme import Tokens
from ui.units import factor, to_shown
from ui.words import noted, tr

if TYPE_CHECKING:
    from gearstudio.equations import Equation, Given, Numbers

PARTS = (noted("offset axes"), noted("micro-geometry"))
"""Parts of the theory without a number."""


_NOT_FOR = {
    "no offset": noted("Does not hold for this pair, whose axes have an offset."),
    "own depth": noted("Does not hold for this pair, which has an offset or a depth after ISO 23509."),
    "standard depth": noted("Does not hold for this pair, which has no offset and depths from the module."),
    "offset": noted("Does not hold for this pair, which has no offset."),
}
_FIT = """#let fit(line, lines) = layout(size => {
  let wide = measure(line).width
  let shown = if wide > size.width { lines } else { line }
  let share = calc.min(1, size.width / measure(shown).width)
  align(center, scale(share * 100%, reflow: true, box(shown)))
})"""
"""Sets a formula on one line, else on several, else smaller."""


def drawing(
    equation: Equation, numbers: dict[str, Numbers], colors: Tokens, width_pt: float, *, applies: bool = True
) -> bytes:
    """An equation with its departure and its numbers as SVG, so many points wide.

    Parameters
    ----------
    equation : Equation
    numbers : mapping of member to Numbers
        Empty for an equation that stands without numbers.
    colors : Tokens
    width_pt : float
    applies : bool
        Whether the equation holds for the design; if not, that is said.
    """
    import typst

    from gearstudio.report.language import Language, speaking

    with speaking(Language(decimal=decimal())):
        source = _source(equation, numbers, colors, width_pt, applies)
    return bytes(typst.compile(source.encode(), format="svg"))


def _source(equation: Equation, numbers: dict[str, Numbers], colors: Tokens, width_pt: float, applies: bool) -> str:
    parts = [
        f"#set page(width: {width_pt:.0f}pt, height: auto, margin: 10pt, fill: none)",
        f'#set text(size: 11pt, fill: rgb("{colors.text}"), font: ("Libertinus Serif", "Noto Sans CJK SC", '
        '"Droid Sans Fallback"))',
        _FIT,
        f'#text(size: 15pt, weight: "bold", {_quoted(tr(equation.title))})',
        f'#v(-4pt)\n#text(size: 9.5pt, fill: rgb("{colors.muted}"), {_quoted(_where(equation))})',
        _prose(tr(equation.meaning)),
        f"#text(size: 13pt)[{_fitted(equation.used)}]",
    ]
    if not applies:
        parts.append(f'#text(fill: rgb("{colors.muted}"), {_quoted(tr(_NOT_FOR[equation.holds]))})')
    if equation.printed:
        said = f"{tr(equation.departure)} {tr(equation.evidence)}"
        parts.append(
            f'#block(inset: 9pt, radius: 5pt, width: 100%, fill: rgb("{colors.warning_soft}"))[\n'
            f"#strong({_quoted(tr('The paper prints'))})\n{_fitted(equation.printed)}\n{_prose(said)}\n]"
        )
    for title, put in _titled(numbers):
        parts.append(
            f'#block(inset: 9pt, radius: 5pt, width: 100%, fill: rgb("{colors.sunken}"))[\n'
            f"#strong({_quoted(tr(title))})\n\n"
            f"#par(justify: false)[{_values(put.inputs)}]\n\n"
            f'#par(justify: false)[#text(fill: rgb("{colors.accent}"))[{_values(put.outputs)}]]\n]'
        )
    return "\n\n".join(parts)


def _fitted(formula: str) -> str:
    from gearstudio.report.mathematics import pointed

    written = pointed(formula)
    lines = written.replace(", quad ", ", \\ ")
    return f"#fit([$ {written} $], [$ {lines} $])"


def _prose(text: str) -> str:
    """Words with the symbols among them as mathematics."""
    from gearstudio.report.mathematics import prose

    return "".join(f"${part}$" if kind == "mathematics" else f"#text({_quoted(part)})" for kind, part in prose(text))


def _where(equation: Equation) -> str:
    numbered = equation.section[:1].isdigit()
    section = tr("theory, section {number}", number=equation.section) if numbered else tr(equation.section)
    return tr("paper, equation {number}", number=equation.paper) + " · " + section if equation.paper else section


def _titled(numbers: dict[str, Numbers]) -> list[tuple[str, Numbers]]:
    """Numbers with their headings; what is the same for both members stands once."""
    if len(numbers) == len(MEMBER_TITLES) and len(set(numbers.values())) == 1:
        return [("Both members", next(iter(numbers.values())))]
    return [(MEMBER_TITLES[member], put) for member, put in numbers.items()]


def _values(given: tuple[Given, ...]) -> str:
    from gearstudio.report.mathematics import pointed

    return " ".join(f"#box[${pointed(_shown(one).mathematics(8))}$#h(1em)]" for one in given)


def _shown(given: Given) -> Given:
    """A number in the unit of length that the user chose."""
    if given.unit != "mm" or factor("mm") == 1:
        return given
    return replace(given, value=to_shown(given.value, "mm"), unit="in")


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
