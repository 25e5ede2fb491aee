"""Rust crates that locate events: diffsol and ivp. Their programs, with what was done to be fair, are in `rust/src`."""

from .binary import run_binary

METHODS = ["diffsol tsit45", "diffsol bdf", "ivp DOP853", "ivp DOPRI5"]
TOLERANCES = [1e-6, 1e-9, 1e-12]


def version():
    return run_binary("PEERS_RUST", "versions")


def run(scene, method, tolerance):
    return run_binary("PEERS_RUST", scene.file, scene.name, method, str(tolerance))
