"""Which suites, by their names for ctest, run for a mutant in which folder, those most likely to
see it first. The longest folder that fits a file counts; files of no folder here are not mutated."""

FOLDERS = {
    'src/base': ['base', 'law', 'contact', 'height_map', 'deck', 'replay', 'abaqus', 'surface'],
    'src/paper': ['law', 'replay'],
    'src/law': ['law', 'contact', 'abaqus'],
    'src/contact': ['contact', 'abaqus', 'replay', 'c'],
    'src/replay': ['replay', 'abaqus'],
    'src/hysteresis': ['hysteresis'],
    'src/height_map': ['height_map', 'surface'],
    'src/surface': ['surface', 'law'],
    'src/wood': ['solid', 'deck'],
    'src/deck': ['deck'],
    'src/solid': ['solid'],
    'interface/abaqus/routines': ['abaqus', 'single', 'replay'],
    'interface/c': ['c'],
}


def suites_of(path):
    """Names of the tests for a file, such as law_tests; none if it is not mutated."""
    folders = [folder for folder in FOLDERS if path.startswith(folder + '/')]
    if not folders:
        return []
    return [suite + '_tests' for suite in FOLDERS[max(folders, key=len)]]
