#!/usr/bin/env python3
"""Pairs of two faces: of wood sections, by both of the paper's rules, and against smooth steel."""

import asperity

cross = asperity.Face.from_paper("unpolished-cross", "transverse")
tangential = asperity.Face.from_paper("unpolished-tangential", "tangential")
# of the radial section the paper has no hardness: as of the tangential one
radial = asperity.Face(
    sigma=0.0276, radius=0.0696, eta=127.0, young_modulus=tangential.young_modulus,
    poisson_ratio=tangential.poisson_ratio, hardness=tangential.hardness)
steel = asperity.Face(young_modulus=2.0e5, poisson_ratio=0.3, hardness=2000.0)

pairs = {
    "cross on tangential": asperity.Properties.from_faces(cross, tangential),
    "the same by Table 4's rules": asperity.Properties.from_faces(
        cross, tangential, hardness_rule="harder", roughness_rule="face_1"),
    "radial on radial": asperity.Properties.from_faces(radial, radial),
    "radial on steel": asperity.Properties.from_faces(radial, steel, roughness_rule="face_1"),
}
for name, pair in pairs.items():
    closure = 4.0*pair.sigma - asperity.Law(pair).separation(1.0)
    print(f"{name}: E* {pair.modulus:.1f} MPa, H {pair.hardness} MPa, sigma {pair.sigma:.4f} mm, "
          f"closed by {closure:.4f} mm at 1 MPa")
