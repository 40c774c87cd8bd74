"""How many times as large deviations may be drawn."""

from __future__ import annotations

from ui.words import tr

OFF, AUTOMATIC = 1, 0
FACTORS = (10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000)


def factor_text(factor: int) -> str:
    """As it is read: ``×10 000``."""
    return f"×{factor:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")


def factor_rows() -> list[tuple[int, str]]:
    """The factors to choose from, in words."""
    return [(OFF, tr("×1, as it is")), (AUTOMATIC, tr("Automatic")), *((one, factor_text(one)) for one in FACTORS)]
