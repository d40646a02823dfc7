"""Rows of the table of differences: each is a check as well."""

COUNTS = {"passed": 0, "failed": 0}


def check(name, good, found=""):
    """One check; what was found is shown whether it passed or not."""
    COUNTS["passed" if good else "failed"] += 1
    print(f"{'ok  ' if good else 'FAIL'} {name}{': ' if found else ''}{found}", flush=True)
    return good


class Table:
    """Differences of asperity from others, in the order in which they were found."""

    def __init__(self):
        self.rows = []
        # Load, gap/Sq, real area over nominal by tamaas and by Nayak's route, then pressures over the load: Gaussian law by
        # Nayak's route and by the paper's, summits with one radius, with their own, dependent ones
        self.contact = []

    def compare(self, where, quantity, asperity, other, value, low, high, reason):
        """One value of asperity beside another program's; low <= asperity/value - 1 <= high.

        The reason says why they may differ at all."""
        off = asperity/value - 1 if value else float("inf")
        check(f"{where}: {quantity} by {other}", low <= off <= high,
              f"{value:.10g}, asperity {asperity:.10g}, {off:+.1e} of it off "
              f"({low:+.1e} to {high:+.1e} allowed)")
        self.rows.append((quantity, where, asperity, other, value, off, reason))

    def same(self, where, quantity, asperity, other, value, tolerance, absolute=0.0):
        """The same, where the definitions are: within tolerance of the value, or absolutely."""
        limit = max(tolerance, absolute/abs(value) if value else float("inf"))
        self.compare(where, quantity, asperity, other, value, -limit, limit, "same definition")

    def markdown(self):
        """Rows whose definitions are the same take one line a quantity, with the largest
        difference on any map."""
        lines = ["| quantity | map | asperity | other program | its value | asperity is | why |",
                 "|---|---|---|---|---|---|---|"]
        worst = {}
        for row in self.rows:
            if row[6] == "same definition":
                key = row[0], row[3]
                kept = worst.get(key)
                worst[key] = (row if kept is None or abs(row[5]) > abs(kept[0][5]) else kept[0],
                              1 if kept is None else kept[1] + 1)
        for (quantity, other), (row, count) in worst.items():
            lines.append(f"| {quantity} | {count} maps, worst {row[1]} | {row[2]:.6g} | {other} | "
                         f"{row[4]:.6g} | {abs(row[5]):.0e} of it off | same definition |")
        for quantity, where, asperity, other, value, off, reason in self.rows:
            if reason != "same definition":
                lines.append(f"| {quantity} | {where} | {asperity:.4g} | {other} | {value:.4g} | "
                             f"{100*off:+.2f} % | {reason} |")
        if self.contact:
            lines += ["", "| pressure, MPa | mean gap/Sq | real area | by the law, Nayak's route "
                      "| its pressure | the paper's route | sum, one radius | sum, own radii | with interaction "
                      "and elliptic summits |", "|---|---|---|---|---|---|---|---|---|"]
            lines += [f"| {load:g} | {gap:.2f} | {100*area:.2f} % | "
                      f"{100*own_area:.2f} % | " + " | ".join(f"{r:.2f}" for r in ratios) + " |"
                      for load, gap, area, own_area, *ratios in self.contact]
        return "\n".join(lines) + "\n"
