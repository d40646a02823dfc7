# Bad input: status 2 (3 for files), one line that names place and key, nothing written

# bad NAME PATTERN TEXT: a case file of that text is refused; the text is for printf
bad() {
   printf "$3" >bad.nml
   refuses "$1" 2 "$2" curve bad.nml --csv never.csv
}
bad 'unknown key' "bad.nml:2: unknown key 'sigm'; did you mean sigma\?" '&asperity\n sigm = 3\n/\n'
bad 'unknown key far from any' "bad.nml:1: unknown key 'foo'$" '&asperity foo = 3\n/\n'
bad 'duplicate key' 'bad.nml:4: sigma is given twice, first in line 2' \
   '&asperity\n sigma = 0.05\n eta = 3\n SIGMA = 0.05 /\n'
bad 'negative sigma' 'bad.nml:3: sigma = -0.05 is not allowed' \
   '&asperity\n eta = 206\n sigma = -0.05\n/\n'
bad 'NaN' "bad.nml:2: sigma = 'NaN' is not a finite number" '&asperity\n sigma = NaN\n/\n'
bad 'infinity' "bad.nml:2: sigma = '-Inf' is not a finite number" '&asperity\n sigma = -Inf\n/\n'
bad 'overflow' "bad.nml:2: sigma = '1d999' is not a finite number" '&asperity\n sigma = 1d999\n/\n'
bad 'underflow' 'bad.nml:2: sigma = 0.0 is not allowed' '&asperity\n sigma = 1d-999\n/\n'
bad 'empty list' 'bad.nml:2: separation has no value' '&asperity\n separation =\n/\n'
bad 'no value before the next key' 'bad.nml:1: sigma has no value' '&asperity sigma = eta = 3 /\n'
bad 'empty value in a list' 'bad.nml:1: separation has an empty value' \
   '&asperity separation = 1,,2 /\n'
bad 'text for a number' "bad.nml:1: sigma = 'abc' is not a finite number" \
   '&asperity sigma = abc /\n'
bad 'quoted number' "bad.nml:1: sigma = '0.05' is not a finite number" "&asperity sigma = '0.05' /\n"
bad 'number with garbage' "bad.nml:1: sigma = '0.05mm' is not" '&asperity sigma = 0.05mm /\n'
bad 'two points' "bad.nml:1: sigma = '0.0.5' is not" '&asperity sigma = 0.0.5 /\n'
bad 'two values' "bad.nml:2: sigma takes one value, found also '2'" '&asperity sigma = 1\n 2 /\n'
bad 'yield factor above one' 'bad.nml:1: yield_factor = 1.5 is not allowed' \
   '&asperity yield_factor = 1.5 /\n'
bad 'unit slip' 'bad.nml:1: eta\*radius\*sigma = .*give it in 1/mm' '&asperity eta = 2.06e-4 /\n'
bad 'repeat count' "bad.nml:1: separation: repeat counts such as '3\*0.1'" \
   '&asperity separation = 3*0.1 /\n'
bad 'subscript' "bad.nml:1: 'separation\(1\)' is not a key; subscripts" \
   '&asperity separation(1) = 0.1 /\n'
bad 'unknown pair' "bad.nml:1: pair = 'foo' is unknown; known pairs" "&asperity pair = 'foo' /\n"
bad 'unknown surface' "bad.nml:1: surface = 'foo' is unknown" "&asperity surface = 'foo' /\n"
bad 'text without quotes' 'bad.nml:1: pair is a text and needs quotes' '&asperity pair = foo /\n'
bad 'open quote' 'bad.nml:1: the text .* has no closing quote' "&asperity pair = 'foo\n/\n"
bad 'neither true nor false' 'bad.nml:1: accept_unphysical = .* is neither true nor false' \
   '&asperity accept_unphysical = 1 /\n'
bad 'unknown choice of another command' "bad.nml:1: control = 'foo' is unknown; known: pressure" \
   "&asperity control = 'foo' /\n"
bad 'unknown unloading' "bad.nml:1: unloading = 'plastic' is unknown; known: reversible, elastic" \
   "&asperity unloading = 'plastic' /\n"
bad 'unloading by number' 'bad.nml:1: unloading is a text and needs quotes' '&asperity unloading = 1 /\n'
bad 'memory of the reversible law' 'bad.nml:2: closest_separation = 0.1 mm is for unloading = elastic alone' \
   '&asperity\n closest_separation = 0.1 /\n'
bad 'memory of summits that would create energy' 'bad.nml:3: yield_factor = 0.15 is not allowed with elastic' \
   "&asperity\n unloading = 'elastic'\n yield_factor = 0.15 /\n"
bad 'output as a key' 'bad.nml:1: csv is not a key of a case file, use the option --csv' \
   "&asperity csv = 'x' /\n"
bad 'no equals sign' 'bad.nml:1: sigma must be followed by =' '&asperity sigma 0.05 /\n'
bad 'comment touching a value' 'bad.nml:1: a comment needs a blank before !' \
   '&asperity sigma = 0.05!mm\n/\n'
bad 'comment before a value' 'bad.nml:1: sigma has no value' '&asperity sigma = ! mm\n 0.05 /\n'
bad 'comma and comment' 'bad.nml:2: a comma and a comment may not stand together' \
   '&asperity separation = 0.1, ! mm\n 0.2 /\n'
bad 'no end' 'bad.nml:3: the group has no end' '&asperity\n sigma = 0.05\n'
bad 'no group' "bad.nml:1: a case starts with &asperity, found 'sigma'" 'sigma = 0.05\n'
bad 'another group' "bad.nml:1: a case starts with &asperity, found '&foo'" '&foo sigma = 0.05 /\n'
bad 'text after the end' 'bad.nml:2: nothing may follow the /' '&asperity /\n sigma = 0.05\n'
bad 'no last line break' 'bad.nml: the last line needs a line break' '&asperity sigma = 0.05 /'
bad 'empty case file' 'bad.nml:1: a case starts with &asperity, found the end' ''
bad 'only comments' 'bad.nml:2: a case starts with &asperity, found the end' '! nothing\n'
bad 'control character' 'bad.nml:1: control character 0' '&asperity sigma = \0000.05 /\n'

head -c 4096 "$program" >bad.nml
refuses 'a binary as case file' 2 'bad.nml:[0-9]+: control character' curve bad.nml
# Sparse files: nothing of that size is written or read
printf '&asperity sigma = ' >bad.nml
truncate -s 200M bad.nml
refuses '200 MB of zeros' 2 'bad.nml:1: control character 0' curve bad.nml
head -c 200000000 /dev/zero | tr '\0' '1' >>line.txt
{ printf '&asperity\n sigma = '; cat line.txt; } >bad.nml
check 'a line of 200 MB is not read into memory' limited sh -c 'ulimit -v 150000; "$1" curve bad.nml 2>err
   [ $? -eq 2 ] && grep -q "bad.nml:2: the line is longer than 10000" err' sh "$program"
rm -f line.txt
yes '! many short lines' | head -c 20000000 >bad.nml
refuses 'a large file' 2 'bad.nml: is larger than 16 MiB' curve bad.nml
refuses 'an endless file' 2 '/dev/zero:1: control character' curve /dev/zero
refuses 'missing file' 3 'no.nml: cannot be read: No such file' curve no.nml
refuses 'missing folder' 3 'no/no.nml: cannot be read: No such file' curve no/no.nml
refuses 'a folder as file' 3 '\.: cannot be read: Is a directory' curve .

refuses '--sigma negative' 2 '--sigma: sigma = -1.0 is not allowed' curve --sigma -1
refuses '--sigma nan' 2 "--sigma: sigma = 'nan' is not a finite" curve --sigma nan
refuses '--sigma 1e999' 2 '--sigma: .* is not a finite' curve --sigma 1e999
refuses '--sigma empty' 2 "--sigma: sigma = '' is not a finite" curve --sigma ''
refuses '--yield-factor above one' 2 '--yield-factor: yield_factor = 2.0' curve --yield-factor 2
refuses '--separation empty' 2 '--separation: the list is empty' curve --separation ''
refuses '--separation with a gap' 2 "--separation: .* has an empty value" curve --separation 1,,2
refuses '--separation with text' 2 "--separation: .*'a' is not a finite" curve --separation 1,a
refuses '--separation 1:2:0' 2 '--separation: separation count = 0' curve --separation 1:2:0
refuses '--separation 1:2' 2 "--separation: .* is not start:stop:count" curve --separation 1:2
refuses '--separation with a giant count' 2 '--separation: separation count = 2000000000' \
   curve --separation 1:2:2000000000
refuses '--separation out of range' 2 '--separation: separation = -1.0E200 mm is not' \
   curve --separation=-1e200
refuses '--pair empty' 2 '--pair: pair is empty' curve --pair ''
refuses '--pair unknown' 2 "--pair: pair = 'foo' is unknown; known pairs" curve --pair foo
check 'nothing was written' absent never.csv

# Slips of units are named, with the way past them, by every command that takes properties
refuses 'sigma in um' 2 '--sigma: sigma = 59.3 mm is above 5.0 mm.*sigma looks like um.*accept_unphysical' \
   shear --sigma 59.3
refuses 'radius in um' 2 '--radius: eta.radius.sigma = .*radius looks like um, give it in mm' press --radius 147.7
refuses 'modulus in Pa' 2 '--modulus: modulus = 2.97E8 MPa is above .*modulus looks like Pa' shear --modulus 2.97e8
refuses 'modulus in GPa' 2 '--modulus: hardness/modulus = 24.53/0.297 = 82.6 is above 1.0.*modulus looks like GPa' \
   curve --modulus 0.297
refuses 'hardness in Pa' 2 '--hardness: hardness = 2.45E7 MPa is above .*hardness looks like Pa' \
   tenon --hardness 2.453e7
refuses 'hardness in GPa' 2 '--hardness: hardness = 0.0245 MPa is below .*hardness looks like GPa' \
   table --hardness 0.02453
run shear --sigma 59.3 --accept-unphysical --normal-stress 0.05 --csv -
check 'a slip of units that is accepted is flagged' has out 'implausible_property'
refuses 'critical slip in um' 2 '--critical-slip: critical_slip = 310.0 mm .*looks like um' shear --critical-slip 310
refuses 'datum in um' 2 '--initial-separation: initial_separation = 237.0 mm .*looks like um' \
   curve --initial-separation 237.2
