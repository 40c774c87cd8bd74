"""What the controller thread tells the window, as records."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ui.job_queue import Ticket

State = Literal["starting", "ready", "busy", "replaced", "stopped"]


@dataclass(frozen=True)
class StateChanged:
    state: State
    reason: str = ""


@dataclass(frozen=True)
class QueueChanged:
    count: int


@dataclass(frozen=True)
class JobStarted:
    ticket: Ticket


@dataclass(frozen=True)
class JobProgressed:
    ticket: Ticket
    stage: str
    fraction: float


@dataclass(frozen=True)
class JobDone:
    ticket: Ticket
    result: object


@dataclass(frozen=True)
class JobFailed:
    ticket: Ticket
    text: str
    details: str = ""


@dataclass(frozen=True)
class JobCancelled:
    ticket: Ticket


JobEvent = JobStarted | JobProgressed | JobDone | JobFailed | JobCancelled
Event = StateChanged | QueueChanged | JobEvent
