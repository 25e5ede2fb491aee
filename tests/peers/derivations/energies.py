"""The energies T, V, D and forces Q of a model, read from the file that gearsim derived from them.

So all tools derive the same system, and no formula is written twice. Constants and mid values stay symbols. Deflections and their
rates are replaced by their expressions; a rate has the same expression in the speeds, because deflections are linear in the
coordinates.
"""

import re
from dataclasses import dataclass
from pathlib import Path

WORDS = r" (where|without|in contact) "
GENERATED = Path(__file__).parents[3] / "gearsim/generated/src"


@dataclass
class Energies:
    """Expressions as texts, with ** for powers. `q` has the names of the coordinates; the names of their rates end in _dot."""

    q: list
    kinetic: str
    potential: str
    dissipation: str
    forces: list


def names(*texts):
    """The names of all symbols in texts."""
    return sorted(set(re.findall(r"[A-Za-z_]\w*", " ".join(texts))) - {"sqrt"})


def section(text, title):
    """The equations in a section of a derived file: left side to right side."""
    found = re.search(rf"^//! # {title}\n//!\n//! ```text\n(.*?)//! ```", text, re.S | re.M)
    lines = found[1].splitlines() if found else []
    lines = (line.removeprefix("//! ") for line in lines)
    pairs = (line.split(" = ", 1) for line in lines if " = " in line and line[0] != " ")
    return {name: re.sub(r" \[[a-z, ]*\]", "", value).replace("^", "**") for name, value in pairs}


def plain(text, title):
    """The equations in a section without play and transmission errors, which the other tools do not have.

    The section "Deflections" describes the symbols of play and of errors in words; the line of such a symbol begins with its value
    where the effect is absent.
    """
    described = {name: value for name, value in section(text, "Deflections").items() if re.search(WORDS, value)}
    absent = {name: re.match(r"\d+", value)[0] for name, value in described.items()}
    absent |= {f"d{name}": "0" for name in described}
    absent |= {name: "0" for value in described.values() for name in [*re.findall(r"with (\w+) = 0", value), "clip"]}

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
