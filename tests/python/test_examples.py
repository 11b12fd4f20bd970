"""Every example runs as its reader would run it, and says what it is said to say."""

import importlib.util
import os
import re
import subprocess
import sys

import pytest

SAYS = {
    "fig_2_8.py": r"20 deg +3\.\d+ +1\.\d+ +1\.000",
    "back_analysis.py": r"only one combination is determined",
    "slope_in_motion.py": r"column 1 slides_forward\n(.*\n)*column 8 rotates\n(.*\n)*column 16 stays",
    "million_samples.py": r"1000000 factors of safety in .*\nmean 1\.34\d, standard deviation 0\.23\d\n.*0\.06",
}


def test_every_example_is_run(cases):
    assert set(SAYS) == {path.name for path in (cases / "python/examples").glob("*.py")}


@pytest.mark.parametrize("name", SAYS)
def test_example(cases, tmp_path, name):
    picture = [str(tmp_path / "picture.png")] if name == "slope_in_motion.py" else []
    made = subprocess.run([sys.executable, cases / "python/examples" / name, *picture], cwd=cases.parent,
                          capture_output=True, text=True, env={**os.environ, "MPLCONFIGDIR": str(tmp_path)})
    assert made.returncode == 0, made.stderr
    assert re.search(SAYS[name], made.stdout), made.stdout
    if picture and importlib.util.find_spec("matplotlib") is not None:
        assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")


def test_the_readme_shows_what_python_prints(cases, capsys):
    text = (cases / "python/README.md").read_text()
    blocks = re.findall(r"^```(python|text)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert [language for language, _ in blocks] == ["python", "text"] * (len(blocks) // 2) and blocks
    known = {}
    for (_, code), (_, printed) in zip(blocks[::2], blocks[1::2]):
        exec(code, known)
        assert capsys.readouterr().out == printed
