"""`python -m gearsim`: the command line."""

from gearsim import _command_line

_command_line()
