"""A run in a process of its own, with a limit of time: what fails or crashes there is told, and goes no further."""

import json
import signal
import subprocess


def apart(command, limit):
    """The JSON that a command prints; {"failed": reason} where there is none."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return {"failed": f"over {limit} s", "over": True}
    if done.returncode < 0:
        return {"failed": f"crashed: {signal.Signals(-done.returncode).name}"}
    if done.returncode:
        lines = done.stderr.strip().splitlines()
        return {"failed": lines[-1][:160] if lines else f"exit code {done.returncode}"}
    try:
        return json.loads(done.stdout.strip().splitlines()[-1])
    except (IndexError, ValueError):
        return {"failed": "printed no result"}
