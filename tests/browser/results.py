"""Tests of the pages of commands other than run in headless Chromium: python tests/browser/results.py GEARSIM

GEARSIM is the program built with the feature `html`. Needs what page.py needs. Every page is opened from its file and without network; any
console message fails its test. What a page plots is compared with the files that the command writes beside it.
"""

import csv
import json
import math
import pathlib
import subprocess

import common
from common import LAPTOP, PHONE, SCENES, opened_file, settle, wait_until

PAIR = SCENES / "oh2005" / "energy_300rpm.toml"
HOSTILE = "<img src=x onerror=document.body.dataset.hurt=1> \"a\" 'b'"
# The curves of a page are embedded to 1/131,000 of the range of a block.
DIGITS = 1e-4

COMMANDS = {
    "work-precision": [PAIR, "--repetitions", "1", "--set", "run.t_end=20 ms"],
    "response": [SCENES / "response.toml", "--over", "start.speed=2400 rpm:4000 rpm:5", "--settle", "5 ms", "--output", "dte_12", "--set", "run.t_end=10 ms"],
    "modes": [SCENES / "two_stage.toml"],
    "floquet": [PAIR, "--vary", "start.speed=4000 rpm:14000 rpm:41"],
    "compare": [PAIR, "--set", "output.csv=true"],
    "advise": [PAIR],
    "sweep": [PAIR, "--vary", "parameters.T0=1 N*m:100 N*m:6", "--vary", "start.speed=log:100 rpm:6000 rpm:5", "--csv", "--map", "residual"],
}


def result(gearsim, command, folder, *more):
    """Runs a command, and returns the folder of its result."""
    arguments = [gearsim, command, *COMMANDS[command], *more, "--html", "-q", "--out", folder]
    subprocess.run(list(map(str, arguments)), check=True)
    return folder


def rows(path):
    """The rows of a CSV file, by the names of its columns without their units."""
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def curve(page, name, panel=0):
    """The points of a curve of a plot as embedded, without logarithms."""
    x, y = page.evaluate(
        """([panel, name]) => {
            const { x, y, curves } = panels[panel].plot;
            const curve = curves.find((curve) => curve.name === name);
            const numbers = (of, axis) => Array.from(column(of).values, (value) => axis.log ? 10 ** value : value);
            return [numbers(curve.x, x), numbers(curve.y, y)];
        }""",
        [panel, name],
    )
    return list(zip(x, y))


def agree(points, expected, what):
    """Whether points are those of a file, within the digits that a page embeds."""
    assert len(points) == len(expected) > 0, (what, len(points), len(expected))
    for k in range(2):
        size = max(abs(value[k]) for value in expected)
        wrong = [(a, b) for a, b in zip(points, expected) if not abs(a[k] - b[k]) <= DIGITS * max(size, 1e-300)]
        assert not wrong, (what, wrong[:3])


def named(row, name):
    """The number in the column called `name`, whose head may have a unit."""
    return float(next(text for key, text in row.items() if key.split(" [")[0] == name) or "nan")


def work_precision(page, folder):
    found = [row for row in rows(folder / "work_precision.csv") if row["method"].startswith("explicit, order 5")]
    points = [(float(row["cpu_min_s"]), float(row["error_path"])) for row in found if not row["failure"]]
    name = found[0]["method"]
    drawn = curve(page, name)
    assert len(drawn) > 5
    for x, y in drawn:
        # Errors below the error of the reference are drawn at the error of the reference.
        assert any(abs(x / a - 1) < 1e-3 and (abs(y / b - 1) < 1e-3 or y > b) for a, b in points), (x, y, points)


def response(page, folder):
    up = [row for row in rows(folder / "response.csv") if row.get("way", row.get("direction", "up")).startswith("up")]
    values = [named(row, "dte_12_rms") for row in up]
    drawn = [y for _, y in curve(page, "upward")]
    scale = drawn[0] / values[0]
    assert math.isclose(scale, 10 ** round(math.log10(scale)), rel_tol=1e-3), scale
    agree([(0, y) for y in drawn], [(0, scale * y) for y in values], "response")


def modes(page, folder):
    chosen = json.loads((folder / "modes.json").read_text())["chosen"]
    table = page.locator("#modes table")
    shown = [float(cell.get_attribute("data-value")) for cell in table.locator("tbody tr td:nth-child(2)").all()]
    assert shown == [mode["natural_frequency"] for mode in chosen["modes"]]
    first = next(mode for mode in chosen["modes"] if mode["natural_frequency"] > 0)
    drawn = page.evaluate("panels[0].plot.curves.filter((c) => c.name).map((c) => Array.from(column(c.y).values).filter((y) => y !== 0 && !Number.isNaN(y)))")
    shares = sorted(100 * abs(share) for share in first["kinetic_energy"] if abs(share) > 0.02)
    kinetic = sorted(abs(y) for y in drawn[0])
    assert all(any(abs(share - y) < 0.05 for y in kinetic) for share in shares), (shares, kinetic)


def floquet(page, folder):
    chart = rows(folder / "stability.csv")
    expected = [named(row, "growth_per_period") for row in chart]
    index = page.evaluate("panels.findIndex(({ plot }) => plot.group === 'stability')")
    agree([(0, y) for _, y in curve(page, "above 0: a disturbance grows", index)], [(0, y) for y in expected], "floquet")
    multipliers = json.loads((folder / "floquet.json").read_text())["multipliers"]
    agree(curve(page, "multipliers"), sorted(map(tuple, multipliers), key=lambda z: z[0]), "multipliers")
    # Both axes of the complex plane have the same scale.
    scales = page.evaluate("[panels[0].canvas._fullLayout.xaxis, panels[0].canvas._fullLayout.yaxis].map((axis) => Math.abs(axis._m))")
    assert abs(scales[0] / scales[1] - 1) < 1e-3, scales


def compare(page, folder):
    index = page.evaluate("panels.findIndex(({ plot }) => plot.title.startsWith('energy U'))")
    for suffix, label in (("exact", "exact"), ("classical", "classical")):
        table = rows(folder / f"trajectory_{suffix}.csv")
        agree(curve(page, label, index), [(named(row, "t"), named(row, "energy")) for row in table], label)


def advise(page, folder):
    candidates = json.loads((folder / "advise.json").read_text())["candidates"]
    speeds = [candidate["truth"]["speed"] for candidate in candidates if candidate["truth"]]
    table = page.locator("#deviations table")
    column = next(i for i, head in enumerate(table.locator("th").all_text_contents(), 1) if head == "speed")
    shown = [cell.get_attribute("data-value") for cell in table.locator(f"tbody tr td:nth-child({column})").all()]
    assert all(any(math.isclose(float(text), speed, rel_tol=1e-12, abs_tol=1e-300) for text in shown) for speed in speeds), (speeds, shown)
    assert page.evaluate("panels[0].plot.x.names.length") == len(candidates)


def sweep(page, folder):
    table = rows(folder / "sweep.csv")
    assert len(table) == 30
    assert page.locator("#points tbody tr").count() == 30
    page.locator("figure.map").first.scroll_into_view_if_needed()
    page.wait_for_selector("figure.map .main-svg")
    # The middle of each cell is a point of the sweep, and has its value.
    cells = page.evaluate(
        """maps[0].canvas.data[0].z.flatMap((row, j) => row.map((_, i) => maps[0].at({ pointIndex: [j, i] })))"""
    )
    logarithmic = page.evaluate("maps[0].map.colour.log")
    expected = {(named(row, "parameters.T0"), named(row, "start.speed")): named(row, "residual") for row in table}
    size = max(map(abs, expected.values()))
    scale = [max(abs(key[k]) for key in expected) / max(abs(cell[k]) for cell in cells) for k in range(2)]
    assert len(cells) == len(expected)
    for x, y, value in cells:
        near = min(expected, key=lambda key: abs(key[0] / scale[0] / x - 1) + abs(key[1] / scale[1] / y - 1))
        assert abs(near[0] / scale[0] / x - 1) < 1e-6 and abs(near[1] / scale[1] / y - 1) < 1e-6, (near, x, y)
        value = 10**value if logarithmic else value
        assert abs(value - expected[near]) <= DIGITS * size, (value, expected[near])
    box = page.locator("figure.map .nsewdrag").bounding_box()
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    settle(page)
    wait_until(page, "maps[0].readout.textContent.includes('J')")
    before = page.evaluate("maps[0].canvas._fullLayout.xaxis.range")
    page.locator("figure.map").get_by_role("button", name="Zoom in").click()
    settle(page)
    after = page.evaluate("maps[0].canvas._fullLayout.xaxis.range")
    assert abs((after[1] - after[0]) / (before[1] - before[0]) - 0.5) < 1e-6, (before, after)
    page.locator("figure.map").get_by_role("button", name="Show all").click()
    settle(page)
    assert page.evaluate("maps[0].canvas._fullLayout.xaxis.range") == before


CHECKS = {"work-precision": work_precision, "response": response, "modes": modes, "floquet": floquet, "compare": compare, "advise": advise, "sweep": sweep}


def shows_what_the_files_say(browser, folder, command):
    with opened_file(browser, folder / "page.html", **LAPTOP) as page:
        CHECKS[command](page, folder)


def zooms(browser, folder):
    """A key zooms a plot by two and 0 shows all again; a drag does the same."""
    with opened_file(browser, folder / "page.html", **LAPTOP) as page:
        frame = page.locator("figure.plot .frame").first
        frame.scroll_into_view_if_needed()
        settle(page)
        first = page.evaluate("panels[0].group.range")
        frame.focus()
        page.keyboard.press("+")
        settle(page)
        begin, end = page.evaluate("panels[0].group.range")
        assert abs((end - begin) / (first[1] - first[0]) - 0.5) < 1e-6, (first, begin, end)
        shown = page.evaluate("panels[0].canvas._fullLayout.xaxis.range")
        assert all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12) for a, b in zip(shown, (begin, end))), (shown, begin, end)
        page.keyboard.press("0")
        settle(page)
        box = page.locator("figure.plot .nsewdrag").first.bounding_box()
        middle = box["y"] + box["height"] / 2
        page.mouse.move(box["x"] + 0.25 * box["width"], middle)
        page.mouse.down()
        page.mouse.move(box["x"] + 0.75 * box["width"], middle, steps=3)
        page.mouse.up()
        settle(page)
        begin, end = page.evaluate("panels[0].group.range")
        all_of_it = page.evaluate("panels[0].group.all")
        assert 0.4 < (end - begin) / (all_of_it[1] - all_of_it[0]) < 0.6, (begin, end)


def tables_sort(browser, folder):
    """Each table is sorted by a column of numbers when its head is pressed."""
    with opened_file(browser, folder / "page.html", **LAPTOP) as page:
        tables = page.locator("table.sortable").all()
        assert tables
        for table in tables:
            for i in page.evaluate("(table) => [...table.tHead.rows[0].cells].flatMap((head, i) => head.matches('.number') ? [i + 1] : [])", table.element_handle()):
                table.locator(f"th:nth-child({i}) button").click()
                texts = [cell.get_attribute("data-value") for cell in table.locator(f"tbody tr td:nth-child({i})").all()]
                numbers = [float(text) for text in texts if text is not None and text != "NaN"]
                assert len(texts) > 0 and (None in texts or numbers == sorted(numbers)), numbers[:5]
                break


def orders_have_their_own_labels(browser, path, settings):
    """The orders at the ends of the lines of a Campbell diagram cover none of one another and are within the page, however narrow it is."""
    boxes = """() => panels.filter(({ plot }) => plot.curves.some(({ note }) => note)).map(({ canvas }) =>
        [...canvas.querySelectorAll(".annotation-text-g")].map((part) => part.getBoundingClientRect()).map(({ left, top, right, bottom }) => [left, top, right, bottom]))"""
    with opened_file(browser, path, **settings) as page:
        index = page.evaluate("panels.findIndex(({ plot }) => plot.curves.some(({ note }) => note))")
        figure = page.locator("figure.plot").nth(index)
        figure.scroll_into_view_if_needed()
        figure.locator(".main-svg").first.wait_for()
        (labels,) = page.evaluate(boxes)
        assert len(labels) > 8, labels
        for i, (left, top, right, bottom) in enumerate(labels):
            assert 0 <= left and right <= settings["viewport"]["width"], labels[i]
            apart = [right <= other[0] + 1 or other[2] <= left + 1 or bottom <= other[1] + 1 or other[3] <= top + 1 for other in labels[:i]]
            assert all(apart), (labels[i], labels[:i])


def fits(browser, path, settings, scheme, pictures):
    """Every plot and map is drawn when it is in sight, and nothing is wider than the screen."""
    with opened_file(browser, path, color_scheme=scheme, **settings) as page:
        for figure in page.locator("figure.plot, figure.map").all():
            figure.scroll_into_view_if_needed()
            figure.locator(".main-svg").first.wait_for()
        assert page.evaluate("document.documentElement.scrollWidth") <= settings["viewport"]["width"]
        for section in ("scene", "provenance"):
            assert page.locator(f"section#{section}").count() == 1
        if pictures:
            page.evaluate("scrollTo(0, 0)")
            page.screenshot(path=pictures / f"{path.parent.name}_{settings['viewport']['width']}_{scheme}.png", full_page=True)


def hostile_names_stay_text(browser, gearsim, command, folder):
    """HTML and script ends in the name and in the text of a scene are shown, and not executed."""
    lines = [line for line in pathlib.Path(COMMANDS[command][0]).read_text().splitlines() if not line.startswith("about")]
    scene = folder / f"{HOSTILE}.toml"
    scene.write_text("\n".join(['about = "</script><script>document.body.dataset.hurt=2</script><b>bold</b>"', "# --> </title></style>", *lines]))
    arguments = [gearsim, command, scene, *COMMANDS[command][1:], "--html", "-q", "--out", folder / f"hostile_{command}"]
    subprocess.run(list(map(str, arguments)), check=True)
    with opened_file(browser, folder / f"hostile_{command}" / "page.html", **LAPTOP) as page:
        for figure in page.locator("figure.plot, figure.map").all():
            figure.scroll_into_view_if_needed()
            figure.locator(".main-svg").first.wait_for()
        assert page.evaluate("document.body.dataset.hurt") is None
        assert page.locator("h1").text_content() == HOSTILE
        assert page.locator("main img, main b, main script:not([type])").count() == 0
        assert "</title></style>" in page.locator("#scene code").first.text_content()


def tests(gearsim, folder, pictures):
    for command in COMMANDS:
        there = result(gearsim, command, folder / command)
        yield shows_what_the_files_say, (there, command), command
        yield tables_sort, (there,), command
        if command != "sweep":
            yield zooms, (there,), command
        yield from common.screens(fits, there / "page.html", pictures)
        if command == "modes":
            for size in (LAPTOP, PHONE):
                yield orders_have_their_own_labels, (there / "page.html", size), command
        yield hostile_names_stay_text, (gearsim, command, folder), command


common.run_tests(tests)
