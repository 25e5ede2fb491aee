"""Interactive pages of runs."""

import pathlib
import re
import subprocess
import sys

import gearsim

SCENE = pathlib.Path(__file__).parents[3] / "models" / "scenes" / "oh2005" / "energy_300rpm.toml"

# Two runs take different times.
PROCESSOR_TIME = re.compile(r"<dt>processor time</dt><dd>[^<]*</dd>")


def bare(page):
    text, replaced = PROCESSOR_TIME.subn("", page)
    assert replaced == 1
    return text


def test_a_page_has_the_bytes_of_the_command_line(tmp_path):
    there = tmp_path / "there"
    command = [sys.executable, "-m", "gearsim", "run", str(SCENE), "--quiet", "--html", "--out", str(there)]
    subprocess.run(command, check=True)
    files = gearsim.load(SCENE).run().write(tmp_path / "here", html=True)
    assert sorted(file.name for file in files) == sorted(file.name for file in there.iterdir())
    here, there = ((folder / "page.html").read_text() for folder in (tmp_path / "here", there))
    assert bare(here) == bare(there)


def test_a_page_needs_no_network(tmp_path):
    results = gearsim.load(SCENE).run()
    page = results.page()
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page)[1]
    assert "default-src 'none'" in policy and "http" not in policy
    for reference in re.findall(r"<(?:script|link|img|iframe)\b[^>]*\b(?:src|href)=[\"']?([^\"'\s>]*)", page.split("<noscript>")[0]):
        assert reference.startswith(("#", "data:")), reference
    assert 'id="energy"' in page and 'id="provenance"' in page
    # Without a page there is none in the folder.
    assert all(file.name != "page.html" for file in results.write(tmp_path))
