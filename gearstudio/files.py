"""Reading and writing whole files, with errors that say what to do about them."""

from __future__ import annotations

import contextlib
import errno
import os
import sys
import tempfile
import traceback
from collections.abc import Iterator, Mapping
from datetime import datetime
from pathlib import Path

from gearstudio.errors import FileError

_REASONS = {
    errno.ENOENT: "there is no such file or folder",
    errno.EACCES: "no permission",
    errno.EPERM: "no permission",
    errno.EROFS: "the disk is read-only",
    errno.EFBIG: "the file is too large for this disk",
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "the disk quota is used up",
    errno.ENOTDIR: "a part of the path is a file, not a folder",
    errno.EEXIST: "there is a file where the folder should be",
    errno.EISDIR: "this is a folder, not a file",
    errno.ENAMETOOLONG: "the name is too long",
    errno.EIO: "the disk reports a fault",
    errno.EBUSY: "another program is using it",
}
_ELSEWHERE, _ROOM = "choose another folder", "free some space, or choose another disk"
_CLOSE_IT = "close it there and try again"
_WHEN_WRITING = {
    errno.ENOENT: "choose another folder, or make this one first",
    errno.EACCES: "choose another folder, or ask who owns this one",
    errno.EPERM: "choose another folder, or ask who owns this one",
    errno.EROFS: _ELSEWHERE,
    errno.EFBIG: "choose another disk",
    errno.ENOSPC: _ROOM,
    errno.EDQUOT: _ROOM,
    errno.ENOTDIR: _ELSEWHERE,
    errno.EEXIST: _ELSEWHERE,
    errno.EISDIR: "choose another name",
    errno.ENAMETOOLONG: "choose a shorter one",
    errno.EIO: "choose another disk, and have this one checked",
    errno.EBUSY: _CLOSE_IT,
}
_WHEN_READING = {
    errno.ENOENT: "check its name, it may have been moved",
    errno.EACCES: "ask who owns it to let you read it",
    errno.EPERM: "ask who owns it to let you read it",
    errno.EISDIR: "choose a file in it",
    errno.EIO: "copy the file from another place, and have this disk checked",
    errno.EBUSY: _CLOSE_IT,
}
_SHARING_VIOLATIONS = (32, 33)
"""What Windows calls a file that another program keeps to itself."""
_TRIAL = 1 << 16
"""Bytes that tell whether a disk takes any more."""


def read_bytes(path: Path) -> bytes:
    """Contents of a file.

    Raises
    ------
    FileError
        It is missing, a folder, not permitted, or not readable.
    """
    with named_errors(path, reading=True):
        return path.read_bytes()


def write_bytes(path: Path, content: bytes) -> None:
    """Write a file as a whole: it is there complete, or what was there before stays.

    Raises
    ------
    FileError
        It cannot be written there.
    """
    with named_errors(path):
        target = Path(os.path.realpath(path))  # a link is written through, not replaced
        if target.is_dir():
            raise IsADirectoryError(errno.EISDIR, "is a folder")
        unfinished = target.with_name(f".{os.getpid()}-{target.name[:100]}.part")
        try:
            with open(unfinished, "wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            with contextlib.suppress(OSError):
                os.chmod(unfinished, target.stat().st_mode)
            os.replace(unfinished, target)
        finally:
            with contextlib.suppress(OSError):
                unfinished.unlink()


def write_text(path: Path, content: str) -> None:
    """`write_bytes` of UTF-8 text with plain newlines."""
    write_bytes(path, content.encode("utf-8"))


@contextlib.contextmanager
def named_errors(path: Path, *, reading: bool = False) -> Iterator[None]:
    """Turn what the operating system refuses into a FileError about the file that was asked for, with what to do."""
    try:
        yield
    except OSError as error:
        raise FileError(path, _refusal(error, _WHEN_READING if reading else _WHEN_WRITING)) from error
    except ValueError as error:  # a null character in the name
        raise FileError(path, "this is not a file name") from error


def why_not_written(path: Path, otherwise: str) -> str:
    """Why another program could not write a file: what the operating system says of a trial beside it, or `otherwise`.

    To be asked before what that program left is removed: on a full disk it takes the room.
    """
    trial = path.with_name(f".{os.getpid()}-trial.part")
    try:
        write_bytes(trial, bytes(_TRIAL))
    except FileError as error:
        return error.reason
    finally:
        with contextlib.suppress(OSError):
            trial.unlink()
    return otherwise


def _refusal(error: OSError, remedies: Mapping[int, str]) -> str:
    number = errno.EBUSY if getattr(error, "winerror", 0) in _SHARING_VIOLATIONS else error.errno or 0
    reason, remedy = _REASONS.get(number, error.strerror or str(error)), remedies.get(number, "")
    return f"{reason}; {remedy}" if remedy else reason


def log_file() -> Path:
    """Where this user's failures are written down; its folder is made when possible, else it is a temporary one."""
    home = Path(os.path.expanduser("~"))
    if sys.platform == "win32":
        folder = Path(os.environ.get("LOCALAPPDATA") or home) / "GearStudio"
    elif sys.platform == "darwin":
        folder = home / "Library" / "Logs" / "GearStudio"
    else:
        folder = Path(os.environ.get("XDG_STATE_HOME") or home / ".local" / "state") / "gearstudio"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if os.access(folder, os.W_OK):
            return folder / "gearstudio.log"
    except OSError:
        pass
    return Path(tempfile.gettempdir()) / "gearstudio.log"


def log_failure(error: BaseException) -> Path:
    """Append an unexpected error with its traceback to the log and say where that is."""
    path = log_file()
    with contextlib.suppress(OSError), open(path, "a", encoding="utf-8", errors="replace") as log:
        log.write(f"{datetime.now().astimezone().isoformat(timespec='seconds')}\n")
        log.writelines(traceback.format_exception(error))
        log.write("\n")
    return path
