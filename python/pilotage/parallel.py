"""Many runs in many processes, in order."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeVar

from joblib import Parallel, delayed, parallel_config
from joblib.externals.loky.process_executor import TerminatedWorkerError

T = TypeVar("T")


def in_processes(
    function: Callable[..., T],
    calls: Sequence[tuple[Any, ...]],
    jobs: int,
    died: Callable[[int], str],
    progress: Callable[[float], None] | None = None,
) -> Iterator[T]:
    """Call a function with each of the arguments, and yield what it returns in their order.

    Parameters
    ----------
    jobs : int
        Processes; -1 for one a core.
    died : callable
        What a RuntimeError says when a process died at the call of that index, or soon after.
    progress : callable
        Told the part that is done, 0 to 1.
    """
    done = 0
    with parallel_config(backend="loky", inner_max_num_threads=1):
        results = Parallel(n_jobs=jobs, return_as="generator")(
            delayed(function)(*arguments) for arguments in calls
        )
        try:
            for result in results:
                yield result
                done += 1
                if progress is not None:
                    progress(done / len(calls))
        except TerminatedWorkerError as error:
            raise RuntimeError(died(min(done, len(calls) - 1))) from error
