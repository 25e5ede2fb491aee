"""Times from a slider's move to the redrawn page of `gearsim explore`: python tests/browser/latency.py GEARSIM > tests/latency.md

For each committed scene a row of the table, if its run takes less than 2 s; `python tests/browser/latency.py GEARSIM two_stage ...` takes
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
# Number of moves while another section of the page is on the screen, and the identifiers of these sections. A change then needs all rows of
# the run, and their transforms.
MOVES_ELSEWHERE = 20
ELSEWHERE = ["orders", "spectra"]
# Moves before those that count: the first ones compile the page's scripts.
FIRST = 3
# A change is to be drawn within this time [ms].
LIMIT = 100
# Runs of this time [ms] and more are left out.
LONGEST = 2000
# Number of places by which a slider moves at a time.
STEP = 2

HEAD = """# From a slider to the plots

`gearsim explore` is meant to draw a change within 100 ms; how many scenes it does is below. If the run takes longer than 55 ms, it draws the beginning of the curves over time first, and the whole
when the slider rests. The table is written by

    cargo build --release --features html
    python tests/browser/latency.py target/release/gearsim > tests/latency.md

The time goes from the input event of a slider to the frame in which the plots on the screen have the new curves, in headless Chromium without a
graphics processor. "Run" is the processor time of the first run. "Drawn" is the median share of the run whose curves are on the screen at that time.
Other machines have other times; what is the program's own is the difference between the run and the time until it is drawn. Some 20 to 30 ms pass
beside the run: 5 ms in the server, 5 to 10 ms between browser and server, 7 ms in the page, and on the average half of the 16 ms between two frames.
The last two columns are medians while the section with orders or with spectra is on the screen instead of the motion. The whole run is then
transformed again for each change, and a long one is drawn when it has ended.

{processor}, Chromium {version}; {moves} moves of one slider in each scene, {elsewhere} in each of the last two columns.

| scene | slider | run [ms] | change to drawn, median [ms] | 90th percentile [ms] | drawn | answer of the server [ms] | orders in view [ms] | spectra in view [ms] |
| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"""


def moved(page, key, place):
    """Moves a slider: the time until what is seen is drawn, of which the answer of the server [ms], and the share of the run that is drawn then."""
    page.evaluate("performance.clearResourceTimings(); delete document.body.dataset.latency; delete document.body.dataset.shown; delete document.body.dataset.whole")
    began = page.evaluate("performance.now()")
    slide(page, key, place)
    page.wait_for_selector("body[data-latency][data-shown]")
    total, share = (float(page.evaluate(f"document.body.dataset.{name}")) for name in ("latency", "shown"))
    answer = "performance.getEntriesByType('resource').find(({ name, startTime }) => name.endsWith('run') && startTime >= began)?.duration"
    # The performance entry of an answer may appear later than the answer.
    return total, page.wait_for_function(f"(began) => {answer}", arg=began).json_value(), share


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
            settled(page)
            allowed.append(page.locator("body.old").count() == 0)
        if all(allowed) and shown(page) != before:
            return key, place
        page.locator("#reset").click()
        page.wait_for_timeout(200)
        settled(page)
    raise AssertionError("no parameter changes the end state")


def moves(page, scene, key, place, count):
    """Moves a slider so many times, as a hand does: what is not seen follows only where it rests. What `moved` gives of each move."""
    all = []
    for i in range(count + FIRST):
        all.append(moved(page, key, place + STEP * (i % MOVES)))
        assert page.locator("body.old").count() == 0, f"{scene}: {key} has a mistake"
        page.wait_for_timeout(60)
    return all[FIRST:]


def elsewhere(page, section, scene, key, place):
    """The median while a section is on the screen; None if the run has no plots there [ms]."""
    page.wait_for_timeout(300)
    settled(page)
    if page.locator(f"#{section} figure.plot").count() == 0:
        return None
    page.evaluate("(id) => document.getElementById(id).scrollIntoView()", section)
    common.wait_until(page, "panels.filter(onScreen).every(({ drawn, frame }) => drawn || frame.hidden)")
    return statistics.median(total for total, *_ in moves(page, scene, key, place, MOVES_ELSEWHERE))


def measured(browser, gearsim, scene):
    """The row of a scene, with its median, its 90th percentile and its medians elsewhere; and the time of its run alone [ms]."""
    with served(gearsim, SCENES / f"{scene}.toml") as url, opened(browser, url, **LAPTOP) as page:
        settled(page)
        run = 1e3 * page.evaluate("seconds")
        if run >= LONGEST:
            return None, run
        key, place = moving(page)
        here = moves(page, scene, key, place, MOVES)
        others = [elsewhere(page, section, scene, key, place) for section in ELSEWHERE]
    totals, answers, shares = (sorted(parts) for parts in zip(*here))
    median, slow = statistics.median(totals), totals[int(0.9 * len(totals))]
    name = key.removeprefix("parameters.")
    row = f"| {scene} | {name} | {run:.1f} | {median:.0f} | {slow:.0f} | {100 * statistics.median(shares):.0f} % | {statistics.median(answers):.0f} |"
    row += "".join(" - |" if other is None else f" {other:.0f} |" for other in others)
    return (row, [median, slow, *others]), run


def main():
    gearsim = pathlib.Path(sys.argv[1]).resolve()
    every = sorted(str(path.relative_to(SCENES).with_suffix("")) for path in SCENES.rglob("*.toml"))
    with sync_playwright() as playwright:
        browser = common.started(playwright)
        print(HEAD.format(processor=processor(), version=browser.version, moves=MOVES, elsewhere=MOVES_ELSEWHERE), flush=True)
        rows, long = [], []
        for scene in sys.argv[2:] or every:
            row, run = measured(browser, gearsim, scene)
            if row:
                rows.append(row)
                print(row[0], flush=True)
            else:
                long.append(f"{scene} ({run:.0f} ms)")
        browser.close()
    # A column has only the scenes that have the plots in question.
    assert rows, f"every run takes {LONGEST} ms or more"
    columns = [[time for time in column if time is not None] for column in zip(*(times for _, times in rows))]
    within = [f"{sum(time <= LIMIT for time in column)} of {len(column)}" for column in columns]
    print(f"\nDrawn within {LIMIT} ms: {within[0]} scenes by the median, {within[1]} by the 90th percentile; with orders in view {within[2]}, with spectra {within[3]}.")
    if long:
        print(f"Left out, because the run takes {LONGEST} ms or more: {', '.join(long)}.")


if __name__ == "__main__":
    main()
