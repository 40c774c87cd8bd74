"""All six variants of one member: built on both flanks and measured, as the command line does it."""

from __future__ import annotations

from benchmarks.measurement import timed


def compare_all(member: str) -> list[object]:
    """The results of every method and variant for one member of the default design."""
    from gearstudio.analysis.comparison import build_variant
    from gearstudio.catalogue import METHOD_IDS, VARIANTS
    from gearstudio.design import Design

    design = Design()
    return [build_variant(design, member, method, variant) for method in METHOD_IDS for variant in VARIANTS]


def measure(member: str, times: int = 7) -> list[float]:
    """Seconds of one comparison, each time; the imports and one comparison before are not counted."""
    compare_all(member)
    return timed(lambda: compare_all(member), times)


if __name__ == "__main__":
    for name in ("wheel", "pinion"):
        print(name, measure(name))
