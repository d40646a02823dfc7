"""The program from Python: what it found arrives whole, and what it says, too."""

import csv
import dataclasses
import io
import subprocess
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
