"""Rows on what the paper found of its joint (Figs 23-35, Table 5), and what a model says to each.

A check takes a results.Joint and gives (verdict, number); a KeyError is a number that the model has not.
"""

YES, NO, OPEN = "yes", "no", "-"
SMALL, STEEP = 4.0, 8.0  # mm: "less than 4 mm"; 0.016 rad
CLOSE = 0.05  # "very close", "little difference"


def percent(ratio):
    # no sign of a change that rounds to nothing
    return f"{100.0*(ratio - 1.0):+.1f} %".replace("-0.0 %", "0.0 %").replace("+0.0 %", "0.0 %")


def verdict(holds):
    return YES if holds else NO


def pull_out(joint):
    hard, rough = joint.last("largest_pull_out")
    return verdict(min(abs(hard), abs(rough)) > 1.0), f"{rough:.1f} mm"


def crushing(joint):
    work = joint.last("plastic_dissipation")
    return verdict(min(work) > 0.0), f"{work[1]:.0f} J of plastic work"


def pinching(joint):
    hard, rough = joint.last("pinching")
    return verdict(max(hard, rough) < 0.5), f"{hard:.2f} hard, {rough:.2f} rough"


def fuller(joint):
    ratio = joint.ratios("energy")[-1][1]
    return verdict(ratio > 1.0), f"{percent(ratio)} area"


def higher(joint):
    ratio = joint.ratios("negative_moment")[-1][1]
    return verdict(ratio > 1.0), f"{percent(ratio)} peak"


def close_early(joint):
    ratios = [r for u, r in joint.ratios("secant_stiffness") if u <= SMALL]
    return verdict(max(abs(r - 1.0) for r in ratios) < CLOSE), ", ".join(map(percent, ratios))


def rising_flat(joint):
    moments = [(u, -m) for u, _, m in joint.series("negative_moment")]
    grows = all(b[1] > a[1] for a, b in zip(moments, moments[1:]))
    (u0, m0), (u1, m1) = moments[-2:]
    tail, head = (m1 - m0)/(u1 - u0), moments[0][1]/moments[0][0]
    return verdict(grows and tail < 0.25*head), f"{100.0*tail/head:.0f} % of the first slope left at the end"


def symmetric(joint):
    worst = max(abs(up[k]/-down[k] - 1.0) for up, down in zip(
        joint.series("positive_moment"), joint.series("negative_moment")) for k in (1, 2)
        if down[k] != 0.0)
    return verdict(worst < CLOSE), f"within {100.0*worst:.1f} %"


def over_hard(quantity, published):
    """A ratio to hard contact is found again when it is more than half of the paper's."""
    def check(joint):
        hard, rough = joint.last(quantity)
        return verdict(rough/hard - 1.0 > 0.5*(published - 1.0)), percent(rough/hard)
    return check


def falls(joint):
    both = list(zip(*joint.series("secant_stiffness")))[1:]
    good = all(a > b for k in both for a, b in zip(k, k[1:]))
    return verdict(good), "; ".join(f"{k[0]:.0f}, {k[len(k)//2]:.0f}, {k[-1]:.0f} {name}" for k, name in
                                    zip(both, ("hard", "rough"))) + " kN m/rad"


def steep_then_gentle(joint):
    series = joint.series("secant_stiffness")
    parts = [(series[0][k] - next(row[k] for row in series if row[0] >= STEEP))
             /(series[0][k] - series[-1][k]) for k in (1, 2)]
    return verdict(min(parts) > 0.5), f"{100.0*parts[0]:.0f} % hard, {100.0*parts[1]:.0f} % rough " \
        "of the fall up to 0.016 rad"


def total_energy(joint):
    hard, rough = joint.last("cumulative_energy")
    return verdict(rough > hard), f"{percent(rough/hard)} of {hard/1e3:.1f} kJ"


def contact_area(place):
    """Area of upper and lower face that sticks or slips, at the reverse peak (-1) or after it (0)."""
    def check(joint):
        areas = [0.0, 0.0]
        for face in ("upper", "lower"):
            for name in ("area_stick", "area_slip"):
                areas = [a + v for a, v in zip(areas, joint.back(name, face)[place][1:])]
        return verdict(areas[1] > areas[0]), percent(areas[1]/areas[0])
    return check


def stress(joint):
    """Largest pressure of upper and lower face at the reverse peak."""
    rows = [joint.back("largest_pressure", face)[-1][1:] for face in ("upper", "lower")]
    hard, rough = (max(row[k] for row in rows) for k in (0, 1))
    return verdict(rough/hard - 1.0 > 0.5*0.155), f"{percent(rough/hard)}, {hard:.1f} MPa hard"


def stress_place(joint):
    """Where the pressure is largest at -48 mm, mm from the column face outwards."""
    upper, lower = joint.last("place", "upper"), joint.last("place", "lower")
    deep = joint.last("place_deepest")[0]
    return verdict(max(upper) < 0.8*deep and min(lower) > 0.2*deep), f"upper face {upper[1]:.0f} mm from the " \
        f"column face, lower {lower[1]:.0f} mm"


def forces_apart(joint):
    ratios = joint.ratios("peak_force")
    early, late = ratios[0], ratios[-1]
    return verdict(abs(early[1] - 1.0) < CLOSE and late[1] > early[1]), ", ".join(
        f"{percent(r)} at {u:g} mm" for u, r in (early, ratios[len(ratios)//2], late))


def force_larger(joint):
    ratio = joint.ratios("peak_force")[-1][1]
    return verdict(ratio > 1.0), percent(ratio)


def friction(joint):
    hard, rough = joint.last("friction_dissipation")
    return verdict(rough > hard), f"{rough - hard:+.0f} J, {percent(rough/hard)}"


def friction_late(joint):
    gains = [(rough - hard) for _, hard, rough in joint.series("friction_dissipation")]
    shown = [gains[i] for i in (0, len(gains)//2, -1)]
    return verdict(shown[2] > shown[1] > shown[0]), ", ".join(f"{v:+.0f}".replace("-0", "+0")
                                                             for v in shown) + " J"


def penalty(quantity, stiffness):
    """Rough over hard contact that is enforced by a penalty."""
    def check(joint):
        ratios = joint.ratios(f"{quantity}_penalty_{stiffness}")
        shown = [row for row in ratios if row[0] == SMALL] + ratios[-1:]
        return OPEN, ", ".join(f"{percent(r)} at {abs(u):g} mm" for u, r in shown)
    return check


SMALLER = "the rough law acts as a clearance smaller by d0, which matters less the larger the rotation"

# id, what covers, what the paper says, check, why
ROWS = [
    ("F23a", "Figs 23a, 24", "the tenon is pulled out", pull_out, ""),
    ("F23b", "Figs 23b, 23c, 24", "tenon neck and mortise are crushed for good", crushing, ""),
    ("F25", "Fig. 25", "anti-S loops, obvious pinching (0 slack, 1 not pinched)", pinching, ""),
    ("F26a", "Fig. 26", "rough loop at 48 mm is fuller", fuller, ""),
    ("F26b", "Fig. 26", "its peak is higher", higher, ""),
    ("F27", "Fig. 27", "below 4 mm both models are very close (stiffness at 0.5, 1, 2, 4 mm)",
     close_early, SMALLER),
    ("F28a", "Fig. 28", "skeleton rises and flattens", rising_flat, "CalculiX: elastic wood"),
    ("F28b", "Fig. 28", "skeleton of the models is symmetric", symmetric,
     "CalculiX: not up to 2 mm, solid: not up to 4 mm, where the first stroke starts from rest"),
    ("T5a", "Table 5", "yield moment +12.5 %", over_hard("yield_moment", 18.03/16.02),
     "wood yields at the same pressure under both"),
    ("T5b", "Table 5", "ultimate moment +10.8 %", over_hard("ultimate_moment", 19.84/17.91),
     "faces close by 0.14 mm at fc90, edges press in by 10 mm"),
    ("T5c", "Table 5", "stiffness K +6.1 %", over_hard("bending_stiffness", 163.82/154.39), "as T5b"),
    ("F29a", "Fig. 29", "stiffness falls from the first rotation on, in both models (first, middle, last)",
     falls, "solid: column and beam bend while the sides stick, and clearance closes by 4 mm; "
     "CalculiX: elastic wood besides"),
    ("F29b", "Fig. 29", "steeply up to 0.016 rad, gently after", steep_then_gentle,
     "as F29a"),
    ("F30", "Fig. 30", "rough dissipates more in all", total_energy, ""),
    ("F31", "Fig. 31", "at -48 mm more of the rough faces sticks and slips", contact_area(-1), ""),
    ("F32", "Fig. 32", "so it does when unloading", contact_area(0), ""),
    ("F33a", "Fig. 33", "largest contact stress +15.5 %", stress,
     "yield caps it in the plane; solid: one cell at a rim, -10 to +19 % with mesh and programme; CalculiX: elastic wood, "
     "one node; part is the penalty's, see below"),
    ("F33b", "Fig. 33", "it sits at the end and the neck of the tenon (-48 mm)", stress_place, ""),
    ("F34a", "Fig. 34", "contact forces equal early, apart late", forces_apart, "as F27: the reverse"),
    ("F34b", "Fig. 34", "late, the rough one is larger", force_larger, ""),
    ("F35a", "Fig. 35", "friction dissipates more under the rough law", friction, ""),
    ("F35b", "Fig. 35", "and ever more so (first, middle, last amplitude)", friction_late,
     "solid: up to 8 mm upper and lower face touch sooner and the sides slip less"),
]

# The same of hard contact that gives: what its enforcement makes of the ratios
PENALTIES = [(f"P{k}{letter}", "Table 5, Fig. 33", f"{words}, hard contact of {k} MPa/mm",
              penalty(quantity, k), "") for letter, quantity, words in
             (("a", "moment", "moment"), ("b", "pressure", "stress")) for k in (100, 1000, 10000)]
