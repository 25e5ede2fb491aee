"""Tests of the animated gears in headless Chromium: python tests/browser/gears.py GEARSIM [FOLDER]

GEARSIM is the program built with the feature `html`. Needs what page.py needs. The gears that are drawn are compared with the columns that
the run writes beside the page, and with closed forms; with FOLDER, pictures of them are written there.
"""

import csv
import math
import subprocess

import common
from common import LAPTOP, SCENES, opened_file, settle, wait_until

# Allowed differences. The columns of the page are resolved to 1/8.6e9 (times, rotations) and 1/131,000 (others) of the range of a block.
FINE, COARSE = 1e-7, 2e-5

# Distance of a point from a polyline.
DISTANCE = """([x, y], points) => {
    let least = Infinity;
    for (let k = 0; k + 1 < points.length; k++) {
        const [a, b] = [points[k], points[k + 1]], [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        const part = Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
        least = Math.min(least, Math.hypot(x - a[0] - part * dx, y - a[1] - part * dy));
    }
    return least;
}"""


def run(gearsim, scene, folder, *sets):
    """Runs a scene; the path of its page."""
    arguments = [argument for value in ("output.plots=[]", "output.csv=true", *sets) for argument in ("--set", value)]
    subprocess.run([gearsim, "run", SCENES / scene, "--html", "-q", "--out", folder, *arguments], check=True)
    return folder / "page.html"


def table(path):
    """The rows of a run as numbers, by the names of its columns without units."""
    with open(path.parent / "trajectory.csv", newline="") as file:
        lines = csv.DictReader(line for line in file if not line.startswith("#"))
        return [{key.split(" [")[0]: float(text) for key, text in row.items() if key.split(" [")[0] != "moment"} for row in lines]


def at(rows, t, value):
    """A function of the rows at a time, on straight lines between them; at an event, after it."""
    after = next((i for i, row in enumerate(rows) if row["t"] > t), len(rows) - 1)
    a, b = rows[max(after - 1, 0)], rows[after]
    part = (t - a["t"]) / (b["t"] - a["t"]) if b["t"] > a["t"] else 0.0
    return value(a) + min(max(part, 0.0), 1.0) * (value(b) - value(a))


def shown(page):
    """The gears, in sight."""
    page.locator("figure.gears").scroll_into_view_if_needed()
    settle(page)
    return page.locator("figure.gears")


def scrub(page, part):
    """Moves the slider of the time to a part of the run; the time there."""
    page.locator("figure.gears input[type=range]").fill(str(round(10000 * part)))
    settle(page)
    return page.evaluate("drawings[0].t")


def pixels(page):
    """How many pixels of the canvas are drawn on, and a sum that changes with the drawing."""
    return page.evaluate(
        """(() => {
            // A copy: to read the page's own canvas slows it down, and the console says so.
            const { width, height } = document.querySelector("figure.gears canvas");
            const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
            copy.drawImage(document.querySelector("figure.gears canvas"), 0, 0);
            const { data } = copy.getImageData(0, 0, width, height);
            let [count, sum] = [0, 0];
            for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 0) { count++; sum = (sum * 31 + data[i] + i) % 1000003; }
            return [count / (width * height), sum];
        })()"""
    )


def the_pinion_is_where_the_run_recorded_it(browser, path):
    """At scrubbed times the driving gear stands at (theta + phi)/N1, whatever the magnification; the driven gear lags by the lead."""
    rows = table(path)
    with opened_file(browser, path, **LAPTOP) as page:
        shown(page)
        assert page.evaluate("drawings.length") == 1
        z1, z2 = page.evaluate("drawings[0].mesh.gears.map((gear) => gear.teeth)")
        assert (z1, z2) == (24, 96)
        largest = max(abs(row["theta"]) for row in rows) / z1
        for part in (0.0, 0.137, 0.5, 0.731, 1.0):
            t = scrub(page, part)
            span = rows[-1]["t"] - rows[0]["t"]
            assert abs(t - rows[0]["t"] - part * span) < 1e-3 * span, (t, part)
            first, second = (at(rows, t, lambda row, s=s, z=z: (row["theta"] + s * row["phi"]) / z) for s, z in ((1, z1), (-1, z2)))
            for magnified in page.evaluate("Array.from(drawings[0].magnify.options, (option) => option.value)"):
                page.locator("figure.gears").get_by_label("Magnification").select_option(magnified)
                settle(page)
                turned = page.evaluate("drawings[0].now().angles.map((angle, i) => angle - drawings[0].mesh.gears[i].place - drawings[0].mesh.begin / drawings[0].mesh.gears[i].base)")
                assert abs(turned[0] - first) <= FINE * largest, (t, turned[0], first)
                # The driven gear lags by the lead r_b1 theta_1 - r_b2 theta_2 times the magnification.
                base = page.evaluate("drawings[0].mesh.gears.map((gear) => gear.base)")
                lead = base[0] * first - base[1] * second
                lag = base[0] * turned[0] - base[1] * turned[1]
                assert abs(lag / float(magnified) - lead) <= COARSE * max(abs(lead), page.evaluate("drawings[0].mesh.largest_lead")), (lag, lead, magnified)


def contacts_lie_on_the_line_of_action(browser, path, times=60):
    """The contacts are on a common tangent of both base circles, between the tips, a base pitch apart; without magnification both outlines
    pass through them."""
    with opened_file(browser, path, **LAPTOP) as page:
        shown(page)
        sides, counts = set(), set()
        for k in range(times):
            part = (k + 0.5) / times
            mesh, state, gaps = page.evaluate(
                "(part) => { const near = " + DISTANCE + """;
                    const { mesh, times } = drawings[0];
                    const t = drawings[0].fraction(part);
                    const state = instant(mesh, times, t, 1);
                    const outlines = [0, 1].map((i) => outline(mesh, i, state, Math.PI).points);
                    const gaps = state.contacts.map(({ point }) => outlines.map((points) => near(point, points)));
                    return [{ ...mesh, centres: [centre(mesh, 0), centre(mesh, 1)] }, state, gaps];
                }""",
                part,
            )
            side = -1 if state["coasts"] else 1
            counts.add(len(state["contacts"]))
            for contact, gap in zip(state["contacts"], gaps):
                sides.add(side)
                x, y = contact["point"]
                # The direction of the line of action, and the distance of both centres from the line through the contact.
                u = (math.sin(mesh["angle"]), side * math.cos(mesh["angle"]))
                for centre, gear in zip(mesh["centres"], mesh["gears"]):
                    distance = abs((x - centre) * u[1] - y * u[0])
                    assert abs(distance / gear["base"] - 1) < 1e-9, (distance, gear["base"])
                    low, high = sorted((gear["tip"], gear["root"]))
                    # The middle between both flanks is away from the path of contact by half the lead at most.
                    assert low - mesh["largest_lead"] <= math.hypot(x - centre, y) <= high + mesh["largest_lead"]
                # Allowed are half the lead on each side, and the distance of the chords of the outline from the curved flank.
                assert max(gap) < mesh["largest_lead"] + 2e-4 * mesh["pitch"], (state["t"], gap, mesh["largest_lead"])
            places = sorted(contact["x"] for contact in state["contacts"])
            assert all(abs((b - a) / mesh["pitch"] - 1) < 1e-9 for a, b in zip(places, places[1:]))
        return sides, counts


def one_pair_or_two(browser, path):
    """With a contact ratio of 1.72 one pair is in contact, or two."""
    _, counts = contacts_lie_on_the_line_of_action(browser, path)
    assert counts == {1, 2}, counts


def contact_is_lost_and_made_again(browser, path):
    """With play there are times without contact: those at which the recorded force of the mesh is zero."""
    rows = table(path)
    sides, counts = contacts_lie_on_the_line_of_action(browser, path, times=150)
    assert 0 in counts and len(counts) > 1, counts
    with opened_file(browser, path, **LAPTOP) as page:
        shown(page)
        name, largest = page.evaluate("[drawings[0].mesh.force.name, drawings[0].mesh.force.largest]")
        for k in range(100):
            t, touching = page.evaluate("(part) => { const { mesh, times } = drawings[0], t = drawings[0].fraction(part); return [t, instant(mesh, times, t, 1).contacts.length > 0]; }", (k + 0.31) / 100)
            force = at(rows, t, lambda row: row[name])
            # Near the beginning and the end of contact the digits of the page decide.
            if abs(force) == 0 or abs(force) > 2e-3 * largest:
                assert touching == (force != 0), (t, force, touching)
    return sides


def coast_flanks_touch_too(browser, path):
    """Where gears rattle, contacts are on drive flanks and on coast flanks."""
    assert contact_is_lost_and_made_again(browser, path) == {1, -1}


def gears_move_in_step_with_the_plots(browser, path):
    """The slider moves the cursor of the plots, the cursor moves the gears, playing moves both; keys do the same."""
    with opened_file(browser, path, **LAPTOP) as page:
        # First the pointer over a plot moves the cursor, with the gears out of sight.
        box = page.locator(".nsewdrag").first.bounding_box()
        page.mouse.move(box["x"] + 0.25 * box["width"], box["y"] + 30)
        settle(page)
        assert page.evaluate("drawings[0].t === panels[0].group.cursor")
        shown(page)
        page.mouse.move(5, 5)
        t = scrub(page, 0.4)
        assert page.evaluate("panels[0].group.cursor") == t
        covered, before = pixels(page)
        assert 0.1 < covered < 0.995, covered
        frame = page.locator("figure.gears .frame")
        frame.focus()
        page.keyboard.press("ArrowRight")
        settle(page)
        step = page.evaluate("drawings[0].t") - t
        frequency = page.evaluate("drawings[0].mesh.frequency")
        assert abs(step * frequency - 0.1) < 1e-6, (step, frequency)
        assert pixels(page)[1] != before
        page.keyboard.press(" ")
        wait_until(page, "(t) => drawings[0].t > t + 0.05 / drawings[0].mesh.frequency", arg=t + step)
        assert page.evaluate("drawings[0].playing && panels[0].group.cursor === drawings[0].t")
        page.keyboard.press(" ")
        settle(page)
        stopped = page.evaluate("drawings[0].t")
        page.wait_for_timeout(300)
        assert page.evaluate("drawings[0].t") == stopped
        # At the end it begins again.
        scrub(page, 1)
        page.locator("figure.gears").get_by_role("button", name="Play").click()
        wait_until(page, "drawings[0].t < drawings[0].fraction(0.5)")
        page.locator("figure.gears").get_by_role("button", name="Pause").click()
        # The speed is that of the menu: at a tenth of it the same time takes ten times as long.
        speeds = page.evaluate("Array.from(drawings[0].slow.options, (option) => Number(option.value))")
        assert len(speeds) > 3 and speeds == sorted(speeds)
        rates = []
        for slower in (page.evaluate("Number(drawings[0].slow.value)"), speeds[-1]):
            page.locator("figure.gears").get_by_label("Speed").select_option(str(slower))
            begin = scrub(page, 0.1)
            rates.append(
                page.evaluate(
                    """(begin) => new Promise((done) => {
                        drawings[0].play();
                        setTimeout(() => { drawings[0].pause(); done(drawings[0].t - begin); }, 1500);
                    })""",
                    begin,
                )
                * slower
            )
        # Seconds played within 1.5 s, in the time of the screen. A busy machine draws late, and then the played time stands still.
        assert all(0.1 < rate < 2.0 for rate in rates), rates


def little_motion_for_those_who_prefer_it(browser, path):
    """With prefers-reduced-motion nothing moves by itself, and playing is a step now and then."""
    with opened_file(browser, path, reduced_motion="reduce", **LAPTOP) as page:
        shown(page)
        first = page.evaluate("drawings[0].t")
        page.wait_for_timeout(500)
        assert page.evaluate("drawings[0].t") == first and not page.evaluate("drawings[0].playing")
        seen = page.evaluate(
            """new Promise((done) => {
                const seen = new Set();
                const look = () => { seen.add(drawings[0].t); if (drawings[0].playing) requestAnimationFrame(look); };
                drawings[0].play();
                look();
                setTimeout(() => { drawings[0].pause(); done([...seen].length); }, 2000);
            })"""
        )
        assert 2 <= seen <= 5, seen


def every_mesh_can_be_chosen(browser, path, names, differ=None):
    """A menu has the meshes; each view of each is drawn, and the views differ. Of the meshes `differ` do: planets in phase look the same."""
    with opened_file(browser, path, **LAPTOP) as page:
        figure = shown(page)
        assert page.evaluate("drawings[0].drawing.meshes.map((mesh) => mesh.name)") == names
        sums = set()
        for name in names:
            if len(names) > 1:
                figure.get_by_label("Mesh", exact=True).select_option(name)
            for view in range(3):
                figure.get_by_label("View").select_option(index=view)
                settle(page)
                covered, changed = pixels(page)
                assert covered > 0.02, (name, view, covered)
                sums.add(changed)
        assert len(sums) >= 3 * (differ or len(names)), (names, len(sums))


def nothing_without_gears(browser, path):
    """A scene without gears has no such section."""
    with opened_file(browser, path, **LAPTOP) as page:
        assert page.locator("#gears, figure.gears").count() == 0


def fits(browser, path, settings, scheme, picture):
    """The gears are drawn on each screen, and nothing is wider than it."""
    with opened_file(browser, path, color_scheme=scheme, **settings) as page:
        figure = shown(page)
        scrub(page, 0.3)
        assert pixels(page)[0] > 0.05
        assert page.evaluate("document.documentElement.scrollWidth") <= settings["viewport"]["width"]
        if picture:
            figure.screenshot(path=picture / f"{path.parent.name}_{settings['viewport']['width']}_{scheme}.png")


def tests(gearsim, folder, pictures):
    teeth = run(gearsim, "gear_pair_teeth.toml", folder / "teeth", "run.t_end=50 ms")
    play = run(gearsim, "backlash.toml", folder / "play")
    rattle = run(gearsim, "rattle.toml", folder / "rattle")
    stages = run(gearsim, "two_stage.toml", folder / "stages", "run.t_end=50 ms")
    idler = run(gearsim, "idler.toml", folder / "idler")
    planets = run(gearsim, "planetary_3.toml", folder / "planets", "run.t_end=20 ms")
    train = run(gearsim, "train_turbine.toml", folder / "train", "run.t_end=20 ms")
    chain = run(gearsim, "chain_5.toml", folder / "chain")
    all_tests = [
        (the_pinion_is_where_the_run_recorded_it, (teeth,)),
        (one_pair_or_two, (teeth,)),
        *((contacts_lie_on_the_line_of_action, (path,)) for path in (stages, idler, planets, train)),
        (contact_is_lost_and_made_again, (play,)),
        (coast_flanks_touch_too, (rattle,)),
        (gears_move_in_step_with_the_plots, (teeth,)),
        (little_motion_for_those_who_prefer_it, (teeth,)),
        (every_mesh_can_be_chosen, (teeth, [""])),
        (every_mesh_can_be_chosen, (stages, ["12", "34"])),
        (every_mesh_can_be_chosen, (idler, ["12", "23"])),
        (every_mesh_can_be_chosen, (planets, ["s1", "r1", "s2", "r2", "s3", "r3"], 2)),
        (nothing_without_gears, (chain,)),
    ]
    yield from ((test, arguments, arguments[0].parent.name) for test, arguments in all_tests)
    for path in (teeth, play, rattle, stages, idler, planets, train):
        yield from common.screens(fits, path, pictures)


if __name__ == "__main__":
    common.run_tests(tests)
