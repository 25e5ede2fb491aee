"""Times from a slider's move to the redrawn page of `gearsim explore`: python tests/browser/latency.py GEARSIM [SCENE...]

For each scene a table row: of the moves of one slider the median and the worst time, and of the median move its parts: the answer of the
server, of which the run, and the drawing. GEARSIM is a release build with the feature `html`. Needs what tests/browser/page.py needs.
"""

import pathlib
import statistics
import sys

from playwright.sync_api import sync_playwright

import common
from common import LAPTOP, SCENES
from explore import opened, served, slide

# Each with a parameter that changes its motion.
DEFAULT = {"oh2005/energy_300rpm": "zeta", "gear_pair_shafts": "I_m", "two_stage": "T_motor", "backlash": "T0", "planetary_errors": "beta_K"}
MOVES = 40


def moved(page, key, place):
    """Moves a slider. The time until what is seen is drawn [ms]."""
    page.evaluate("delete document.body.dataset.latency")
    slide(page, key, place)
    page.wait_for_selector("body[data-latency]")
    return float(page.evaluate("document.body.dataset.latency"))


def measured(browser, gearsim, scene, parameter):
    with served(gearsim, SCENES / f"{scene}.toml") as url, opened(browser, url, **LAPTOP) as page:
        key = f"parameters.{parameter}"
        moves = []
        for i in range(MOVES + 3):
            page.evaluate("performance.clearResourceTimings()")
            total = moved(page, key, 300 + 10 * i)
            answer = "performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('run')).map(({ duration }) => duration)[0]"
            moves.append((total, page.evaluate(answer), page.locator("#time").text_content()))
            # As a hand moves a slider: judging begins only where it rests.
            page.wait_for_timeout(60)
        # The first moves compile the page's scripts.
        moves = sorted(moves[3:])
        total, answer, run = moves[len(moves) // 2]
        print(f"| {scene} | {parameter} | {statistics.median(m[0] for m in moves):.0f} | {moves[-1][0]:.0f} | {answer:.0f} | {run} | {total - answer:.0f} |", flush=True)


def main():
    gearsim = pathlib.Path(sys.argv[1]).resolve()
    wanted = dict(name.split(":") for name in sys.argv[2:]) or DEFAULT
    print("| scene | slider | median [ms] | worst [ms] | answer [ms] | run | drawing [ms] |\n| --- | --- | ---: | ---: | ---: | ---: | ---: |")
    with sync_playwright() as playwright:
        browser = common.started(playwright)
        for scene, parameter in wanted.items():
            measured(browser, gearsim, scene, parameter)
        browser.close()


if __name__ == "__main__":
    main()
