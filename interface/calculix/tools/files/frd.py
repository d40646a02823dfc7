"""Reader of ccx's results: the ASCII .frd file."""

from collections import namedtuple

from .dat import number

# values: {node: (number, ...)} in the order of components; time is that of the whole programme.
# rows: [(node, (number, ...))] as they stand in the file, where a node can come more than once
Result = namedtuple("Result", "name step increment time components values rows")


class FrdError(Exception):
    """What is wrong with a results file."""


def whole(file):
    """Lines of a file without a last one that was cut short."""
    for line in file:
        if line.endswith("\n"):
            yield line


def results(path, names=None, wanted=None):
    """Yield the results of a file, of given names and where wanted(step, increment).

    A last result that was cut short, by an interruption, is left out."""
    step = increment = 0
    time = 0.0
    result, keep = None, False
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            for line in whole(file):
                mark = line[:3]
                if result is not None and keep and mark == " -1":
                    values = line[13:].rstrip("\n")
                    result.rows.append((int(line[3:13]), tuple(
                        number(values[i:i + 12]) for i in range(0, len(values) - 11, 12))))
                elif mark == " -3":
                    if result is not None and keep:
                        result.values.update(result.rows)
                        yield result
                    result = None
                elif line.startswith("    1PSTEP"):
                    fields = line[10:].split()
                    increment, step = int(fields[1]), int(fields[2])
                elif line.startswith("  100C"):
                    time = number(line[12:24])
                elif mark == " -4":
                    name = line[5:13].strip()
                    keep = ((names is None or name in names)
                            and (wanted is None or wanted(step, increment)))
                    result = Result(name, step, increment, time, [], {}, [])
                elif mark == " -5" and result is not None:
                    result.components.append(line[5:13].strip())
                elif mark == " -2" and result is not None and keep:
                    raise FrdError(f"{path}: results of more than six components are not read")
    except OSError as problem:
        raise FrdError(f"{path}: {problem.strerror}") from problem
    except (ValueError, IndexError) as problem:
        raise FrdError(f"{path}: not a results file of ccx ({problem})") from problem


def times(path):
    """{(step, increment): time} of the results in a file."""
    heads, place = {}, None
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            for line in whole(file):
                if line.startswith("    1PSTEP"):
                    fields = line[10:].split()
                    place = int(fields[2]), int(fields[1])
                elif line.startswith("  100C") and place:
                    heads[place] = number(line[12:24])
    except OSError as problem:
        raise FrdError(f"{path}: {problem.strerror}") from problem
    except (ValueError, IndexError) as problem:
        raise FrdError(f"{path}: not a results file of ccx ({problem})") from problem
    return heads
