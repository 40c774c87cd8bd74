"""What was found in an exported file, as lines of text."""

from __future__ import annotations

from gearstudio.checks import FaceCheck, FileCheck
from gearstudio.cli.output import table


def findings(check: FileCheck) -> str:
    """Verdict, size, and the largest deviation of each kind of face, indented."""
    lines = [str(check)]
    low, high = check.box
    size = " × ".join(f"{b - a:.6g}" for a, b in zip(low, high, strict=True))
    lines.append(f"box {size} mm, {check.box_error:.1e} mm from what was made")
    if check.deviations:
        lines += table([("face", "largest", "limit", "", ""), *map(_row, check.worst)], left=(0, 3, 4)).splitlines()
    if check.chord_um is not None and check.chord_limit_um is not None:
        lines.append(f"triangles within {check.chord_um:.4g} µm of theory, {check.chord_limit_um:.4g} µm allowed")
    lines += [f"note: {remark}" for remark in check.remarks]
    lines.append(f"read by {check.kernel}")
    return "\n".join(f"  {line}" for line in lines)


def _row(face: FaceCheck) -> tuple[str, str, str, str, str]:
    state = "ok" if face.good else "OUT OF LIMITS"
    return f"{face.member} {face.title}", f"{face.largest_um:.4f}", f"{face.limit_um:.4f}", "µm", state
