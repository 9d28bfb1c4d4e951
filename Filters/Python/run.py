"""Runs a filter for its function: inputs, properties, errors, warnings, progress and Ctrl+C."""
from __future__ import annotations

import contextlib
import re
import signal
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Optional

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from .data import Data, to_vtk, values

__all__ = ['ShapeError', 'ShapeWarning', 'facts']

#: Called with the share that is done, from 0 to 1. What it raises stops the filter.
Progress = Callable[[float], object]
Facts = dict[str, Any]


class ShapeError(RuntimeError):
    """A filter cannot use its input, or its computation did not succeed: its own message."""


class ShapeWarning(UserWarning):
    """A filter's warning."""


class Run:
    """One run of a filter."""

    def __init__(self, algorithm: Any) -> None:
        self.algorithm = algorithm
        self.name = algorithm.GetClassName()[len('vtkShape'):]
        self.failure: Optional[BaseException] = None

    def connect(self, command: str, port: Optional[int], given: Data, name: str, solid: bool) -> None:
        """Connects an input. Repeatable inputs have commands of their own, without a port."""
        producer = vtkTrivialProducer()
        producer.SetOutput(to_vtk(given, name, solid))
        arguments = () if port is None else (port,)
        getattr(self.algorithm, command)(*arguments, producer.GetOutputPort())

    def choose(self, command: str, word: str, words: Mapping[str, int], name: str) -> None:
        """Sets an enumeration by its word."""
        if word not in words:
            raise ValueError('%s: there is no %r; use one of %s' % (name, word, ', '.join(words)))
        getattr(self.algorithm, command)(words[word])

    def set(self, command: str, *arguments: Any) -> None:
        getattr(self.algorithm, command)(*arguments)

    def set_rows(self, count: str, command: str, rows: Sequence[Any], width: int) -> None:
        """Sets a property with any number of rows of `width` numbers."""
        getattr(self.algorithm, count)(len(rows))
        for k, row in enumerate(rows):
            getattr(self.algorithm, command)(k, *(row if width > 1 else [row]))

    def outputs(self, ports: Sequence[int], progress: Optional[Progress],
                time: Optional[float] = None) -> tuple[list[vtkDataObject], Facts]:
        """Updates the filter. Returns the outputs of `ports`, and the facts."""
        errors: list[str] = []
        told: list[str] = []

        def report(caller: Any, event: str) -> None:
            # VTK ends the process at an exception in an observer.
            if progress is not None and self.failure is None:
                try:
                    progress(self.algorithm.GetProgress())
                except BaseException as failure:
                    self.stop(failure)

        executive = self.algorithm.GetExecutive()
        tags = [(each, each.AddObserver(event, _recorder(messages))) for each in (self.algorithm, executive)
                for event, messages in (('ErrorEvent', errors), ('WarningEvent', told))]
        tags.append((self.algorithm, self.algorithm.AddObserver('ProgressEvent', report)))
        try:
            with self.interruptible():
                if time is None:
                    self.algorithm.Update()
                else:
                    self.algorithm.UpdateInformation()
                    self.algorithm.UpdateTimeStep(time)
        finally:
            for each, tag in tags:
                each.RemoveObserver(tag)
        for message in told:
            warnings.warn(_own_words(message), ShapeWarning, stacklevel=4)
        if self.failure is not None:
            raise self.failure
        if errors:
            raise ShapeError(_own_words(errors[0]))
        return [self.algorithm.GetOutputDataObject(port) for port in ports], facts(self.algorithm)

    def stop(self, failure: BaseException) -> None:
        """Stops the filter at its next report of progress; outputs() raises `failure`."""
        self.failure = failure
        # VTK 9.1 has the first one alone.
        self.algorithm.SetAbortExecute(1)
        if hasattr(self.algorithm, 'SetAbortExecuteAndUpdateTime'):
            self.algorithm.SetAbortExecuteAndUpdateTime()

    @contextlib.contextmanager
    def interruptible(self) -> Iterator[None]:
        """Ctrl+C stops the filter. Python's own handler would raise in an observer."""
        if (threading.current_thread() is not threading.main_thread() or
                signal.getsignal(signal.SIGINT) is not signal.default_int_handler):
            yield
            return
        signal.signal(signal.SIGINT, lambda number, frame: self.stop(KeyboardInterrupt()))
        try:
            yield
        finally:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def facts(source: Any) -> Facts:
    """The facts of the last run of a filter by their names, such as ``MinimumScaledJacobian``.

    Parameters
    ----------
    source : vtkShapeAlgorithm or a ParaView filter
        An updated filter.

    Returns
    -------
    dict
        Numbers, words, and arrays of numbers. Empty if the filter has none or failed.
    """
    # The VTK filter itself, if the server is the built-in one.
    algorithm = source.SMProxy.GetClientSideObject() if hasattr(source, 'SMProxy') else source
    if hasattr(algorithm, 'GetOutputDataObject'):
        name = algorithm.GetClassName()[len('vtkShape'):]
        # Other tables have no column that begins with the name of the filter.
        tables = [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]
        return next(filter(None, (_facts_in(table, name) for table in tables)), {})
    from paraview.servermanager import Fetch
    ports = range(source.SMProxy.GetNumberOfOutputPorts())
    port = next((k for k in ports if source.SMProxy.GetOutputPortName(k) == 'Facts'), None)
    return {} if port is None else _facts_in(Fetch(source, 0, idx=port), source.SMProxy.GetXMLName()[len('Shape'):])


def _facts_in(table: vtkDataObject, name: str) -> Facts:
    if not isinstance(table, vtkTable):
        return {}
    found: Facts = {}
    for k in range(table.GetNumberOfColumns()):
        array = table.GetColumn(k)
        if array.GetName().startswith(name + '.'):
            fact = values(array)
            found[array.GetName()[len(name) + 1:]] = fact.item() if fact.size == 1 else fact.ravel()
    return found


def _recorder(messages: list[str]) -> Any:
    """An observer that keeps the messages of its events."""
    def record(caller: Any, event: str, message: str) -> None:
        messages.append(message)

    return calldata_type(VTK_STRING)(record)


def _own_words(message: str) -> str:
    """A message without the file, line and address that VTK puts in front."""
    return re.sub(r'^.*?\(0x[0-9a-f]+\): ', '', message, count=1, flags=re.DOTALL).strip()
