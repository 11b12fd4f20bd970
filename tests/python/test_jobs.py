"""The five jobs of an engineer take as many lines as plots/README.md says, and are answered by them."""

import re

import delabole
import pytest

JOBS = {
    "a road cut": (
        "plane_failure/bolted_road_cut.toml",
        ["case = delabole.read(path)", "print(case.run())", "print(case.sensitivity())"],
        r"FS 1\.59: stands\.\nOf 210 patterns the cheapest for FS 1\.5: (.*\n)+.*Probability of failure ",
    ),
    "a toppling slope": (
        "stepped_base/goodman_bray_1976_cable.toml",
        ["case = delabole.read(path)", "print(case.run())"],
        r"FS 1 takes 2013 kN/m in a cable",
    ),
    "a slope from a DXF": (
        "slope.toml",
        ["simulation = delabole.Simulation(delabole.read(path))", "simulation.run()", "print(simulation)"],
        r"blocks, collapse after \d+ steps",
    ),
    "a back-analysis": (
        "starting/fit.toml",
        ["fit = delabole.read(path).fit()", "print(fit)"],
        r"only one combination is determined",
    ),
    "measured poles": (
        "kinematics/road_cut_poles.toml",
        ["result = delabole.read(path).run()", "print(result)"],
        r"flexural toppling \(set 1\)",
    ),
}


@pytest.fixture(scope="module")
def drawn(cases, tmp_path_factory):
    """A case whose outline is a drawing of lines."""
    folder = tmp_path_factory.mktemp("drawn")
    corners = [(0, 0), (20, 0), (20, 12), (6, 12)]
    lines = "".join(f"0\nLINE\n10\n{x1}\n20\n{y1}\n11\n{x2}\n21\n{y2}\n"
                    for (x1, y1), (x2, y2) in zip(corners, corners[1:] + corners[:1]))
    (folder / "slope.dxf").write_text(f"0\nSECTION\n2\nENTITIES\n{lines}0\nENDSEC\n0\nEOF\n")
    text = (cases / "starting/jointed_slope.toml").read_text()
    text = re.sub(r"^outline = \[.*?^\]$", 'outline_file = "slope.dxf"', text, flags=re.MULTILINE | re.DOTALL)
    (folder / "slope.toml").write_text(text)
    return folder


@pytest.mark.parametrize("job", JOBS)
def test_job(cases, drawn, capsys, job):
    name, lines, answer = JOBS[job]
    known = {"delabole": delabole, "path": drawn / name if (drawn / name).exists() else cases / name}
    for line in lines:
        exec(line, known)
    printed = capsys.readouterr().out
    assert re.search(answer, printed), printed
    rows = (cases.parent / "plots/README.md").read_text().splitlines()
    told = [row.split("|")[3].strip() for row in rows if row.startswith(f"| {job}")]
    assert told == [str(len(lines))]
