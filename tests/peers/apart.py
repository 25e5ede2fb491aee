"""A run in a process of its own, with a limit of processor time. Processor time, because the machine may be busy with other
things. A failure or a crash there is reported and does not stop the other runs.
"""

import json
import resource
import signal
import subprocess


def apart(command, limit):
    """The JSON objects that a command prints, one per line, merged into one; with {"failed": reason} if it failed.

    `limit` is the processor time [s] after which the command is stopped.
    """
    limited = lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=limited)
    result = {}
    for line in done.stdout.splitlines():
        if line.startswith("{"):
            result |= json.loads(line)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return {**result, "failed": f"over {limit} s", "over": True}
    if done.returncode < 0:
        return {**result, "failed": f"crashed: {signal.Signals(-done.returncode).name}"}
    if done.returncode:
        lines = done.stderr.strip().splitlines()
        return {**result, "failed": lines[-1][:160] if lines else f"exit code {done.returncode}"}
    return result or {"failed": "printed no result"}
