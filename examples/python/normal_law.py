#!/usr/bin/env python3
"""The normal law at many separations, and a contact point that is pressed and slid."""

import asperity
import numpy as np

pair = asperity.Properties.from_pair("transverse-tangential", compiled=True)
law = asperity.Law(pair)

d = 0.5*pair.sigma*np.arange(9)
values = law.evaluate(d)
for i in range(d.size):
    print(f"{d[i]:.4f} mm: {values.pressure[i]:9.5f} MPa {values.stiffness[i]:9.4f} MPa/mm, "
          f"real area {values.area_fraction[i]:.5f}")

# one point pressed to 0.2 MPa and slid back and forth
closure = law.properties.initial_separation - law.separation([0.2])
contact = asperity.Contact(law, 1)
for slip in 0.4, -0.4, -0.4, 0.4:
    response = contact.update(closure, [slip, 0.0])
    status = asperity.Status(contact.states["status"][0]).name.lower()
    print(f"slip {slip:+.1f} mm: shear stress {response.traction[1, 0]:+.4f} MPa, {status}, "
          f"dissipated {response.dissipation[0]:.4f} N/mm")

# what is refused raises
try:
    contact.update(closure, [float("nan"), 0.0])
except asperity.InputError as error:
    print("refused:", error)
