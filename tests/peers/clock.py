"""Processor time of a peer: what is prepared once (compiled, set up) apart from what a run costs."""

from time import process_time

SAMPLES = 5
"""Times taken at most."""
SAMPLE = 0.2
"""A sample runs again until it has taken as long [s]: on a busy machine the clock advances by ticks of 4 ms."""
ENOUGH = 1.0
"""Processor time after which no further sample is begun, once there are three [s]."""
LONG = 3.0
"""A run that takes as long is not repeated [s]."""


def sample(solve):
    """The processor time of one run [s], out of as many as make a sample, and what the last run gave."""
    begun, runs, took = process_time(), 0, 0.0
    while took < SAMPLE:
        result = solve()
        runs, took = runs + 1, process_time() - begun
    return took / runs, took, result


def measure(prepare, solve):
    """Prepares once, solves several times: what the last run gave, with the times in `prepare` and `cpu`."""
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
    """The least of three processor times (one of what takes long), and what the last gave."""
    times = []
    while len(times) < 3 and not (times and times[0] > LONG):
        time, _, result = sample(derive)
        times.append(time)
    return min(times), result
