"""Processor time of a peer: the preparation (compilation, setup) and a run are measured separately."""

from time import process_time

SAMPLES = 5
"""Largest number of samples."""
SAMPLE = 0.2
"""A sample repeats the run until this time has passed [s], because on a busy machine the clock advances in steps of 4 ms."""
ENOUGH = 1.0
"""Total processor time [s] after which no further sample is taken, if there are at least three."""
LONG = 3.0
"""A run that takes longer than this [s] is not repeated."""


def sample(solve):
    """One sample: the mean processor time of its runs [s], their total time [s], and the result of the last run."""
    begun, runs, took = process_time(), 0, 0.0
    while took < SAMPLE:
        result = solve()
        runs, took = runs + 1, process_time() - begun
    return took / runs, took, result


def measure(prepare, solve):
    """Prepares once and solves several times. Returns the last result with the times [s] in `prepare` and `cpu`."""
    begun = process_time()
    prepared = prepare()
    setup = process_time() - begun
    times, total = [], 0.0
    while True:
        time, took, result = sample(lambda: solve(prepared))
        times.append(time)
        total += took
        repeated = len(times) >= 3 and (total > ENOUGH or len(times) == SAMPLES)
        if repeated or times[0] > LONG:
            return {**result, "prepare": setup, "cpu": times}


def least(derive):
    """The smallest of three processor times [s] (of one, if that is long), and the last result."""
    times = []
    while len(times) < 3 and not (times and times[0] > LONG):
        time, _, result = sample(derive)
        times.append(time)
    return min(times), result
