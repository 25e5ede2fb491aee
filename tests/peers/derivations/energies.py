"""The energies T, V, D and forces Q of a model, read from the file that gearsim derived from them.

So that all tools derive the same system, and no formula is typed twice. Constants stay symbols, mid values too; a
deflection is put in where it stands, and its rate likewise, since deflections are linear in the coordinates.
"""

import re
from dataclasses import dataclass
from pathlib import Path

WORDS = r" (where|without|in contact) "
GENERATED = Path(__file__).parents[3] / "gearsim/src/generated"


@dataclass
class Energies:
    """Texts with ** for powers; `q` are the names of the coordinates, their rates end in _dot."""

    q: list
    kinetic: str
    potential: str
    dissipation: str
    forces: list


def names(*texts):
    """The names of all symbols in texts."""
    return sorted(set(re.findall(r"[A-Za-z_]\w*", " ".join(texts))) - {"sqrt"})


def section(text, title):
    """The plain lines of a section of a derived file, by what stands before =."""
    found = re.search(rf"^//! # {title}\n//!\n//! ```text\n(.*?)//! ```", text, re.S | re.M)
    lines = found[1].splitlines() if found else []
    lines = (line.removeprefix("//! ") for line in lines)
    pairs = (line.split(" = ", 1) for line in lines if " = " in line and line[0] != " ")
    return {name: re.sub(r" \[[a-z, ]*\]", "", value).replace("^", "**") for name, value in pairs}


def plain(text, title):
    """The same without play and transmission errors, which other tools do not know: what is told of them in words among the
    deflections has the number that its line begins with."""
    told = {name: value for name, value in section(text, "Deflections").items() if re.search(WORDS, value)}
    absent = {name: re.match(r"\d+", value)[0] for name, value in told.items()}
    absent |= {f"d{name}": "0" for name in told}
    absent |= {name: "0" for value in told.values() for name in [*re.findall(r"with (\w+) = 0", value), "clip"]}

    def put(value):
        return re.sub(r"\b(" + "|".join(absent) + r")\b", lambda found: absent[found[0]], value) if absent else value

    return {name: put(value) for name, value in section(text, title).items() if not re.search(WORDS, value)}


def read(model):
    """The energies of a model; None if it was not derived in this checkout."""
    path = GENERATED / f"{model}.rs"
    if not path.exists():
        return None
    text = path.read_text()
    given, deflections = plain(text, "Energies"), plain(text, "Deflections")
    q = [name.removeprefix("Q_") for name in given if name.startswith("Q_")]
    for name, value in deflections.items():
        rate = re.sub(r"\b(" + "|".join(q) + r")\b", r"\1_dot", value)
        for energy in ("T", "V", "D"):
            put_in = re.sub(rf"\b{name}_dot\b", f"({rate})", given.get(energy, "0"))
            given[energy] = re.sub(rf"\b{name}\b", f"({value})", put_in)
    forces = [given[f"Q_{name}"] for name in q]
    return Energies(q, given["T"], given["V"], given.get("D", "0"), forces)
