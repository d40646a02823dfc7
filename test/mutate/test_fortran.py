#!/usr/bin/env python3
"""What is changed in a source, and what is not."""

import sys

from fortran import mutants_of
from suites import suites_of

SOURCE = """!> Comment + 1 < 2
module m
   use k, only: wp
   implicit none
   real(wp), parameter :: limit = 0.5_wp, small = 1.0e-9_wp, sizes(*) = [3, 4]
   type :: t
      real(wp) :: default = 2.0_wp
   end type t
contains
   pure subroutine s(a, b) ! 1 + 1
      real(wp), intent(inout) :: a, b(3)

      if (a <= limit .and. b(2) == 0.0_wp) return
      a = -a + &
         1.5e-3_wp*b(1)
      p => b
      call fail('less < 1 - it''s')
   end subroutine s
end module m
"""

# file line, kind, what is there, what comes
EXPECTED = {
    (5, 'constant', '0.5_wp', '0.55_wp'), (5, 'constant', '0.5_wp', '0.45_wp'),
    (5, 'constant', '[3, 4]', '[4, 4]'), (5, 'constant', '[3, 4]', '[2, 4]'),
    (5, 'constant', '[3, 4]', '[3, 5]'), (5, 'constant', '[3, 4]', '[3, 3]'),
    (13, 'comparison', 'a <= limit', 'a < limit'), (13, 'comparison', 'a <= limit', 'a > limit'),
    (13, 'comparison', 'b(2) == 0.0_wp', 'b(2) /= 0.0_wp'),
    (13, 'constant', 'b(2)', 'b(3)'), (13, 'constant', 'b(2)', 'b(1)'),
    (13, 'constant', '0.0_wp', '1.0_wp'),
    (13, 'statement', 'return', '(dropped)'),
    (14, 'sign', '-a + ', '+a + '), (14, 'sign', '-a + ', '-a - '),
    (14, 'statement', 'a = -a + 1.5e-3_wp*b(1)', '(dropped)'),
    (15, 'constant', '1.5e-3_wp', '1.65e-3_wp'), (15, 'constant', '1.5e-3_wp', '1.35e-3_wp'),
    (15, 'constant', 'b(1)', 'b(2)'), (15, 'constant', 'b(1)', 'b(0)'),
    (16, 'statement', 'p => b', '(dropped)'),
    (17, 'statement', 'call fail', '(dropped)'),
}


def main():
    results = []

    def check(good, what):
        results.append(good)
        if not good:
            print(f'FAIL {what}')

    found = list(mutants_of('src/law/m.f90', SOURCE))
    for line, kind, before, after in sorted(EXPECTED):
        # the change alone: what is before and behind it stays
        check(sum(m.first + 1 == line and m.kind == kind and before in m.before
                  and (m.after == after or m.after == m.before.replace(before, after, 1))
                  for m in found) == 1, f'line {line}: {before} -> {after}')
    check(len(found) == len(EXPECTED), f'{len(found)} changes, not {len(EXPECTED)}')
    check(len({m.id for m in found}) == len(found), 'each has a name of its own')
    moved = [m.id for m in mutants_of('src/law/m.f90', '\n\n' + SOURCE)]
    check(moved == [m.id for m in found], 'which lines before it do not change')
    check(suites_of('src/law/quadrature/heights.f90')[0] == 'law_tests', 'the suites of a folder')
    check(suites_of('src/program/main.f90') == [], 'the program is not changed')
    print(f'{sum(results)} passed, {len(results) - sum(results)} failed')
    return 0 if all(results) else 1


if __name__ == '__main__':
    sys.exit(main())
