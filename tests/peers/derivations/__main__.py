"""One derivation, printed as lines of JSON as soon as each figure is known: MODEL TOOL METHOD."""

import json
import sys

from derivations import tool
from derivations.energies import read

model, name, method = sys.argv[1:]
run = tool(name).run
for part in run(model) if name == "gearsim" else run(read(model), method):
    print(json.dumps(part), flush=True)
