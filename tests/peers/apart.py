"""A run in a process of its own, with a limit of processor time (the machine may be busy with other things): what fails
or crashes there is told, and goes no further.
"""

import json
import resource
import signal
import subprocess


def apart(command, limit):
    """The JSON that a command prints; {"failed": reason} where there is none."""
    limited = lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=limited)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
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
