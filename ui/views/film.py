"""Frames into a film: a process encodes them, the file is there whole or not at all."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Generator
from pathlib import Path

import numpy as np
from PySide6.QtGui import QImage

from gearstudio.errors import FileError
from gearstudio.files import named_errors, why_not_written

KINDS = {".mp4": "libx264", ".gif": "gif"}
_PALETTE = "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4"


class Film:
    """A film being written.

    Parameters
    ----------
    path : Path
        Ends in one of `KINDS`.
    size : (int, int)
        Width and height in pixels, even numbers.
    fps : int

    Raises
    ------
    FileError
        The kind is not known, or nothing can be written there.
    """

    def __init__(self, path: Path, size: tuple[int, int], fps: int) -> None:
        import imageio_ffmpeg

        kind = path.suffix.lower()
        if kind not in KINDS:
            raise FileError(path, "films are written as .mp4 or .gif")
        self._path = path
        self._unfinished = path.with_name(f".{os.getpid()}-{path.stem[:80]}.part{kind}")
        with named_errors(path):
            self._unfinished.touch()
        extra = ["-filter_complex", _PALETTE] if kind == ".gif" else ["-movflags", "+faststart"]
        self._writer: Generator[None, np.ndarray | None, None] = imageio_ffmpeg.write_frames(
            str(self._unfinished),
            size,
            fps=fps,
            codec=KINDS[kind],
            pix_fmt_out="yuv420p" if kind == ".mp4" else "pal8",
            quality=8 if kind == ".mp4" else None,
            macro_block_size=2,
            output_params=extra,
            ffmpeg_log_level="error",
        )
        self._writer.send(None)

    def add(self, frame: QImage) -> None:
        """Append a frame of the film's size; raises FileError when the encoder gave up."""
        image = frame.convertToFormat(QImage.Format.Format_RGB888)
        rows = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(image.height(), image.bytesPerLine())
        try:
            self._writer.send(np.ascontiguousarray(rows[:, : 3 * image.width()]))
        except OSError as error:
            raise self._failure() from error

    def finish(self) -> None:
        """Wait for the encoder and put the film in its place; raises FileError."""
        self._writer.close()
        with named_errors(self._path):
            if not self._unfinished.exists() or self._unfinished.stat().st_size == 0:
                raise self._failure()
            os.replace(self._unfinished, self._path)

    def give_up(self) -> None:
        """End the encoder and leave nothing behind."""
        with contextlib.suppress(OSError):
            self._writer.close()
        with contextlib.suppress(OSError):
            self._unfinished.unlink()

    def _failure(self) -> FileError:
        """Why the encoder gave up, as far as the disk is to blame."""
        return FileError(
            self._path,
            why_not_written(
                self._unfinished, "the film could not be encoded; try a smaller picture, or the other kind of file"
            ),
        )
