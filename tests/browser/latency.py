"""Times from a slider's move to the redrawn page of `gearsim explore`: python tests/browser/latency.py GEARSIM > tests/latency.md

For each committed scene a row of the table, if its run takes less than 100 ms; `python tests/browser/latency.py GEARSIM two_stage ...` takes
some scenes. GEARSIM is a release build with the feature `html`. Needs what tests/browser/page.py needs. On a machine with other work, start it
by `chrt --rr 10`, so that the others wait.
"""

import pathlib
import statistics
import sys

from playwright.sync_api import sync_playwright

import common
from common import LAPTOP, SCENES, processor
from explore import opened, served, shown, slide

MOVES = 40
# Runs of this time [ms] and more are not drawn within it.
LIMIT = 100
# Places of a slider by which it moves at a time.
STEP = 2

HEAD = """# From a slider to the plots

`gearsim explore` draws a change within 100 ms where the run takes less. The table is written by

    cargo build --release --features html
    python tests/browser/latency.py target/release/gearsim > tests/latency.md

The time goes from the input event of a slider to the frame in which the plots on the screen have the new curves, in headless Chromium without a
graphics processor. "Run" is the processor time of the run. Other machines have other times; what is the program's own is the difference between the
two, and how many runs have room for it.

{processor}, Chromium {version}; {moves} moves of one slider in each scene.

| scene | slider | run [ms] | change to drawn, median [ms] | 90th percentile [ms] | median over run | answer of the server [ms] |
| --- | --- | ---: | ---: | ---: | ---: | ---: |"""


def moved(page, key, place):
    """Moves a slider: the time until what is seen is drawn, of which the answer of the server, and the run [ms]."""
    page.evaluate("performance.clearResourceTimings(); delete document.body.dataset.latency")
    slide(page, key, place)
    page.wait_for_selector("body[data-latency]")
    total = float(page.evaluate("document.body.dataset.latency"))
    answer = "performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('run')).map(({ duration }) => duration)[0]"
    return total, page.evaluate(answer), 1e3 * page.evaluate("seconds")


def settled(page):
    """Waits until what is not seen is drawn too."""
    page.wait_for_selector("body[data-whole]")


def moving(page):
    """A parameter that changes the end state, and a place of its slider from which it has room."""
    keys = page.evaluate("[...rows].filter(([key, { control }]) => !control.whole && !/^(run|output|start)[.]/.test(key)).map(([key]) => key)")
    before = shown(page)
    for key in sorted(keys, key=lambda key: not key.startswith("parameters.")):
        place = int(page.evaluate("(key) => rows.get(key).slider.value", key))
        place = place if place + MOVES * STEP < 1000 else place - MOVES * STEP
        allowed = []
        for end in (place + MOVES * STEP, place + STEP):
            moved(page, key, end)
            allowed.append(page.locator("body.old").count() == 0)
        if all(allowed) and shown(page) != before:
            return key, place
        page.locator("#reset").click()
        page.wait_for_timeout(200)
        settled(page)
    raise AssertionError("no parameter changes the end state")


def measured(browser, gearsim, scene):
    """The row of a scene; the time of its run alone where that is too long [ms]."""
    with served(gearsim, SCENES / f"{scene}.toml") as url, opened(browser, url, **LAPTOP) as page:
        settled(page)
        run = 1e3 * page.evaluate("seconds")
        if run >= LIMIT:
            return None, run
        key, place = moving(page)
        moves = []
        for i in range(MOVES + 3):
            moves.append(moved(page, key, place + STEP * (i % MOVES)))
            assert page.locator("body.old").count() == 0, f"{scene}: {key} has a mistake"
            # As a hand moves a slider: what is not seen follows only where it rests.
            page.wait_for_timeout(60)
    # The first moves compile the page's scripts.
    totals, answers, runs = (sorted(parts) for parts in zip(*moves[3:]))
    median, slow, run = statistics.median(totals), totals[int(0.9 * len(totals))], statistics.median(runs)
    name = key.removeprefix("parameters.")
    row = f"| {scene} | {name} | {run:.1f} | {median:.0f} | {slow:.0f} | {median / run:.1f} | {statistics.median(answers):.0f} |"
    return (row, median, slow), run


def main():
    gearsim = pathlib.Path(sys.argv[1]).resolve()
    every = sorted(str(path.relative_to(SCENES).with_suffix("")) for path in SCENES.rglob("*.toml"))
    with sync_playwright() as playwright:
        browser = common.started(playwright)
        print(HEAD.format(processor=processor(), version=browser.version, moves=MOVES), flush=True)
        rows, long = [], []
        for scene in sys.argv[2:] or every:
            row, run = measured(browser, gearsim, scene)
            if row:
                rows.append(row)
                print(row[0], flush=True)
            else:
                long.append(f"{scene} ({run:.0f} ms)")
        browser.close()
    within = [sum(row[i] <= LIMIT for row in rows) for i in (1, 2)]
    print(f"\nDrawn within {LIMIT} ms: {within[0]} of {len(rows)} scenes by the median, {within[1]} by the 90th percentile.")
    if long:
        print(f"Left out, because the run itself takes {LIMIT} ms or more: {', '.join(long)}.")


if __name__ == "__main__":
    main()
