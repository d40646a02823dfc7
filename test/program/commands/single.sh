# curve --single: one summit through its stages

run curve --single --csv s.csv --json s.json
check 'one summit' is_quiet
check 'one summit: columns' test "$(columns s.csv)" = \
   deformation,deformation_over_w1,force,area,mean_pressure,stiffness,energy,stage,validity
check 'one summit: JSON holds the same figures' same_csv_and_json s.csv s.json
check 'one summit: from w1/10 to 10 w2' test "$(rows s.csv)" -eq 41
# Eqs 1-3, 10-13, 20-22 with E* = 297, R = 0.1477, H = 24.53, k = 0.4: w1 = (3 pi k H/4 E*)^2 R, and
# w2 = 110 w1. 1e-13: powers and logarithms of a few roundings
check 'one summit: the formulas of the stages' csv s.csv '
   pi = 3.14159265358979323846; R = 0.1477; H = 24.53; E = 297; k = 0.4
   w1 = (3*pi*k*H/(4*E))^2*R; w = c["deformation"]
   if (far(c["deformation_over_w1"], w/w1, 1e-13)) fail("w1")
   stage = NR < 10 ? "elastic" : NR < 34 ? "elastoplastic" : "plastic"
   if (c["stage"] != stage) fail(c["stage"])
   if (stage == "elastic") { N = 4/3*E*sqrt(R)*w^1.5; A = pi*R*w }
   if (stage == "plastic") { N = 2*pi*R*H*w; A = 2*pi*R*w }
   if (stage == "elastoplastic") {
      A = pi*R*w*(w/w1)^(log(2)/log(110)); N = A*k*H*(w/w1)^(log(1/k)/log(110)) }
   if (far(c["force"], N, 1e-13) || far(c["area"], A, 1e-13) || far(c["mean_pressure"], N/A, 1e-13)) fail(stage)'
check 'one summit: where the stages begin' has s.json '"stage_begins": ["elastoplastic", "plastic"]'
check 'one summit: k H at w1, H at w2' csv s.csv '
   if (NR == 10 && far(c["mean_pressure"], 0.4*24.53, 1e-14)) fail("w1")
   if (NR == 34 && far(c["mean_pressure"], 24.53, 1e-14)) fail("w2")'
check 'one summit: the listing says so' sh -c 'grep -q "^  single  *true" out && ! grep -E "^  (initial_)?separation " out'
run curve --single --deformation 0.001,0.01 --print-case
check 'one summit: as a case file' sh -c 'grep -q "single = .true." out && grep -q "deformation = " out'

# With memory it comes back to its residual, w - 3 N/(4 E* sqrt(A/pi))
run curve --single --unloading elastic --deformation 0.001,0.01 --csv m.csv
check 'one summit, memory' is_quiet
check 'one summit, memory: and the way back' test "$(rows m.csv)" -eq 23
check 'one summit, memory: to the residual' csv m.csv '
   if (NR == 3) { N = c["force"]; e = 3*N/(4*297*sqrt(c["area"]/3.14159265358979323846)) }
   if (NR == 14 && far(c["deformation"], 0.01 - e/2, 1e-13)) fail("half way")
   if (NR == 14 && far(c["force"], N/2^1.5, 1e-12)) fail("force")
   if (NR == 24 && (c["stage"] != "open" || c["force"] != 0 || far(c["deformation"], 0.01 - e, 1e-12))) fail("end")'
refuses 'one summit: no separation' 2 '--separation: is of no use to one summit' curve --single --separation 0.1
refuses 'one summit: no datum' 2 '--initial-separation: is of no use to one summit' curve --single --initial-separation 0.1
refuses 'deformations of the faces' 2 '--deformation: is for --single' curve --deformation 0.1
refuses 'one summit: its hardness is checked' 2 '--hardness: hardness = -1.0 is not allowed' curve --single --hardness -1
if command -v gnuplot >/dev/null; then
   run curve --single --unloading elastic --plot s.svg
   check 'one summit: a picture' sh -c 'grep -q ">w1, w2<" s.svg && grep -q ">released<" s.svg && grep -q ">mean pressure (MPa)<" s.svg'
else
   skip 'one summit: a picture' 'no gnuplot'
fi
