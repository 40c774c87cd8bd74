"""Equations as drawings, set in the colours of the theme."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.theme import Tokens
from ui.words import noted, tr

if TYPE_CHECKING:
    from gearstudio.equations import Equation, Given, Numbers

PARTS = (noted("offset axes"), noted("micro-geometry"))
"""Parts of the theory without a number."""


def drawing(equation: Equation, numbers: dict[str, Numbers], colors: Tokens, width_pt: float) -> bytes:
    """An equation with its departure and its numbers as SVG, so many points wide.

    Parameters
    ----------
    equation : Equation
    numbers : mapping of member to Numbers
        Empty for an equation that stands without numbers.
    colors : Tokens
    width_pt : float
    """
    import typst

    return bytes(typst.compile(_source(equation, numbers, colors, width_pt).encode(), format="svg"))


def _source(equation: Equation, numbers: dict[str, Numbers], colors: Tokens, width_pt: float) -> str:
    parts = [
        f"#set page(width: {width_pt:.0f}pt, height: auto, margin: 10pt, fill: none)",
        f'#set text(size: 11pt, fill: rgb("{colors.text}"), font: ("Libertinus Serif", "Noto Sans CJK SC", '
        '"Droid Sans Fallback"))',
        f'#text(size: 15pt, weight: "bold", {_quoted(tr(equation.title))})',
        f'#v(-4pt)\n#text(size: 9.5pt, fill: rgb("{colors.muted}"), {_quoted(_where(equation))})',
        f"#text({_quoted(tr(equation.meaning))})",
        f"#text(size: 13pt)[$ {equation.used} $]",
    ]
    if equation.printed:
        said = f"{tr(equation.departure)} {tr(equation.evidence)}"
        parts.append(
            f'#block(inset: 9pt, radius: 5pt, width: 100%, fill: rgb("{colors.warning_soft}"))[\n'
            f"#strong({_quoted(tr('The paper prints'))})\n$ {equation.printed} $\n#text({_quoted(said)})\n]"
        )
    for member, put in numbers.items():
        parts.append(
            f'#block(inset: 9pt, radius: 5pt, width: 100%, fill: rgb("{colors.sunken}"))[\n'
            f"#strong({_quoted(tr(member.capitalize()))})\n\n"
            f"#par(justify: false)[${_values(put.inputs)}$]\n\n"
            f'#par(justify: false)[#text(fill: rgb("{colors.accent}"))[${_values(put.outputs)}$]]\n]'
        )
    return "\n\n".join(parts)


def _where(equation: Equation) -> str:
    numbered = equation.section[:1].isdigit()
    section = tr("theory, section {number}", number=equation.section) if numbered else tr(equation.section)
    return tr("paper, equation {number}", number=equation.paper) + " · " + section if equation.paper else section


def _values(given: tuple[Given, ...]) -> str:
    return ", quad ".join(one.mathematics(8) for one in given)


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
