"""Fonts with Chinese characters, which are the machine's own: the typesetter and the figures need the same one."""

from __future__ import annotations

from functools import cache

FAMILIES = (
    "Noto Serif CJK SC", "Noto Serif SC", "Source Han Serif SC", "Noto Sans CJK SC", "Noto Sans SC",
    "Source Han Sans SC", "Noto Sans CJK JP", "Songti SC", "PingFang SC", "Hiragino Sans GB", "Heiti SC", "STHeiti",
    "SimSun", "Microsoft YaHei", "SimHei", "WenQuanYi Zen Hei", "WenQuanYi Micro Hei", "AR PL UMing CN",
    "Arial Unicode MS", "Droid Sans Fallback",
)  # fmt: skip
"""Best first."""


@cache
def cjk_family() -> str | None:
    """The font for Chinese that both the typesetter and the drawing library find; None without one."""
    import typst
    from matplotlib.font_manager import fontManager

    drawn = {font.name for font in fontManager.ttflist}
    typeset = set(typst.Fonts().families())
    both = [family for family in FAMILIES if family in drawn and family in typeset]
    return both[0] if both else None
