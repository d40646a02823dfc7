# Help, version, citation, and what the command line refuses

version=$(sed -n "s/.*version = '\(.*\)'.*/\1/p" "$root/src/base/version.f90")
run --version
check 'version is that of the library' test "$(cat out)" = "asperity $version"
cp out first
run version
check 'version and --version agree' cmp first out
check 'version is quiet' is_quiet

run help
check 'help' is_quiet
check 'help names every command' \
   sh -c 'for c in curve press shear tenon table "deck shear" "deck tenon" hysteresis pairs version help; do grep -q "^  $c " out || exit 1; done'
cp out first
run --help
check '--help is help' cmp first out
for command in curve press shear tenon table hysteresis pairs; do
   run help $command
   cp out first
   run $command --help
   check "$command --help is help $command" cmp first out
   check "$command --help describes its options" has out '--csv FILE'
done
run shear --displacement 3 --help
check '--help among options' has out 'usage: asperity shear'

run --citation
check 'citation has the DOI' has out '10.1186/s10086-021-01963-x'
check 'citation has the paper' has out 'Normal contact performance of mortise and tenon joint'
check 'citation has the version' has out "$version"

run
check 'no arguments: usage and status 2' test "$status" -eq 2
check 'no arguments: usage on standard error' has err 'usage: asperity'
check 'no arguments: nothing on standard output' test ! -s out

run pairs
check 'pairs' is_quiet
check 'pairs lists both pairs' \
   sh -c 'grep -q transverse-tangential out && grep -q tangential-tangential out'
check 'pairs says what the paper printed' has out 'Spd 0.000206 (1/um^2)'
run pairs --csv pairs.csv
check 'pairs: two pairs and nine surfaces' test "$(rows pairs.csv)" -eq 11
run pairs --json -
check 'pairs: no value is null' has out 'null'

refuses 'unknown command' 2 "unknown command 'foo'" foo
refuses 'mistyped command' 2 'unknown command .*did you mean shear' shera
refuses 'help on an unknown command' 2 "unknown command 'foo'" help foo
refuses 'help on two commands' 2 "'press': help takes one command" help curve press
refuses 'unknown option' 2 '--foo: unknown option of curve' curve --foo 3
refuses 'mistyped option' 2 '--sgima: .*did you mean --sigma' curve --sgima 3
refuses 'option of another command' 2 '--rate: is an option of shear' curve --rate 3
refuses 'friction has no effect on press' 2 '--critical-slip: is an option of shear' \
   press --critical-slip 3
refuses 'option without value' 2 '--sigma: needs a value' curve --sigma
refuses 'option without value before another' 2 '--sigma: needs a value' curve --sigma --eta 3
refuses 'option twice' 2 '--sigma: is given twice' curve --sigma 1 --sigma=1
refuses 'value for what takes none' 2 '--print-case: takes no value' curve --print-case=1
refuses 'logical with a wrong value' 2 '--shrinking-overlap: .*neither true nor false' \
   shear --shrinking-overlap=maybe
refuses 'two case files' 2 "'b.nml': there is already" curve a.nml b.nml
refuses 'pairs takes no case file' 2 "'a.nml': pairs takes no case file" pairs a.nml
refuses 'version takes nothing' 2 '--csv: is an option of' --version --csv x

# A BLAS with threads takes memory and time at every start
if command -v ldd >/dev/null; then
   loads_no_blas() { ldd "$program" >libraries && ! grep -i -E 'lapack|blas' libraries; }
   check 'no command loads LAPACK or a BLAS' loads_no_blas
fi
