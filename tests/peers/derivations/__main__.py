"""One derivation, as JSON: MODEL TOOL METHOD."""

import json
import sys

from derivations import tool
from derivations.energies import read

model, name, method = sys.argv[1:]
run = tool(name).run
print(json.dumps(run(model) if name == "gearsim" else run(read(model), method)))
