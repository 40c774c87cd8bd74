"""What tests of the command line share."""

from __future__ import annotations

from typing import Any

import pytest

from gearstudio import cli


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Any:
    """Runs a command; gives its exit status, standard output and lines of standard error."""

    def runner(*argv: object) -> tuple[int, str, list[str]]:
        status = cli.main([str(word) for word in argv])
        captured = capsys.readouterr()
        return status, captured.out, captured.err.splitlines()

    return runner
