"""The package beside interface/c/asperity.h: every constant, member, function and argument."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import asperity
import pytest
from asperity import _library, contact, errors, faces, properties

HEADER = (Path(__file__).parents[2] / "interface/c/asperity.h").read_text(encoding="utf-8")
CODE = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.DOTALL)
KINDS = {"size_t": "size_t", "double": "c_double", "int": "c_int", "char": "c_char"}


def enumeration(name):
    """The names, less the prefix, and values of an enumeration."""
    body = re.search(rf"enum asperity_{name} \{{(.*?)\}}", CODE, re.DOTALL)[1]
    return {key.removeprefix("ASPERITY_"): int(value)
            for key, value in re.findall(r"(\w+) = (\d+)", body)}


def macro(name):
    return float(re.search(rf"#define ASPERITY_{name} \(?([-\w.]+)\)?", CODE)[1])


def members(name):
    """Members of a struct in order: name, type, lengths."""
    body = re.search(rf"typedef struct asperity_{name} \{{(.*?)\}} asperity_{name};", CODE,
                     re.DOTALL)[1]
    found = []
    for kind, names in re.findall(r"(\w+) ([^;]+);", body):
        for member in names.split(","):
            lengths = re.findall(r"\[(\w+)\]", member)
            found.append((member.split("[")[0].strip(), kind, [
                int(macro(length.removeprefix("ASPERITY_"))) if length.startswith("ASPERITY")
                else int(length) for length in lengths]))
    return found


def test_constants():
    assert enumeration("status") == {s.name: s.value for s in asperity.Status}
    assert enumeration("validity") == {v.name: v.value for v in asperity.Validity}
    assert macro("FOUR_SIGMA") == asperity.FOUR_SIGMA
    assert macro("NO_OPPOSITE_SURFACE") == asperity.NO_OPPOSITE_SURFACE
    assert macro("MOST_FRICTION_POINTS") == _library.MOST_FRICTION_POINTS
    assert macro("MOST_STICK_ELEMENTS") == _library.MOST_STICK_ELEMENTS


def test_words():
    """Words of the package and constants of the header are one for one."""
    words = {**properties.WORDS, "section": faces.SECTIONS, "hardness_rule": faces.HARDNESS_RULES,
             "roughness_rule": faces.ROUGHNESS_RULES}
    prefixes = {"friction_rule": "RULE", "slip_integration": "SLIP", "height_distribution": "HEIGHTS",
                "hardness_rule": "HARDNESS", "roughness_rule": "ROUGHNESS"}
    for name, values in words.items():
        of_header = enumeration(name)
        prefix = prefixes.get(name, name.upper()) + "_"
        expected = {key.removeprefix(prefix).lower(): value for key, value in of_header.items()}
        if name == "slip_direction":  # ASPERITY_SLIP_ASSOCIATED, _OF_STRESS: case files say stress
            expected = {"associated": of_header["SLIP_ASSOCIATED"],
                        "stress": of_header["SLIP_OF_STRESS"]}
        assert values == expected, name
    enums = set(re.findall(r"enum asperity_(\w+)", CODE))
    assert enums == {*words, "code", "status", "validity"}


def test_codes():
    """Every code has its exception."""
    kinds = {"COMPUTATION_ERROR": errors.ComputationError, "NO_MEMORY": errors.NoMemoryError}
    for name, code in enumeration("code").items():
        if name != "OK":
            problem = errors.of_code(code, "text")
            assert type(problem) is kinds.get(name, errors.InputError)
            assert str(problem) == "text"


def test_structs():
    structs = {"error": _library.ErrorStruct, "face": _library.FaceStruct,
               "properties": _library.PropertiesStruct, "state": _library.StateStruct}
    assert set(re.findall(r"typedef struct asperity_(\w+) \{", CODE)) == set(structs)
    for name, struct in structs.items():
        of_package = []
        for member, kind in struct._fields_:
            lengths = []
            while hasattr(kind, "_length_"):
                lengths.append(kind._length_)
                kind = kind._type_
            of_package.append((member, kind, lengths))
        for (name_h, kind_h, lengths_h), (name_p, kind_p, lengths_p) in zip(
                members(name), of_package, strict=True):
            assert (name_h, lengths_h) == (name_p, lengths_p)
            # size_t is another name of c_ulong
            assert kind_p.__name__ == KINDS[kind_h] or kind_h == "size_t"


def test_properties():
    """Each member of the struct but its size and the count of an array is a property."""
    fields = [name for name, _, _ in members("properties") if name not in ("size", "friction_points")]
    assert list(asperity.Properties.__dataclass_fields__) == fields
    assert list(asperity.STATE_TYPE.names) == [name for name, _, _ in members("state")]
    assert contact.STATE_TYPE.itemsize == _library.ctypes.sizeof(_library.StateStruct)


def test_functions():
    """All functions, each with so many arguments; the last is the error."""
    found = dict(re.findall(r"^int asperity_(\w+)\(([^;]*)\);", CODE, re.MULTILINE | re.DOTALL))
    assert set(found) == set(_library.FUNCTIONS)
    for name, arguments in found.items():
        of_header = [" ".join(argument.split()) for argument in arguments.split(",")]
        assert of_header.pop().startswith("asperity_error *")
        of_package = _library.FUNCTIONS[name]
        assert len(of_header) == len(of_package), name
        for argument, kind in zip(of_header, of_package, strict=True):
            scalar = {"int": "c_int", "double": "c_double", "size_t": "c_ulong"}.get(
                argument.split()[0])
            if "*" in argument:
                assert kind.__name__ in ("c_void_p", "c_char_p") or "LP_" in kind.__name__, name
            else:
                assert kind.__name__ == scalar, (name, argument)


def sources(folder):
    """Copy the package without its library."""
    return shutil.copytree(Path(asperity.__file__).parent, folder/"asperity",
                           ignore=shutil.ignore_patterns("*.so", "__pycache__"))


def test_sources_to_be_edited(tmp_path):
    """By pip install -e the library stands elsewhere."""
    code = """
import importlib.util, sys
spec = importlib.util.spec_from_file_location(
    "asperity", sys.argv[1] + "/__init__.py", submodule_search_locations=sys.argv[1:])
sys.modules["asperity"] = asperity = importlib.util.module_from_spec(spec)
spec.loader.exec_module(asperity)
print(asperity.__file__, asperity.__version__)"""
    folder = sources(tmp_path)
    said = subprocess.run([sys.executable, "-c", code, folder, Path(asperity.__file__).parent],
                          capture_output=True, text=True, check=True).stdout
    assert said.split() == [f"{folder}/__init__.py", asperity.__version__]


@pytest.mark.parametrize("library", [None, b"text"], ids=["none", "text"])
def test_library_that_is_not_there(tmp_path, library):
    """As in the folder of the sources."""
    sources(tmp_path)
    if library is not None:
        (tmp_path/"asperity"/"libasperity_c.so").write_bytes(library)
    said = subprocess.run([sys.executable, "-c", "import asperity"], cwd=tmp_path, capture_output=True,
                          text=True, check=False).stderr.splitlines()[-1]
    assert said.startswith("ImportError")
    assert "install them by pip" in said
