"""Runs one task for each of many subjects, each in a process of its own, and remembers what is done."""
from __future__ import annotations

import ctypes
import hashlib
import json
import os
import resource
import select
import signal
import sys
import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, field
from typing import Any, Optional

from .files import replace

#: The folder of the output folder in which records and pictures are.
STATE = '.shapemap'


@dataclass
class Record:
    """What is known of a subject. `key`: of the content of its inputs and of the options."""
    name: str
    key: str = ''
    status: str = 'not done'
    seconds: float = 0.0
    peak: float = 0.0  # MiB
    facts: dict[str, Any] = field(default_factory=dict)
    message: str = ''
    outputs: dict[str, int] = field(default_factory=dict)  # their sizes
    timeout: float = 0.0


@dataclass(frozen=True)
class Task:
    """A subject: `work` returns its facts and outputs in a process of its own, and then `draw` draws its picture."""
    name: str
    key: str
    work: Callable[[], tuple[dict[str, Any], dict[str, int]]]
    draw: Callable[[], None]


def key_of(parts: Any, paths: Iterable[str]) -> str:
    """A key of options and of the content of files."""
    digest = hashlib.sha256(json.dumps(parts, sort_keys=True).encode())
    for path in paths:
        with open(path, 'rb') as file:
            digest.update(hashlib.sha256(file.read()).digest())
    return digest.hexdigest()


def record_path(folder: str, name: str) -> str:
    return os.path.join(folder, STATE, name + '.json')


def read_record(folder: str, name: str) -> Record:
    """What an earlier run left, or a record of nothing."""
    try:
        with open(record_path(folder, name)) as file:
            return Record(**json.load(file))
    except (OSError, ValueError, TypeError):
        return Record(name)


def up_to_date(record: Record, task: Task, folder: str, timeout: float, redo: str) -> bool:
    """Whether the subject need not be done: it was done, or failed, with the same content and options."""
    if record.key != task.key or redo == 'all' or record.status == 'not done':
        return False
    if record.status != 'done':
        longer = record.status == 'timed out' and record.timeout and not 0.0 < timeout <= record.timeout
        return redo != 'failed' and not longer
    return all(os.path.exists(os.path.join(folder, path)) and os.path.getsize(os.path.join(folder, path)) == size
               for path, size in record.outputs.items())


def run(tasks: Iterable[Task], folder: str, jobs: int, timeout: float, report: Callable[[Record], None]) -> None:
    """Does the tasks, `jobs` at a time. A task that takes longer than `timeout` seconds (0: no limit) is killed.
    `report` is called with the record of each. An exception, such as Ctrl+C, ends the running ones."""
    waiting, running = deque(tasks), dict[int, tuple[Task, int, float]]()
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                task = waiting.popleft()
                process, pipe = _start(task, folder, jobs)
                running[pipe] = task, process, time.monotonic()
            late = min(start for _, _, start in running.values()) + timeout - time.monotonic()
            ended, _, _ = select.select(list(running), [], [], max(0.0, late) if timeout else None)
            for pipe, (task, process, start) in list(running.items()):
                overdue = timeout > 0.0 and time.monotonic() - start >= timeout
                if pipe in ended or overdue:
                    report(_end(task, process, pipe, start, folder, timeout if pipe not in ended else 0.0))
                    del running[pipe]
    finally:
        for pipe, (task, process, start) in running.items():
            _kill(process)
            os.waitpid(process, 0)
            os.close(pipe)


def _start(task: Task, folder: str, jobs: int) -> tuple[int, int]:
    """Starts a process. The pipe is at its end when the process is."""
    pipe, inner = os.pipe()
    parent = os.getpid()
    sys.stdout.flush()
    sys.stderr.flush()
    process = os.fork()
    if process == 0:
        try:
            os.close(pipe)
            _detach(parent, folder, task.name)
            os.environ.setdefault('VTK_SMP_MAX_THREADS', str(max(1, len(os.sched_getaffinity(0)) // jobs)))
            _work(task, folder)
        finally:
            os._exit(0)
    os.close(inner)
    return process, pipe


def _detach(parent: int, folder: str, name: str) -> None:
    """Ctrl+C is the runner's own, and the process ends with the runner."""
    os.setsid()
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG
    if os.getppid() != parent:
        os._exit(1)
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with open(os.devnull) as nothing, open(os.path.join(folder, STATE, name + '.txt'), 'w') as printed:
        os.dup2(nothing.fileno(), 0)
        os.dup2(printed.fileno(), 1)
        os.dup2(printed.fileno(), 2)


def _work(task: Task, folder: str) -> None:
    start = time.monotonic()
    record = Record(task.name, task.key)
    try:
        record.facts, record.outputs = task.work()
        record.status = 'done'
    except Exception as error:
        record.status, record.message = 'failed', ' '.join(str(error).split()) or type(error).__name__
    record.seconds = round(time.monotonic() - start, 3)
    record.peak = round(max(resource.getrusage(who).ru_maxrss for who in (
        resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)) / 1024, 1)
    _write(record, folder)
    if record.status == 'done':
        task.draw()


def _end(task: Task, process: int, pipe: int, start: float, folder: str, timeout: float) -> Record:
    """The record of a process that has ended, or that is late."""
    if timeout:
        _kill(process)
    _, status, used = os.wait4(process, 0)
    _kill(process)  # what it left running
    os.close(pipe)
    record = read_record(folder, task.name)
    if record.key == task.key and record.status in ('done', 'failed'):
        return record
    record = Record(task.name, task.key, 'crashed', round(time.monotonic() - start, 3), round(used.ru_maxrss / 1024, 1))
    if timeout:
        record.status, record.timeout = 'timed out', timeout
        record.message = 'it was stopped after %g s; give a larger --timeout' % timeout
    else:
        number = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
        record.message = 'its process ended early%s; free some memory, or give fewer --jobs' % (
            ', by signal %d (%s)' % (number, signal.Signals(number).name) if number else '')
    _write(record, folder)
    return record


def _kill(process: int) -> None:
    try:
        os.killpg(process, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it ended by itself
    try:
        os.kill(process, signal.SIGKILL)  # before it has a group
    except ProcessLookupError:
        pass


def _write(record: Record, folder: str) -> None:
    replace(record_path(folder, record.name), json.dumps(asdict(record), indent=1).encode())
