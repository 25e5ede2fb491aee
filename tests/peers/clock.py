"""Processor time of a peer: what is prepared once (compiled, set up) apart from what a run costs."""

from time import process_time

SAMPLES = 15
"""Runs at most."""
ENOUGH = 1.0
"""Processor time after which no further run is begun, once there are three [s]."""
LONG = 3.0
"""A run that takes as long is not repeated [s]."""


def measure(prepare, solve):
    """Prepares once, solves several times: what the last run gave, with the times in `prepare` and `cpu`."""
    begun = process_time()
    prepared = prepare()
    setup = process_time() - begun
    times = []
    while True:
        begun = process_time()
        result = solve(prepared)
        times.append(process_time() - begun)
        repeated = len(times) >= 3 and (sum(times) > ENOUGH or len(times) == SAMPLES)
        if repeated or times[0] > LONG:
            return {**result, "prepare": setup, "cpu": times}


def least(derive):
    """The least processor time of three runs (of one that takes long), and what the last gave."""
    times = []
    while len(times) < 3 and not (times and times[0] > LONG):
        begun = process_time()
        result = derive()
        times.append(process_time() - begun)
    return min(times), result
