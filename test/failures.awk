# What failed in a run of ctest: awk -f failures.awk LastTest.log CONSOLE
# First line: tests passed, tests failed. Then a line for each failure with the name of its ctest and,
# below it, what the test said of it. A ctest that failed without counting one is a failure, too:
# its last lines are shown.
FNR == 1 { file++ }
file == 1 && /^[0-9]+\/[0-9]+ Testing: / { name = $3; lines = 0; said = 0 }
file == 1 && /^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3; counted[name] += $3 }
file == 1 && /^FAIL/ { text = text "\n  " name ": " $0; said = 1; next }
file == 1 && said && /^ +\|/ { text = text "\n  " $0; next }
file == 1 { said = 0; if (/^<end of output>/) ended[name] = lines; else kept[name, lines++] = $0 }
file == 2 && /Test +#[0-9]+: .*\*\*\*/ && !/\*\*\*Skipped/ {
   sub(/.*Test +#[0-9]+: /, "")
   if (!counted[$1]) {
      failed++
      name = $1
      sub(/[^*]*/, "")
      text = text "\n  " name ": " $0
      for (i = ended[name] - 12; i < ended[name]; i++)
         if ((name, i) in kept) text = text "\n       | " kept[name, i]
   }
}
END { print passed + 0, failed + 0 text }
