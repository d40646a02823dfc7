# Random case files from pieces, most of them proper, some faulty
function pick(list,   parts, n) { n = split(list, parts, "~"); return parts[1 + int(rand()*n)] }
function number() { return pick("0.05~5.0d-2~5e-2~+.05~0.05~0.050000000000000001~5.E-2~5.0D-02~0.05d0~050.0E-3~1~1.~7/") }
function list(   n, s, i) { n = 1 + int(rand()*4); s = number(); for (i = 2; i <= n; i++) s = s pick(",~ ~ , ~,\n~ ! a\n~\n~,,~ ! b\n,~, ! c\n~\n! d\n,~,\n! e\n") number(); return s }
function value(key) {
   if (key ~ /^(separation|normal_stress|displacement)$/) return list()
   if (key ~ /^(accept_unphysical|accept_sizes|shrinking_overlap)$/) return pick(".true.~.false.~T~F~.T.~.f.~TRUE~false~.True.~.tr.")
   if (key == "pair") return pick("'transverse-tangential'~\"tangential-tangential\"~'tangential-tangential '~'tangential-tangential")
   if (key == "surface") return pick("'mesh-400-cross'~\"unpolished-radial\"")
   if (key == "friction_rule") return pick("'abaqus'~'dissipative'~\"abaqus\"~abaqus")
   if (key == "slip_integration") return pick("'exact'~'backward_euler'")
   if (key == "control") return "'pressure'"
   if (key ~ /^(increments|rows|stroke_increments)$/) return pick("1~50~+7~007~1.0~2*3")
   if (key == "solver") return pick("'abaqus'~'calculix'~abaqus")
   if (key == "contact") return pick("'uinter'~'table'~\"hard\"")
   # not refused by some commands only
   if (key == "critical_slip") return pick("1~2.5~+.05e+1~0.05~0.2500000000000000000000000001~1d-1~1.5 ")
   if (key == "yield_factor") return pick("0.4~.4~4.d-1~1~1.0")
   return pick("1~2.5~150.0~3d2~+.05e+4~0.05~1.E2~100~0.2500000000000000000000000001~1d-1~1.5 ~12.D0")
}
BEGIN {
   srand(seed)
   n = split("pair surface eta modulus radius hardness yield_factor sigma friction_coefficient critical_slip initial_separation friction_rule slip_integration accept_unphysical accept_sizes separation control peak increments step_time diameter normal_stress rate displacement displacement_increment shrinking_overlap shear_compliance largest_pressure smallest_pressure tolerance rows stick_pressure solver contact mesh_size rim_mesh_size mesh_growth penalty search_distance disc_height column_height column_width tail edge_relief side_interference stroke_increments", keys, " ")
   s = pick("~! head\n~\n\n~ ") pick("&asperity~&ASPERITY~&Asperity") pick(" ~\n~\n ! c\n~ ! c\n")
   m = int(rand()*7)
   split("", used)
   for (i = 1; i <= m; i++) {
      k = keys[1 + int(rand()*n)]
      if (k in used && rand() < 0.97) continue
      used[k]
      name = rand() < 0.2 ? toupper(k) : k
      s = s name pick(" ~~\n~  ~ ! x\n") "=" pick(" ~~\n~  ~\t") value(k) pick(" ~\n~, ~,\n~ , ! c\n~ ! c\n~\n\n! c\n~, ! c\n~")
   }
   printf "%s%s", s, pick("/\n~/\n~ /\n~/ ! end\n~/\n\n! end\n~/~\n")
}
