"""A peer that is a program of its own and prints the result of a run as JSON."""

import json
import os
import subprocess


def run_binary(variable, *arguments):
    """Runs the program whose path is in an environment variable and returns the result that it prints.

    If it fails, raises a RuntimeError with its last message.
    """
    done = subprocess.run([os.environ[variable], *arguments], capture_output=True, text=True)
    if done.returncode < 0:
        raise RuntimeError(f"crashed by signal {-done.returncode}")
    if done.returncode:
        last = [line for line in done.stderr.splitlines() if line.strip() and "RUST_BACKTRACE" not in line]
        raise RuntimeError(last[-1] if last else f"exit code {done.returncode}")
    return json.loads(done.stdout)
