"""Times of a page of a million rows: python tests/browser/large.py GEARSIM > tests/large_page.md

GEARSIM is a release build with the feature `html`. Needs what tests/browser/page.py needs, which tests the counts that these times follow from. On a
machine with other work, start it by `chrt --rr 10`, so that the others wait.
"""

import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

from playwright.sync_api import sync_playwright

import common
from common import LAPTOP, SCENES, processor

SCENE = ["oh2005/spectrum_4500rpm_exact", "run.t_end=1 s", "output.rate=1 MHz"]
OPENINGS = 5
STEPS = 12

TEXT = """# A page of a million rows

A run of 1e6 samples opens in under 3 s and stays smooth. The table is written by

    cargo build --release --features html
    python tests/browser/large.py target/release/gearsim > tests/large_page.md

It is the page of `{scene}`: {rows} rows in {columns} columns, in headless Chromium {version} without a graphics processor on
{processor}. Times are medians, the longest in brackets.

| what | measured |
| --- | ---: |
| the page | {size:.0f} MB, of which plotly.js {library:.1f} MB |
| bytes of a number in the page | {bytes:.2f} |
| processor time of the run without the page | {without:.1f} s |
| processor time that the page adds | {added:.1f} s |
| from opening to the first text | {text} ms |
| from opening to all plots in sight drawn | {drawn} ms |
| a step of zooming or moving the view, to the frame with it | {zoom} ms |
| a step of the cursor, to the frame with it | {cursor} ms |
| all detail after the last step, to the frame with it | {detail} ms |
| points drawn of a curve, at most | {points} |"""

# The time from a change to the frame with it.
FRAME = """async () => {
    const begin = performance.now();
    CHANGE;
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    const time = performance.now() - begin;
    await new Promise((done) => setTimeout(done, 30));
    return time;
}"""


def run(gearsim, folder, *more):
    """Runs the scene; its processor time [s]."""
    name, *sets = SCENE
    arguments = [argument for value in ["output.plots=[]", *sets] for argument in ("--set", value)]
    used = lambda: resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime + resource.getrusage(resource.RUSAGE_CHILDREN).ru_stime
    before = used()
    subprocess.run([gearsim, "run", SCENES / f"{name}.toml", "-q", "--out", folder, *arguments, *more], check=True)
    return used() - before


def opened(browser, path):
    """Opens the page: times to its first text and to its plots [ms], and the page."""
    page = browser.new_context(offline=True, **LAPTOP).new_page()
    page.goto(path.as_uri(), wait_until="commit")
    page.wait_for_selector("body[data-ready]")
    seen = "panels.filter((panel) => panel.inSight && panel.shown.some((shown) => shown))"
    drawn = f"() => {seen}.length > 0 && {seen}.every((panel) => panel.drawn) ? performance.now() : 0"
    while not (time := page.evaluate(drawn)):
        page.wait_for_timeout(5)
    return page.evaluate("performance.getEntriesByName('first-contentful-paint')[0].startTime"), time, page


def said(times):
    return f"{statistics.median(times):.0f} ({max(times):.0f})"


def main():
    gearsim = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        folder = pathlib.Path(folder)
        without = run(gearsim, folder / "without")
        added = run(gearsim, folder / "page", "--html") - without
        path = folder / "page" / "page.html"
        browser = common.started(playwright)
        texts, plots = [], []
        for _ in range(OPENINGS):
            text, drawn, page = opened(browser, path)
            texts.append(text)
            plots.append(drawn)
            if len(plots) < OPENINGS:
                page.context.close()
        page.evaluate("document.querySelector('figure.plot').scrollIntoView()")
        common.settle(page)
        frame = lambda change: page.evaluate(FRAME.replace("CHANGE", change))
        steps = ["panels[0].group.zoom(0.7)"] * (STEPS // 2) + ["panels[0].group.pan(0.25)"] * (STEPS // 2)
        zooms = [frame(step) for step in steps]
        detail = [frame("panels[0].group.draw(1)") for _ in range(OPENINGS)]
        points = page.evaluate("Math.max(...panels.filter((p) => p.drawn).flatMap((p) => p.canvas.data.filter((t) => t.name !== 'events').map((t) => t.x.length)))")
        cursors = [frame(f"panels[0].group.point(panels[0].group.range[0] + {i / STEPS} * (panels[0].group.range[1] - panels[0].group.range[0]))") for i in range(STEPS)]
        rows = page.evaluate("panels[0].plot.curves[0].x.length")
        arrays = page.evaluate("[...document.querySelectorAll('script[type=\"text/plain\"]')].map((array) => array.textContent.length)")
        columns = page.evaluate("new Set(panels.flatMap((p) => p.plot.curves.map(({ y }) => y)).filter(({ length }) => length === panels[0].plot.curves[0].x.length).map(({ id }) => id)).size")
        numbers = page.evaluate("[...new Map(panels.flatMap((p) => p.plot.curves.flatMap(({ x, y }) => [x, y])).map((c) => [c.id, c.length])).values()].reduce((a, b) => a + b)")
        library = max(page.evaluate("[...document.scripts].map((script) => script.type ? 0 : script.textContent.length)"))
        print(TEXT.format(
            scene=" ".join([SCENE[0], *(f'--set "{value}"' for value in SCENE[1:])]), rows=rows, columns=columns, version=browser.version, processor=processor(),
            size=path.stat().st_size / 1e6, library=library / 1e6, bytes=0.75 * sum(arrays) / numbers, without=without, added=added,
            text=said(texts), drawn=said(plots), zoom=said(zooms), detail=said(detail), cursor=said(cursors), points=points,
        ))
        browser.close()


if __name__ == "__main__":
    main()
