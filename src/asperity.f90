!> Elasto-plastic contact of rough faces: everything a caller needs, `use asperity`.
module asperity
   use asperity_base_error, only: computation_error, error_type, file_error, input_error
   use asperity_base_kinds, only: wp
   use asperity_base_version, only: version
   use asperity_contact_friction_settings, only: friction_settings, slip_direction_associated, &
      slip_direction_of_stress, stick_critical_slip, stick_summits
   use asperity_contact_point, only: contact_tangent, update_contact_point
   use asperity_contact_points, only: contact_states, get_contact_state, new_contact_states, &
      set_contact_state, update_contact_points
   use asperity_contact_properties, only: contact_properties, new_contact_properties, &
      rule_abaqus, rule_dissipative, slip_backward_euler, slip_exact
   use asperity_contact_state, only: contact_response, contact_state, no_opposite_surface, &
      no_rotation, no_surface_limit, status_open, status_slip, status_stick, status_text, &
      status_unset
   use asperity_contact_stick_elements, only: equivalent_shear_modulus
   use asperity_faces_aged_pair, only: age_pair
   use asperity_faces_face, only: face, face_of_wood
   use asperity_faces_two_faces, only: hardness_harder, hardness_softer, pair_from_faces, &
      roughness_face_1, roughness_face_2, roughness_moments
   use asperity_law_compile_law, only: new_compiled_law
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: equivalent_modulus, heights_gaussian, &
      heights_johnson, new_normal_properties, &
      normal_properties, unloading_elastic, unloading_reversible
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity, stage_elastic, &
      stage_elastoplastic, stage_open, stage_plastic
   use asperity_law_unloading_compile_law, only: new_compiled_unloading_law
   use asperity_law_unloading_compiled_law, only: compiled_plastic_dissipation, &
      compiled_unloading_law, evaluate_compiled_unloading_law
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_law, unloading_stiffness
   use asperity_law_unloading_summit, only: elastic_recovery, evaluate_unloading_asperity
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      implausible_property, memory_beyond_data, pressure_above_hardness, roughness_number_high, &
      roughness_number_low, stiffer_than_hertz, valid, validity_remark, validity_text
   use asperity_paper_pairs, only: find_pair, find_surface, pair_preset, pairs, surface_preset, &
      surfaces
   use asperity_wood_ageing, only: aged_wood, ageing_factors, check_ageing
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_constants, section_radial, section_tangential, &
      section_transverse
   implicit none
   private
   public :: age_pair, aged_wood, ageing_factors, area_above_nominal, asperity_response, &
      check_ageing, closure_above_half_radius, compiled_law, &
      compiled_plastic_dissipation, compiled_unloading_law, computation_error, contact_properties, &
      contact_response, contact_state, contact_states, contact_tangent, elastic_recovery, &
      equivalent_modulus, equivalent_shear_modulus, error_type, evaluate_asperity, &
      evaluate_compiled_law, &
      evaluate_compiled_unloading_law, evaluate_normal_law, evaluate_unloading_asperity, &
      evaluate_unloading_law, face, face_of_wood, file_error, find_pair, find_surface, &
      friction_settings, get_contact_state, hardness_harder, hardness_softer, heights_gaussian, &
      heights_johnson, &
      implausible_property, input_error, memory_beyond_data, new_compiled_law, &
      new_compiled_unloading_law, new_contact_properties, new_contact_states, &
      new_normal_properties, no_opposite_surface, no_rotation, no_surface_limit, &
      normal_properties, normal_response, pair_preset, pairs, pressure_above_hardness, &
      pair_from_faces, retraction_for_pressure, roughness_face_1, roughness_face_2, &
      roughness_moments, roughness_number_high, roughness_number_low, rule_abaqus, &
      rule_dissipative, section_constants, section_radial, section_tangential, &
      section_transverse, separation_for_pressure, set_contact_state, slip_backward_euler, &
      slip_direction_associated, slip_direction_of_stress, slip_exact, stage_elastic, &
      stage_elastoplastic, stage_open, stage_plastic, status_open, stick_critical_slip, &
      stick_summits, &
      status_slip, status_stick, status_text, status_unset, stiffer_than_hertz, surface_preset, &
      surfaces, unloading_elastic, unloading_reversible, unloading_stiffness, &
      update_contact_point, update_contact_points, valid, validity_remark, validity_text, version, &
      wood_properties, wp
end module asperity
