"""Reader of what *NODE PRINT writes into ccx's .dat file."""

import re
from collections import namedtuple

# quantity: 'displacements', 'forces' or 'total force'; rows: [(node or None, (x, y, z))]
Block = namedtuple("Block", "quantity set time rows")

HEADER = re.compile(r"\s*(displacements|forces|total force) \([^)]*\) for set (\S+) "
                    r"and time\s+(\S+)")
LOST_E = re.compile(r"^([-+]?\d*\.\d*)([-+]\d{3})$")


def number(text):
    """A Fortran number, also one whose three-digit exponent took the place of its E."""
    return float(LOST_E.sub(r"\1E\2", text.strip()))


def blocks(path):
    """Yield the blocks of a .dat file. A last block that was cut short is left out."""
    block, closed = None, False
    with open(path, encoding="ascii", errors="replace") as file:
        for line in file:
            found = HEADER.match(line)
            if found or (block and block.rows and not line.strip()):
                if block and block.rows:
                    yield block
                block = None
                if found:
                    block = Block(found[1], found[2], number(found[3]), [])
            elif block is not None and line.strip():
                values = line.split()
                try:
                    if block.quantity == "total force":
                        block.rows.append((None, tuple(map(number, values[:3]))))
                    else:
                        block.rows.append((int(values[0]), tuple(map(number, values[1:4]))))
                except ValueError:
                    block = None
            closed = line.endswith("\n")
    if block and block.rows and closed and len(block.rows[-1][1]) == 3:
        yield block


def by_time(path, name, gauge=None):
    """[(time, mean displacement, total force)] of a node set, in the order of the file; the
    displacement that of another set, the gauge, if there is one.

    Mean displacement and force are (x, y, z), or None where the deck did not ask for them."""
    records = []
    for block in blocks(path):
        moves = block.quantity == "displacements"
        if block.set != ((gauge or name) if moves else name):
            continue
        values = list(zip(*(row for _, row in block.rows)))
        if moves:
            position, vector = 1, tuple(sum(v)/len(v) for v in values)
        else:
            position, vector = 2, tuple(sum(v) for v in values)
        if not records or records[-1][0] != block.time or records[-1][position] is not None:
            records.append([block.time, None, None])
        records[-1][position] = vector
    return [tuple(record) for record in records]
