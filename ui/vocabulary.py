"""Single words of the core that stand in sentences, tables and read-outs of the window."""

from __future__ import annotations

from ui.words import noted

WORDS = (
    noted("pinion"),
    noted("wheel"),
    noted("pair"),
    noted("gear"),
    noted("concave"),
    noted("convex"),
    noted("concave flank"),
    noted("convex flank"),
    noted("concave fillet"),
    noted("convex fillet"),
    noted("concave meridian"),
    noted("convex meridian"),
    noted("published"),
    noted("optimised"),
    noted("drive"),
    noted("coast"),
    noted("tip"),
    noted("root"),
    noted("end"),
    noted("body"),
    noted("toe"),
    noted("heel"),
    noted("left"),
    noted("right"),
    noted("base"),
    noted("addendum"),
    noted("dedendum"),
    noted("least"),
    noted("most"),
    noted("number"),
    noted("flanks"),
    noted("tooth"),
    noted("teeth"),
    noted("fillet"),
    noted("rotating_line"),
    noted("profile_sweep"),
    noted("point_cloud"),
)
"""Members, flanks, faces and methods, as the core names them."""

SETTINGS = (
    noted("positions"),
    noted("points"),
    noted("cut"),
    noted("sections"),
    noted("guides"),
    noted("sweep"),
    noted("skin"),
    noted("pipe along the tooth trace"),
    noted("grid"),
    noted("spacing"),
    noted("even"),
    noted("non-uniform"),
    noted("parameters"),
    noted("kernel"),
    noted("psi, trace"),
    noted("modifications"),
    noted("left out"),
    noted("line"),
    noted("best fit"),
)
"""What a construction took, and its values."""
