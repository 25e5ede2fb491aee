"""Tests of interactive pages in headless Chromium: python tests/browser/page.py GEARSIM

GEARSIM is the program built with the feature `html`. Needs the Python package in requirements.txt, and Chromium as /usr/bin/chromium or as
the path in CHROMIUM. Every page is opened from its file and without network; any console message of a level above "info" fails its test.
"""

import math
import subprocess

import common
from common import LAPTOP, PHONE, SCENES, opened_file, settle, wait_until

# A file name with HTML and quotes.
HOSTILE = "<img src=x onerror=document.body.dataset.hurt=1> \"a\" 'b' \u2028"


def run(gearsim, scene, folder, *sets):
    """Runs a scene, and returns the path of its page."""
    arguments = [argument for value in sets for argument in ("--set", value)]
    subprocess.run([gearsim, "run", scene, "--html", "-q", "--out", folder, "--set", "output.plots=[]", *arguments], check=True)
    return folder / "page.html"


def drawn(page, panel=0):
    """Abscissae of the points drawn of the first curve of a plot."""
    return page.evaluate(f"Array.from(panels[{panel}].canvas.data[0].x)")


def frame_of_first_plot(page):
    """The place of the frame of the first plot on the screen, in which it is scrolled into sight."""
    page.locator("figure.plot").first.scroll_into_view_if_needed()
    settle(page)
    return page.locator(".nsewdrag").first.bounding_box()


def zoom_shows_detail(browser, path, samples):
    """A drag zooms all time plots alike, and shows every row once they are few; a double click shows all again."""
    with opened_file(browser, path, **LAPTOP) as page:
        total = page.evaluate("column(panels[0].plot.curves[0].x).values.length")
        assert total >= samples, (total, samples)
        settle(page)
        before = drawn(page)
        assert len(before) < 5000
        box = frame_of_first_plot(page)
        for _ in range(14):
            if len(drawn(page)) < 1000:
                break
            middle = box["y"] + box["height"] / 2
            page.mouse.move(box["x"] + 0.45 * box["width"], middle)
            page.mouse.down()
            page.mouse.move(box["x"] + 0.62 * box["width"], middle, steps=3)
            page.mouse.up()
            settle(page)
        after, (start, end) = drawn(page), page.evaluate("panels[0].group.range")
        inside = page.evaluate("(([a, b]) => column(panels[0].plot.curves[0].x).values.filter((t) => t >= a && t <= b).length)(panels[0].group.range)")
        assert len([t for t in after if start <= t <= end]) == inside > 10, (len(after), inside)
        # The other plots of the group follow.
        others = page.evaluate("panels.filter((p) => p.group === panels[0].group && p.drawn).map((p) => p.canvas._fullLayout.xaxis.range)")
        assert len(others) >= 2 and all(other == [start, end] for other in others), others
        # As a person does, again if the page took the second click too late for a double click.
        for _ in range(5):
            page.mouse.dblclick(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
            settle(page)
            if page.evaluate("panels[0].group.range") != [start, end]:
                break
        assert page.evaluate("panels[0].group.range") == page.evaluate("panels[0].group.all")
        shown = drawn(page)
        assert shown == before, (len(shown), len(before))


def a_zoom_takes_few_of_many_rows(browser, path):
    """What is decoded, looked at and drawn does not grow with the number of rows: it is bounded by curves and pixels."""
    with opened_file(browser, path, **LAPTOP) as page:
        settle(page)
        # Only the columns of curves that are drawn are decoded, with their times and events.
        decoded, wanted = page.evaluate(
            """(() => {
                const plots = panels.filter((panel) => panel.drawn || panel.inSight);
                const shown = plots.flatMap(({ plot, shown }) => plot.curves.filter((_, i) => shown[i]));
                // The limits of a view are those of the abscissae of all plots.
                const across = panels.flatMap(({ plot }) => [...plot.curves.map(({ x }) => x), plot.events ?? plot.curves[0].x]);
                return [[...decoded.keys()], [...new Set([...shown.map(({ y }) => y), ...across].map(({ id }) => id))]];
            })()"""
        )
        assert set(decoded) <= set(wanted) and len(decoded) < page.locator("script[type='text/plain']").count() / 2, decoded
        frame_of_first_plot(page)
        # Counts the values that are looked at one by one while curves are drawn.
        page.evaluate("window.looked = 0; window.plain = scan; window.scan = (values, a, b) => { looked += b - a; return plain(values, a, b); }; 0")
        for step in ["zoom(0.5)", "zoom(0.9)", "pan(0.25)", "reset()"]:
            page.evaluate(f"looked = 0; panels[0].group.{step}; 0")
            settle(page)
            looked, curves, points, pixels = page.evaluate(
                """(() => {
                    const drawn = panels.filter((panel) => panel.inSight && panel.drawn);
                    const lines = drawn.flatMap(({ canvas }) => canvas.data).filter(({ name }) => name !== "events");
                    return [looked, lines.length, Math.max(...lines.map(({ x }) => x.length)), drawn[0].pixels()];
                })()"""
            )
            # Each pixel has its lowest and highest value. To find them, up to 64 values at both ends of its rows are looked at. This is
            # done twice, coarsely and then in all detail.
            assert 0 < points <= 2 * pixels and looked <= 2 * curves * pixels * (2 * 64 + 2), (step, points, looked, curves, pixels)


def extremes_are_drawn(browser, path):
    """The highest and the lowest of all rows are among the few points that are drawn."""
    with opened_file(browser, path, **LAPTOP) as page:
        rows, points = page.evaluate(
            """(() => {
                const panel = panels[0], ends = (y) => y.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
                return [ends(column(panel.plot.curves[0].y).values).map((x) => panel.factor * x), ends(panel.canvas.data[0].y)];
            })()"""
        )
        assert rows == points, (rows, points)


def cursor_and_keys(browser, path):
    """The cursor shows values in all plots; keys move it, step through events and zoom."""
    with opened_file(browser, path, **LAPTOP) as page:
        box = frame_of_first_plot(page)
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + 20)
        settle(page)
        begin, end = page.evaluate("panels[0].group.all")
        cursor = page.evaluate("panels[0].group.cursor")
        assert abs(cursor - (begin + end) / 2) < 0.01 * (end - begin), cursor
        shown = page.evaluate("panels.filter((p) => p.inSight && p.shown[0] && p.plot.group === 'time').map((p) => [p.values[0].textContent, p.line.hidden])")
        assert len(shown) >= 2 and all(value and not hidden for value, hidden in shown), shown
        # The value is that of the row nearest to the cursor.
        value, row = page.evaluate("[panels[0].values[0].textContent, panels[0].factor * column(panels[0].plot.curves[0].y).values[nearest(column(panels[0].plot.curves[0].x).values, panels[0].group.cursor)]]")
        assert abs(float(value) / row - 1) < 1e-4, (value, row)
        page.locator(".frame").first.focus()
        page.keyboard.press("n")
        settle(page)
        events = page.evaluate("Array.from(panels[0].group.events)")
        assert page.evaluate("panels[0].group.cursor") == min(t for t in events if t > cursor)
        page.keyboard.press("+")
        settle(page)
        start, stop = page.evaluate("panels[0].group.range")
        assert abs((stop - start) / (end - begin) - 0.5) < 1e-9
        page.keyboard.press("0")
        settle(page)
        assert page.evaluate("panels[0].group.range") == [begin, end]


def columns_and_units_are_chosen(browser, path):
    """A check box adds a curve, a menu changes the unit of its numbers, and a table is sorted."""
    with opened_file(browser, path, **LAPTOP) as page:
        index = page.evaluate("panels.findIndex((panel) => panel.frame.hidden)")
        closed = page.locator("figure.plot").nth(index)
        closed.locator("input").first.check()
        closed.locator(".main-svg").first.wait_for()
        index = page.evaluate("panels.findIndex((panel) => panel.unit === 'rpm' && !panel.plot.y.log)")
        speeds = page.locator("figure.plot").nth(index)
        speeds.scroll_into_view_if_needed()
        speeds.locator(".main-svg").first.wait_for()
        before = page.evaluate(f"panels[{index}].canvas.data[0].y[0]")
        speeds.locator("select").select_option("rad/s")
        settle(page)
        after = page.evaluate(f"panels[{index}].canvas.data[0].y[0]")
        assert abs(before / after - 30 / math.pi) < 1e-9
        table = page.locator("#numbers table")
        table.get_by_role("button", name="lowest").click()
        lowest = [float(cell.get_attribute("data-value")) for cell in table.locator("tbody tr td:nth-child(3)").all()]
        assert lowest == sorted(lowest) and len(lowest) > 5


def every_plot_is_drawn(browser, path, settings, scheme):
    """Every plot in every section is drawn when it is in sight, and nothing is wider than the screen."""
    with opened_file(browser, path, color_scheme=scheme, **settings) as page:
        for figure in page.locator("figure.plot").all():
            # Scrolls as a person does, because plots above it may still be growing.
            figure.evaluate("figure => figure.scrollIntoView({ block: 'center' })")
            if figure.locator(".frame").is_visible():
                figure.locator(".main-svg").first.wait_for()
        assert page.evaluate("document.documentElement.scrollWidth") <= settings["viewport"]["width"]
        # Exponents and indices are large enough to be read, too.
        sizes = page.evaluate("Array.from(document.querySelectorAll('.canvas tspan'), (part) => parseFloat(getComputedStyle(part).fontSize))")
        assert min(sizes) >= 11, min(sizes)


def tables_say_units_and_reasons(browser, path):
    """Tables are in the units of the plots, and say why a number does not exist."""
    with opened_file(browser, path, **LAPTOP) as page:
        cells = page.locator("#numbers td:nth-child(2)").all_text_contents()
        assert "rpm" in cells and "um" in cells, set(cells)
        assert "k12, k34: no K_v, because the scene gives the stiffness of this mesh without teeth." in page.locator("#method").text_content()


def labels_of_lines_stand_apart(browser, path, settings):
    """The labels of the lines of orders and spectra cover none of one another and stay in their plots, however narrow these are."""
    boxes = """() => panels.filter(({ plot, drawn }) => drawn && plot.lines.length > 0).map(({ canvas }) =>
        [canvas, ...canvas.querySelectorAll(".annotation-text-g")].map((part) => part.getBoundingClientRect()).map(({ left, top, right, bottom }) => [left, top, right, bottom]))"""
    with opened_file(browser, path, **settings) as page:
        for section in ("orders", "spectra"):
            page.locator(f"#{section} figure.plot").first.scroll_into_view_if_needed()
            page.locator(f"#{section} figure.plot .main-svg").first.wait_for()
        plots = page.evaluate(boxes)
        assert len(plots) > 1, plots
        for frame, *labels in plots:
            assert len(labels) > 2, labels
            for i, (left, top, right, bottom) in enumerate(labels):
                assert frame[0] <= left and right <= frame[2], (frame, labels[i])
                apart = [right <= other[0] + 1 or other[2] <= left + 1 or bottom <= other[1] + 1 or other[3] <= top + 1 for other in labels[:i]]
                assert all(apart), (labels[i], labels[:i])


def hostile_names_stay_text(browser, gearsim, folder):
    """HTML and script ends in the name and in the text of a scene are shown, and not executed."""
    text = (SCENES / "oh2005" / "energy_300rpm.toml").read_text()
    lines = [line for line in text.splitlines() if not line.startswith("about")]
    about = "</script><script>document.body.dataset.hurt=2</script><b>bold</b>"
    scene = folder / f"{HOSTILE}.toml"
    scene.write_text("\n".join([f'about = "{about}"', "# --> </title></style>", *lines]))
    path = run(gearsim, scene, folder / "hostile")
    with opened_file(browser, path, **LAPTOP) as page:
        assert page.evaluate("document.body.dataset.hurt") is None
        assert page.locator("h1").text_content() == HOSTILE
        assert page.locator(".subtitle").text_content() == about
        assert page.locator("main img, main b, main script:not([type])").count() == 0
        assert "</title></style>" in page.locator("#scene code").first.text_content()
        assert page.evaluate("document.querySelector('meta[http-equiv]').content").startswith("default-src 'none'; script-src 'sha256-")


def tests(gearsim, folder, pictures):
    small = run(gearsim, SCENES / "gear_pair_bearings.toml", folder / "small")
    large = run(gearsim, SCENES / "oh2005" / "spectrum_4500rpm_exact.toml", folder / "large", "run.t_end=1 s", "output.rate=1 MHz")
    yield zoom_shows_detail, (small, 4000), "small"
    yield zoom_shows_detail, (large, 1_000_000), "large"
    yield a_zoom_takes_few_of_many_rows, (large,), "large"
    yield extremes_are_drawn, (large,), "large"
    yield cursor_and_keys, (small,), "small"
    yield columns_and_units_are_chosen, (small,), "small"
    yield from common.screens(every_plot_is_drawn, small)
    stages = run(gearsim, SCENES / "two_stage.toml", folder / "stages")
    for size in (LAPTOP, PHONE):
        yield labels_of_lines_stand_apart, (stages, size), "stages"
    yield tables_say_units_and_reasons, (stages,), "stages"
    yield hostile_names_stay_text, (gearsim, folder), "hostile"


common.run_tests(tests)
