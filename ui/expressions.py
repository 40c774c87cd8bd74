"""Sums that are typed into a field: ``25.4*3``, ``1/2in + 0.1``, ``atan(17/40)``, ``2*tan(20deg)``.

Decimal point and comma both count. A comma parts the arguments of `atan2`, `hypot`, `min`, `max` and `pow`; there
decimals take the point, or the arguments a semicolon. What could be read in two ways where decimals are written with a
comma, as ``max(1,5, 2)``, has no value. Functions are those of Python's math module, angles in radians.
"""

from __future__ import annotations

import ast
import math
import re
import warnings
from collections.abc import Callable

from simpleeval import InvalidExpression, NumberTooHigh, SimpleEval

from gearstudio.words import POINT
from ui.formatting import MINUS, WIDE
from ui.language import decimal
from ui.units import MM_PER_INCH, factor
from ui.words import tr

LONGEST = 200
PAIRED = ("atan2", "hypot", "min", "max", "pow")
ANGLES = ("asin", "acos", "atan", "atan2")
FUNCTIONS: dict[str, Callable[..., float]] = {
    name: getattr(math, name)
    for name in (
        "sqrt", "cbrt", "exp", "log", "log10", "sin", "cos", "tan", "sinh", "cosh", "tanh", "degrees", "radians",
        "floor", "ceil", "fabs", "hypot", "pow", *ANGLES,
    )
} | {"abs": abs, "min": min, "max": max}  # fmt: skip
CONSTANTS = {"pi": math.pi, "π": math.pi, "e": math.e, "tau": math.tau}
LENGTHS = {"in": MM_PER_INCH, "mm": 1.0, "um": 1e-3}
TURNS = {"deg": math.pi / 180, "rad": 1.0}
KNOWN = {*FUNCTIONS, *CONSTANTS, *LENGTHS, *TURNS}
SUFFIX = re.compile(r"(?<=[\d.)])\s*(in|mm|um|deg|rad)(?![\w(])")
OTHER_NUMBERS = re.compile(r"\b0[xob]|\d_|\dj", re.IGNORECASE)
"""Python's ways to write numbers that are not meant here: 0x1f, 1_000, 2j."""
_BINARY = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.Pow)
_ALLOWED = (ast.Expression, ast.BinOp, ast.UnaryOp, ast.UAdd, ast.USub, ast.Call, ast.Name, ast.Load, *_BINARY)


class ExpressionError(ValueError):
    """What was typed cannot be computed; the text says why, fit for the user."""


def evaluate(text: str, unit: str) -> float:
    """Value of a sum for a field.

    Parameters
    ----------
    text : str
        As typed.
    unit : str
        Unit of the field in the design: ``"mm"``, ``"°"`` or another. Bare numbers in a field of lengths count in
        the unit shown.

    Returns
    -------
    float
        In the field's unit.

    Raises
    ------
    ExpressionError
    """
    if len(text) > LONGEST:
        raise ExpressionError(tr("The sum is longer than {count} characters", count=LONGEST))
    tree = _parse(text)
    names = CONSTANTS | {f"_{name}": size for name, size in (LENGTHS | TURNS).items()}
    kinds = {"mm": LENGTHS, "°": TURNS}.get(unit, {})
    foreign = ({**LENGTHS, **TURNS}.keys() - kinds.keys()) & _units(tree.body)
    if foreign:
        raise ExpressionError(tr("“{unit}” does not suit this field", unit=min(foreign)))
    bare = factor("mm") if unit == "mm" else math.pi / 180
    body = _lift(tree.body, bare) if kinds else tree.body
    value = _compute(body, names)
    if not kinds:
        return value
    if not _units(body):
        return _round(value * factor(unit))
    return _round(math.degrees(value) if unit == "°" else value)


def _parse(text: str) -> ast.Expression:
    plain = text.translate(WIDE).strip().replace(MINUS, "-").replace("×", "*").replace("·", "*").replace("÷", "/")
    plain = (
        plain.replace("^", "**")
        .replace("°", "deg")
        .replace("µ", "u")
        .replace("μ", "u")
        .replace("″", "in")
        .replace('"', "in")
    )
    plain = SUFFIX.sub(r"*_\1", _points(plain))
    try:
        if OTHER_NUMBERS.search(plain):
            raise ValueError
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SyntaxWarning)
            tree = ast.parse(plain, mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise ExpressionError(tr("“{text}” is neither a number nor a sum", text=text.strip())) from None
    for node in ast.walk(tree):
        number = isinstance(node, ast.Constant) and type(node.value) in (int, float)
        if not (number or isinstance(node, _ALLOWED)) or (isinstance(node, ast.Call) and node.keywords):
            raise ExpressionError(tr("“{text}” is neither a number nor a sum", text=text.strip()))
        if isinstance(node, ast.Name) and node.id.lstrip("_") not in KNOWN:
            raise ExpressionError(tr("“{name}” is not known here", name=node.id))
        if isinstance(node, ast.Constant):
            node.value = float(node.value) if abs(node.value) < 1e300 else math.inf  # type: ignore[arg-type]
    return tree


def _points(text: str) -> str:
    """Decimal commas as points, and commas between arguments."""
    made: list[str] = []
    open_calls: list[str] = []
    for place, letter in enumerate(text):
        if letter == "(":
            name = re.search(r"[^\W\d]\w*$", text[:place])
            rest = text[place : _closing(text, place)]
            pair = name is not None and name.group() in PAIRED and ";" not in rest
            if pair and decimal() != POINT and _undecided(rest):
                raise ExpressionError(tr("Separate the arguments by semicolons, as in max(1,5; 2)"))
            open_calls.append("," if pair else ".")
        elif letter == ")" and open_calls:
            open_calls.pop()
        if letter == ",":
            made.append(open_calls[-1] if open_calls else ".")
        else:
            made.append("," if letter == ";" else letter)
    return "".join(made)


def _undecided(call: str) -> bool:
    """Whether commas between digits in ``(…`` may be decimal signs: where there are more than two numbers."""
    own = call[1:]
    while (outer := re.sub(r"\([^()]*\)", "_", own)) != own:
        own = outer
    return own.count(",") > 1 and re.search(r"\d,\d", own) is not None


def _closing(text: str, start: int) -> int:
    depth = 0
    for place in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place
    return len(text)


def _units(node: ast.expr) -> set[str]:
    """Units that a value carries; those in the arguments of a function do not come out of it."""
    if isinstance(node, ast.Name):
        return {node.id[1:]} if node.id.startswith("_") else set()
    if isinstance(node, ast.Call):
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name in ANGLES:
            return {"rad"}
        passes = name in ("abs", "fabs", "min", "max", "hypot")
        return set().union(*(_units(arg) for arg in node.args)) if passes else set()
    if isinstance(node, ast.BinOp):
        left, right = _units(node.left), _units(node.right)
        if left and (right if isinstance(node.op, ast.Mult | ast.Div) else isinstance(node.op, ast.Pow)):
            raise ExpressionError(tr("Values with a unit can be added, but not multiplied with each other"))
        return left | right
    return _units(node.operand) if isinstance(node, ast.UnaryOp) else set()


def _lift(node: ast.expr, bare: float) -> ast.expr:
    """A bare number that is added to one with a unit takes the field's unit."""
    if isinstance(node, ast.UnaryOp):
        return ast.UnaryOp(node.op, _lift(node.operand, bare))
    if not isinstance(node, ast.BinOp):
        return node
    left, right = _lift(node.left, bare), _lift(node.right, bare)
    if isinstance(node.op, ast.Add | ast.Sub):
        with_left, with_right = bool(_units(left)), bool(_units(right))
        if with_left and not with_right:
            right = _given(right, bare)
        elif with_right and not with_left:
            left = _given(left, bare)
    return ast.BinOp(left, node.op, right)


def _given(node: ast.expr, size: float) -> ast.expr:
    return ast.BinOp(node, ast.Mult(), ast.Constant(size))


def _compute(body: ast.expr, names: dict[str, float]) -> float:
    sums = SimpleEval(functions=FUNCTIONS, names=names)
    try:
        value = sums.eval("", previously_parsed=body)
    except ZeroDivisionError:
        raise ExpressionError(tr("The sum divides by zero")) from None
    except (OverflowError, NumberTooHigh):
        raise ExpressionError(tr("The sum has no finite value")) from None
    except (InvalidExpression, ArithmeticError, ValueError, TypeError, RecursionError):
        raise ExpressionError(tr("The sum has no value: look at the arguments of its functions")) from None
    if callable(value):
        raise ExpressionError(tr("The sum has no value: look at the arguments of its functions"))
    if isinstance(value, complex) or not math.isfinite(value):
        raise ExpressionError(tr("The sum has no finite value"))
    return float(value)


def _round(value: float) -> float:
    return float(f"{value:.12g}")
