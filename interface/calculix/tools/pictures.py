"""Pictures of contact faces and of the deformed mesh, by gnuplot."""

import math
import os
import shutil
import subprocess
import textwrap

from .files.whole_file import whole_file

STATES = {"open": (0, "#56b4e9"), "slip": (1, "#009e73"), "stick": (2, "#d55e00"),
          "closed": (2, "#d55e00")}
PRESSURE_PALETTE = ("defined (0 '#f2f2f2', 0.02 '#fff3b8', 0.25 '#fdbb63', 0.5 '#f4713b', "
                    "0.75 '#c4302b', 1 '#6d0f26')")
AXES = "xyz"


class PictureError(Exception):
    """Why there is no picture."""


def draw(path, script, width, height):
    """Have gnuplot draw a script into a file, whole or not at all."""
    ending = os.path.splitext(path)[1].lower()
    terminal = {".svg": f"svg size {width},{height} font 'sans-serif,13' background '#ffffff'",
                ".png": f"pngcairo size {width},{height} font 'sans-serif,11'"}.get(ending)
    if terminal is None:
        raise PictureError(f"{path} has no known ending: .svg or .png")
    if shutil.which("gnuplot") is None:
        raise PictureError("gnuplot is not installed; on Debian: apt-get install gnuplot-nox")
    with whole_file(path) as part:
        text = f"set terminal {terminal}\nset output '{quoted(part)}'\n{script}\nunset output\n"
        done = subprocess.run(["gnuplot"], input=text, capture_output=True, text=True, check=False)
        if done.returncode != 0 or os.path.getsize(part) == 0:
            said = done.stderr.strip().splitlines()
            raise PictureError(f"{path}: gnuplot failed: {said[-1] if said else 'no picture'}")


def quoted(text):
    """Inside single quotes of gnuplot."""
    return text.replace("'", "''")


def plane(nodes, faces):
    """The two axes, and the third, that show a flat surface best."""
    normal = [0.0]*3
    for face in faces:
        p = [nodes[n] for n in face]
        a = [p[2][i] - p[0][i] for i in range(3)]
        b = [p[3][i] - p[1][i] for i in range(3)]
        for i in range(3):
            normal[i] += a[(i + 1) % 3]*b[(i + 2) % 3] - a[(i + 2) % 3]*b[(i + 1) % 3]
    third = max(range(3), key=lambda i: abs(normal[i]))
    return [i for i in range(3) if i != third], third


def quads(nodes, faces, axes, values, pieces):
    """gnuplot's lines of faces in a plane. In one piece a face shades between its corners; in four,
    each corner's quarter has the corner's colour."""
    lines = []
    for face in faces:
        corners = [[nodes[n][i] for i in axes] for n in face]
        if pieces == 1:
            c = [f"{x:.6g} {y:.6g} {values[n]:.6g}" for (x, y), n in zip(corners, face)]
            lines += [c[0], c[1], "", c[3], c[2], "", ""]
            continue
        middle = [sum(c[i] for c in corners)/4.0 for i in (0, 1)]
        for k in range(4):
            here, after, before = corners[k], corners[(k + 1) % 4], corners[k - 1]
            p = [here, [(here[i] + after[i])/2.0 for i in (0, 1)], middle,
                 [(here[i] + before[i])/2.0 for i in (0, 1)]]
            c = [f"{x:.6g} {y:.6g} {values[face[k]]:.6g}" for x, y in p]
            lines += [c[0], c[1], "", c[3], c[2], "", ""]
    return "\n".join(lines)


def faces_picture(path, mesh, points, title, quantity):
    """Contact faces, a row for each increment and a column for each slave surface.

    points: {(step, increment): [Point]}; quantity is 'pressure' or 'state'."""
    surfaces = mesh.slave_faces()
    shapes = [shape(mesh, faces) for _, faces in surfaces]
    keys = list(points)
    columns = min(len(keys), 4)
    # one scale for all surfaces
    left, right, head, gap_x, gap_y = 10, 135, 52, 96, 70
    wide = max(w for w, _ in shapes)
    scale = min(max(170.0, min(340.0, 1150.0/columns))/wide, 380.0/max(h for _, h in shapes))
    heights = [max(h*scale, 24.0) for _, h in shapes]
    block = sum(heights) + gap_y*len(surfaces)
    width = max(540, int(left + right + columns*(wide*scale + gap_x)))
    height = int(head + block*(-(-len(keys)//columns)))
    script = [data(mesh, surfaces, points, quantity),
              f"set multiplot title '{quoted(title)}' font ',14' offset 0,-0.3",
              "set pm3d map corners2color " + ("c1" if quantity == "state" else "mean"),
              "unset key; set tics out nomirror scale 0.5; set border lw 0.5",
              "set xtics font ',9' offset 0,0.4; set ytics font ',9' offset 0.6,0",
              *colours(points, quantity)]
    for number, key in enumerate(keys):
        row, column = divmod(number, columns)
        y0 = head + row*block + 16
        for surface, (pair, faces) in enumerate(surfaces):
            axes, _ = plane(mesh.nodes, faces)
            low, high = limits(mesh, faces)
            x0 = left + 54 + column*(wide*scale + gap_x)
            place = (x0/width, (x0 + (high[0] - low[0])*scale)/width,
                     1.0 - (y0 + heights[surface])/height, 1.0 - y0/height)
            caption = f"{pair.slave}: step {key[0]}, time {points[key][0].time:.4g}"
            script += [
                "set lmargin at screen {:.5f}; set rmargin at screen {:.5f}; "
                "set bmargin at screen {:.5f}; set tmargin at screen {:.5f}".format(*place),
                "set colorbox user origin screen "
                f"{(width - right + 18)/width:.5f},{1.0 - (head + 16 + block - gap_y)/height:.5f} "
                f"size screen {16/width:.5f},{(block - gap_y)/height:.5f}"
                if number == surface == 0 else "unset colorbox",
                f"set xrange [{low[0]:.6g}:{high[0]:.6g}]; set yrange [{low[1]:.6g}:{high[1]:.6g}]",
                f"set xtics {step_of(high[0] - low[0], wide*scale)}; "
                f"set ytics {step_of(high[1] - low[1], heights[surface])}",
                f"set title '{quoted(textwrap.shorten(caption, 60))}' offset 0,-0.7 "
                "font ',10' noenhanced",
                f"set xlabel '{AXES[axes[0]]}, mm' offset 0,0.9 font ',9'",
                f"set ylabel '{AXES[axes[1]]}, mm' offset 1.2,0 font ',9'",
                f"splot $d{surface}_{number} using 1:2:3 with pm3d"]
            y0 += heights[surface] + gap_y
    draw(path, "\n".join(script + ["unset multiplot"]), width, height)


def step_of(length, pixels):
    """Distance of the ticks: 1, 2 or 5 times a power of ten, at least 45 pixels."""
    least = length*45.0/max(pixels, 1.0)
    power = 10.0**math.floor(math.log10(least))
    return next(f"{m*power:.6g}" for m in (1, 2, 5, 10) if m*power >= least)


def limits(mesh, faces):
    """Lower left and upper right corner of a surface in its plane."""
    axes, _ = plane(mesh.nodes, faces)
    used = {n for face in faces for n in face}
    return ([min(mesh.nodes[n][i] for n in used) for i in axes],
            [max(mesh.nodes[n][i] for n in used) for i in axes])


def shape(mesh, faces):
    """Width and height of a surface in its plane."""
    low, high = limits(mesh, faces)
    return [high[i] - low[i] for i in (0, 1)]


def colours(points, quantity):
    """gnuplot's commands for palette and colour box."""
    if quantity == "state":
        return [f"set palette maxcolors 3 defined (0 '{STATES['open'][1]}', "
                f"1 '{STATES['slip'][1]}', 2 '{STATES['stick'][1]}')",
                "set cbrange [-0.5:2.5]; set cbtics ('open' 0, 'slip' 1, "
                f"'{'stick' if has_friction(points) else 'closed'}' 2) scale 0"]
    most = max((p.pressure for rows in points.values() for p in rows), default=0.0)
    return [f"set palette {PRESSURE_PALETTE}", f"set cbrange [0:{most or 1.0:.6g}]",
            "set cbtics autofreq; set pm3d interpolate 6,6",
            "set cblabel 'contact pressure, MPa' offset 1,0"]


def has_friction(points):
    """Is it known which points stick?"""
    return all(p.state != "closed" for rows in points.values() for p in rows)


def data(mesh, surfaces, points, quantity):
    """gnuplot's data blocks of all panels."""
    text = []
    for row, rows in enumerate(points.values()):
        for column, (pair, faces) in enumerate(surfaces):
            values = {p.node: STATES[p.state][0] if quantity == "state" else max(p.pressure, 0.0)
                      for p in rows if p.pair == pair.slave}
            axes, _ = plane(mesh.nodes, faces)
            text.append(f"$d{column}_{row} << END\n"
                        + quads(mesh.nodes, faces, axes, values, 4 if quantity == "state" else 1)
                        + "\nEND")
    return "\n".join(text)


def mesh_picture(path, mesh, moved, values, options):
    """The deformed skin of some elements, coloured by a nodal quantity.

    moved: {node: displacement}; values: {node: number}; options: title, label, scale, view
    (rotation about the horizontal and about z, degrees), elements (a set, or None)."""
    chosen = None
    if options.get("elements"):
        chosen = mesh.element_sets.get(options["elements"].upper())
        if not chosen:
            raise PictureError(f"no element set {options['elements']}")
        chosen = set(chosen)
    part = type(mesh)([])
    part.elements = {e: c for e, c in mesh.elements.items() if chosen is None or e in chosen}
    scale, lines = options["scale"], []
    for face in part.skin():
        c = []
        for n in face:
            u = moved.get(n, (0.0, 0.0, 0.0))
            x = [mesh.nodes[n][i] + scale*u[i] for i in range(3)]
            c.append(f"{x[0]:.6g} {x[1]:.6g} {x[2]:.6g} {values.get(n, 0.0):.6g}")
        lines += [c[0], c[1], "", c[3], c[2], "", ""]
    if not lines:
        raise PictureError("the deck has no hexahedra to draw")
    numbers = [values.get(n, 0.0) for c in part.elements.values() for n in c]
    low, high = min(numbers), max(numbers)
    if low >= 0.0:
        palette, low = PRESSURE_PALETTE, 0.0
    else:
        high = max(-low, high)
        low = -high
        palette = "defined (-1 '#2166ac', -0.5 '#92c5de', 0 '#f7f7f7', 0.5 '#f4a582', 1 '#b2182b')"
    script = ["$skin << END", *lines, "END",
              f"set title '{quoted(options['title'])}' noenhanced",
              "set view equal xyz; set view {:g},{:g}".format(*options["view"]),
              "set pm3d depthorder corners2color mean border lc rgb '#404040' lw 0.25",
              f"set palette {palette}",
              f"set cbrange [{low:.6g}:{high if high > low else low + 1:.6g}]",
              f"set cblabel '{quoted(options['label'])}'", "unset key; unset border; unset tics",
              "set cbtics", "set colorbox user origin 0.88,0.2 size 0.02,0.6",
              "set lmargin 0; set rmargin 12; set bmargin 0",
              "splot $skin using 1:2:3:4 with pm3d"]
    draw(path, "\n".join(script), 1000, 720)


def mises(s):
    """Mises stress of (xx, yy, zz, xy, yz, zx)."""
    return math.sqrt(max(0.0, 0.5*((s[0] - s[1])**2 + (s[1] - s[2])**2 + (s[2] - s[0])**2)
                         + 3.0*(s[3]**2 + s[4]**2 + s[5]**2)))
