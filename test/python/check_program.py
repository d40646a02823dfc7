"""The program from Python: what it found arrives whole, and what it says, too."""

import csv
import dataclasses
import io
import os
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import asperity
import numpy as np
import pytest
from asperity import program
from conftest import wood

EXAMPLES = Path(__file__).parents[2]/"examples"
SCAN, BASE = EXAMPLES/"surface/scan.plu", EXAMPLES/"tenon_joint/base.nml"


def by_hand(*words, status=0):
    """What a command prints, or its message where it must fail."""
    ended = subprocess.run([program.find_program(), *map(str, words)], capture_output=True, text=True,
                           check=False)
    assert ended.returncode == status
    return ended.stderr if status else ended.stdout


def as_csv(text):
    """Columns of CSV by their headings."""
    head, *rows = csv.reader(io.StringIO(text))
    return {name: [row[i] for row in rows] for i, name in enumerate(head)}


def fake(folder, text):
    """A program that is none of ours."""
    path = folder/"asperity"
    path.write_text("#!/bin/sh\n" + text, encoding="utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


@pytest.fixture(scope="module")
def scan():
    return program.surface(SCAN, verify=True)


@pytest.fixture(scope="module")
def pressed():
    return program.fit(EXAMPLES/"fit/press.csv", kind="press", fix={"pair": "transverse-tangential"},
                       free=["eta", "initial_separation", "machine_compliance"])


@pytest.mark.parametrize("words", [
    ("tenon", BASE, "--amplitudes", "4,8", "--cycles", "1,1"), ("shear", "--displacement", "1,-1"),
    ("hysteresis", EXAMPLES/"records/cyclic_1.csv"), ("surface", SCAN)])
def test_every_number_arrives(words):
    """Names, units and values of the main table are those of the program's own CSV."""
    keys = dict(zip([word.removeprefix("--") for word in words[2::2]], words[3::2], strict=True)) \
        if words[0] == "tenon" else {"displacement": [1, -1]} if words[0] == "shear" else {}
    data = program.run(words[0], *(word for word in words[1:2] if isinstance(word, Path)), **keys).data
    expected = as_csv(by_hand(*words, "--csv", "-"))
    assert [name + (f" ({data.units[name]})" if data.units.get(name, "-") != "-" else "")
            for name in data] == list(expected)
    for column, cells in zip(data.values(), expected.values(), strict=True):
        if column.dtype.kind == "U":
            assert column.tolist() == cells
        else:
            np.testing.assert_array_equal(column, [float(cell or "nan") for cell in cells])
    assert data.rows == len(next(iter(expected.values()))) > 5


def test_kinds_of_columns():
    cycles = program.hysteresis(EXAMPLES/"records/cyclic_1.csv")
    assert cycles.record_kind == "cyclic"
    assert cycles.data["cycle"].dtype.kind == "i"
    assert cycles.summary["side"].tolist() == ["positive", "negative", "mean"]
    three = cycles.tables["en_12512"].row(side="mean")["two_lines_force"]
    assert np.isnan(three), "null is NaN"
    assert str(cycles) == by_hand("hysteresis", EXAMPLES/"records/cyclic_1.csv")
    with pytest.raises(KeyError, match="there is no column force; there are cycle, "):
        cycles.data["force"]
    with pytest.raises(asperity.InputError, match="0 rows have"):
        cycles.summary.row(side="upper")


def test_input_and_its_sources():
    made = program.run("curve", sigma=np.float64(0.06), separation=np.linspace(0.05, 0.2, 4))
    assert made.properties["sigma"] == 0.06
    assert made.settings["separation"] == np.linspace(0.05, 0.2, 4).tolist()
    assert (made.sources["sigma"], made.sources["separation"], made.sources["pair"]) \
        == ("--sigma", "--separation", "default")
    assert (made.units["sigma"], made.data.units["pressure"]) == ("mm", "MPa")
    assert made.version == asperity.__version__


def test_keys():
    """Switches, several runs, values by names, several files."""
    for no in False, np.False_:
        assert program.run("shear", shrinking_overlap=no).settings["shrinking_overlap"] is False
    law = asperity.Law(wood())
    assert program.run("curve", initial_separation=law.separation(1.0)).properties["initial_separation"] \
        == law.separation(1.0)
    fixed = program.fit(EXAMPLES/"fit/press.csv", kind="press", free=["eta", "initial_separation"], fix={
        "pair": "transverse-tangential", "machine_compliance": np.float64(0.004)})
    assert "machine_compliance=0.004" in fixed.settings["fix"]
    assert program.run("curve", accept_unphysical=True, sigma=None).sources["accept_unphysical"] \
        == "--accept-unphysical"
    swept = program.run("press", sweep={"sigma": [0.04, 0.06], "hardness": [12, 24.0]}).data
    assert set(zip(swept["sigma"].tolist(), swept["hardness"].tolist(), strict=True)) \
        == {(0.04, 12.0), (0.04, 24.0), (0.06, 12.0), (0.06, 24.0)}
    records = [EXAMPLES/f"records/cyclic_{i}.csv" for i in (1, 2, 3)]
    assert len(set(program.hysteresis(*records).data["record"])) == 3
    across, along = ([str(path) for path in sorted((EXAMPLES/"surface/profiles").glob(name))]
                     for name in ("across_*.csv", "along_*.csv"))
    assert len(program.surface(*across, perpendicular=along).tables["profiles"]["file"]) == 8


def test_scan_to_law(scan):
    """The law of the scan's properties is the program's own, at its separations."""
    found = program.law_properties(scan)
    expected = scan.summary.row(route="nayak")
    for name in ("eta", "radius", "sigma"):
        assert getattr(found, name) == expected[name]
    law = scan.tables["law"]
    np.testing.assert_allclose(asperity.Law(found).pressure(law["separation"]), law["pressure_nayak"],
                               rtol=1e-13)
    assert scan.verdict.startswith("route nayak")


def test_record_to_law(pressed):
    """What was not measured is asked for; a pair fills in, and replaces nothing that was."""
    eta = pressed.summary.row(parameter="eta")
    assert eta["low_95"] < 260.0 < eta["high_95"], "that the record was made with"
    with pytest.raises(asperity.InputError, match="friction_coefficient, critical_slip must be given"):
        program.law_properties(pressed)
    filled = program.law_properties(pressed, pair="transverse-tangential")
    assert (filled.eta, filled.friction_coefficient, filled.unloading) == (eta["value"], 0.5, "elastic")
    given = program.law_properties(pressed, friction_coefficient=0.4, critical_slip=0.2)
    assert (given.eta, given.friction_coefficient, given.critical_slip) == (eta["value"], 0.4, 0.2)


def test_case_files(tmp_path, scan):
    written = program.surface(SCAN, verify=True, case=tmp_path/"scan.nml")
    assert written.case == (tmp_path/"scan.nml").read_text(encoding="utf-8")
    assert program.law_properties(tmp_path/"scan.nml") == program.law_properties(scan)
    (tmp_path/"friction.nml").write_text("&asperity\n friction_coefficient = 0.4\n/\n", encoding="utf-8")
    assert program.law_properties(tmp_path/"friction.nml", pair="tangential-tangential") == wood(
        **asperity.Properties.from_pair("tangential-tangential", initial_separation=4*0.0416,
                                        friction_coefficient=0.4).__dict__)


@pytest.mark.parametrize("changes", [
    {}, {"unloading": "elastic", "plastic_ratio": 100.0}, {"stick": "summits", "shear_modulus": 100.0},
    {"height_distribution": "johnson", "skewness": -0.3, "kurtosis": 3.2, "friction_rule": "dissipative",
     "static_friction_coefficient": 0.6, "decay_slip": 0.5, "friction_coefficient_across": 0.4,
     "grain_angle": 30.0, "slip_direction": "stress", "shear_limit": 2.0,
     "friction_pressures": (1.0, 2.0), "friction_factors": (1.0, 0.9)}], ids=lambda changes: "+".join(changes))
def test_law_to_joint(changes):
    """A joint runs with the properties that it is given, all of them."""
    given = wood(sigma=0.05, initial_separation=0.21, **changes)
    joint = program.tenon(BASE, properties=given, amplitudes=[4], cycles=[1])
    back = program.law_properties(joint)
    assert back.stick_elements == (8 if given.stick == "summits" else 0)
    assert dataclasses.replace(back, stick_elements=0) == given
    assert joint.data.where(model="rough").rows == joint.data.rows // 2


def test_properties_beside_a_case(tmp_path):
    (tmp_path/"rest.nml").write_text(
        "&asperity\n static_friction_coefficient = 0.6\n decay_slip = 1.0\n/\n", encoding="utf-8")
    with pytest.raises(asperity.InputError, match="static_friction_coefficient, decay_slip beside"):
        program.tenon(tmp_path/"rest.nml", properties=wood(), amplitudes=[4], cycles=[1])


def test_comparison(tmp_path):
    """A comparison that departs has status 1 and an answer; it is no exception."""
    for name, force in ("expected", 2.0), ("same", 2.0), ("other", 2.1):
        (tmp_path/f"{name}.csv").write_text(f"time (s),force (N)\n0,1\n1,{force}\n", encoding="utf-8")
    same, other = (program.run("compare", tmp_path/"expected.csv", tmp_path/f"{name}.csv")
                   for name in ("same", "other"))
    assert same.passed
    assert not other.passed
    assert "other.csv" in other.verdict
    assert program.run("compare", tmp_path/"expected.csv", tmp_path/"other.csv", tolerance=0.06).passed


@pytest.mark.parametrize(("kind", "status", "words", "call"), [
    (asperity.InputError, 2, ("tenon", "--sigmma", "0.3"), lambda: program.tenon(sigmma=0.3)),
    (asperity.InputError, 2, ("tenon", "--length", "0.3"), lambda: program.tenon(length=0.3)),
    (program.FileError, 3, ("shear", "none.nml"), lambda: program.run("shear", "none.nml"))])
def test_refusals(kind, status, words, call):
    """Messages are the program's own."""
    with pytest.raises(kind) as caught:
        call()
    assert by_hand(*words, status=status) == f"asperity: error: {caught.value}\n"


def test_solid_says_what_it_needs(monkeypatch):
    monkeypatch.setenv("ASPERITY_PETSC", "/none")
    with pytest.raises(asperity.AsperityError, match="ASPERITY_PETSC = /none is no library"):
        program.solid(EXAMPLES/"solid_joint/coarse.nml")


def test_no_program(monkeypatch, tmp_path):
    monkeypatch.delenv("ASPERITY_PROGRAM", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(program.ProgramNotFoundError, match="no program asperity is on PATH.*cmake"):
        program.tenon()
    monkeypatch.setenv("ASPERITY_PROGRAM", str(tmp_path/"none"))
    with pytest.raises(program.ProgramNotFoundError, match="ASPERITY_PROGRAM = .*none is no program"):
        program.tenon()


@pytest.mark.parametrize(("text", "kind", "message"), [
    ("echo asperity 0.1.7", program.ProgramNotFoundError, "is 0.1.7; this package needs"),
    ("echo hello", program.ProgramNotFoundError, "is not asperity; this package needs"),
    ('[ "$1" = version ] && echo asperity VERSION && exit; echo asperity: error: no root >&2; exit 1',
     asperity.ComputationError, "^no root$"),
    ('[ "$1" = version ] && echo asperity VERSION && exit; kill -SEGV $$',
     asperity.ComputationError, "ended by signal 11"),
    ("echo no libgsl >&2; exit 127", program.ProgramNotFoundError, "is not asperity: no libgsl; this"),
])
def test_other_programs(monkeypatch, tmp_path, text, kind, message):
    monkeypatch.setenv("ASPERITY_PROGRAM",
                       str(fake(tmp_path, text.replace("VERSION", asperity.__version__))))
    with pytest.raises(kind, match=message):
        program.tenon()


def test_file_that_is_no_program(monkeypatch, tmp_path):
    path = fake(tmp_path, "")
    path.write_bytes(b"\0")
    monkeypatch.setenv("ASPERITY_PROGRAM", str(path))
    with pytest.raises(program.ProgramNotFoundError, match="cannot be run: "):
        program.tenon()


def test_program_that_is_built_anew(monkeypatch, tmp_path):
    """What was there before is forgotten."""
    monkeypatch.setenv("ASPERITY_PROGRAM", str(fake(tmp_path, "echo asperity 0.1.7")))
    with pytest.raises(program.ProgramNotFoundError, match=r"is 0\.1\.7"):
        program.find_program()
    path = fake(tmp_path, f"echo asperity {asperity.__version__}")
    os.utime(path, ns=(0, 1))
    assert program.find_program() == path


def test_interrupt(tmp_path, monkeypatch):
    """An interrupt ends the program with what that runs, and takes its folder away."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setenv("ASPERITY_PROGRAM", str(fake(
        tmp_path, f'[ "$1" = version ] && echo asperity {asperity.__version__} && exit\n'
        f'sleep 100 & trap "kill $!; wait" TERM; echo $! >"{tmp_path}/id"; wait')))
    caller = subprocess.Popen([sys.executable, "-c", "from asperity import program; program.tenon()"],
                              stderr=subprocess.PIPE, text=True)
    for _ in range(600):
        if (tmp_path/"id").exists() and (tmp_path/"id").read_text(encoding="utf-8").endswith("\n"):
            break
        time.sleep(0.05)
    caller.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in caller.communicate(timeout=30)[1]
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path/"id").read_text(encoding="utf-8")), 0)
    assert not list(tmp_path.glob("asperity-*"))


def test_odd_names(tmp_path, monkeypatch):
    """Names that look like options, with blanks, quotes and bytes that are no text."""
    monkeypatch.chdir(tmp_path)
    record = (EXAMPLES/"records/cyclic_1.csv").read_bytes()
    expected = program.hysteresis(EXAMPLES/"records/cyclic_1.csv").data["damping"]
    for name in "-record.csv", "a b;'$x\".csv", "h\udcf6lzern.csv":
        (tmp_path/name).write_bytes(record)
        np.testing.assert_array_equal(program.hysteresis(name).data["damping"], expected)
    program.run("press", csv="-press.csv")
    assert (tmp_path/"-press.csv").exists()


def test_what_stands_alone():
    """A text where several are usual."""
    one = program.fit(EXAMPLES/"fit/press.csv", kind="press", free="eta", fix={
        "pair": "transverse-tangential", "initial_separation": 0.2372, "machine_compliance": 0.004})
    assert one.summary["parameter"].tolist() == ["eta"]
    profile = sorted((EXAMPLES/"surface/profiles").glob("*.csv"))
    found = program.surface(profile[0], perpendicular=str(profile[-1]), case=None)
    assert found.tables["profiles"].rows == 2
    swept = program.run("press", sweep="sigma=0.04,0.06").data
    assert set(swept["sigma"].tolist()) == {0.04, 0.06}


@pytest.mark.parametrize(("call", "kind", "message"), [
    (lambda: program.run("press --help"), asperity.InputError, "'press --help' finds no values"),
    (lambda: program.run("shear", case_text=""), asperity.InputError, "case"),
    (lambda: program.run("curve", separation=np.linspace(0.0, 0.2, 20_000)), asperity.InputError,
     "too long for a command line"),
    (lambda: program.tenon(properties=wood(), eta=100.0), asperity.InputError, "eta is given beside"),
    (lambda: program.tenon(properties=asperity.Law(wood())), TypeError, "it must be Properties"),
    (lambda: program.law_properties("none.nml", pair="transverse-tangential"), program.FileError,
     "none.nml: cannot be read"),
    (lambda: program.law_properties(program.run("press")), asperity.InputError,
     "press ran without friction_coefficient and critical_slip: give them"),
    (lambda: program.run("curve").summary, KeyError, "curve has no table summary; there are data"),
])
def test_refusals(call, kind, message):
    with pytest.raises(kind, match=message):
        call()


def test_properties_of_a_press():
    """Friction, that it has none of, is filled in; what it has stays."""
    pressed = program.run("press", sigma=0.05)
    filled = program.law_properties(pressed, pair="transverse-tangential", critical_slip=0.2)
    assert filled == wood(sigma=0.05, initial_separation=0.2, critical_slip=0.2)


def test_short_words():
    """A result in a line or two, though it holds hundreds of values."""
    assert len(repr(program.run("press"))) < 1000
