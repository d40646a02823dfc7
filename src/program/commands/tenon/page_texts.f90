!> What a page on the tenon joint says of its input: what the paper gives, what was chosen and why,
!> what is assumed, and what cannot be compared.
module asperity_program_commands_tenon_page_texts
   use asperity_program_report_page, only: origin_type
   implicit none
   private

   character(len=*), parameter :: chosen = 'chosen: '

   !> Where defaults come from
   type(origin_type), parameter, public :: origins(*) = [ &
      origin_type('friction_coefficient', 'paper, Table 4'), &
      origin_type('critical_slip', 'paper, Table 4; probably a numerical setting of its program'), &
      origin_type('unloading', 'paper: its law is reversible'), &
      origin_type('side_pair', 'paper: tangential on tangential at the sides'), &
      origin_type('length', chosen//'a column of 300 mm; Fig. 20''s sizes are not in the text'), &
      origin_type('height', chosen//'with the length it puts the moment in the range of Table 5'), &
      origin_type('width', chosen//'about a third of a usual beam''s width'), &
      origin_type('clearance', chosen//'what careful joinery leaves; the paper names no value'), &
      origin_type('gap', chosen//'a clearance is measured between faces, not between summits'), &
      origin_type('extension', chosen//'the tenon is part of a beam; less than height/2 times '// &
      'the rotation would leave the neck without wood'), &
      origin_type('arm', chosen//'makes 0.096 rad, the end of Fig. 30, of the paper''s 48 mm'), &
      origin_type('shoulder_height', chosen//'a sixth of the height of the tenon'), &
      origin_type('arm_datum', chosen//'the paper does not say what its moment is about'), &
      origin_type('side_pressure', chosen//'a tight fit; with 0.3 MPa the stiffness of hard '// &
      'contact rises from 0.004 to 0.008 rad, where Fig. 29 falls'), &
      origin_type('axial_rule', chosen//'a free tenon walks out of the mortise; free and fixed '// &
      'are the bounds'), &
      origin_type('axial_stiffness', chosen//'soft against the wood, stiff enough to bring the '// &
      'tenon back'), &
      origin_type('young_modulus_l', 'paper, Table 1: the column is pressed along the grain'), &
      origin_type('young_modulus_r', 'paper, Table 1: the tenon is pressed across the grain'), &
      origin_type('compression_strength_l', 'paper, Table 1: fc0'), &
      origin_type('compression_strength_r', 'paper, Table 1: fc90'), &
      origin_type('hardening_along', chosen//'as across the grain'), &
      origin_type('hardening_across', chosen//'small; wood densifies'), &
      origin_type('bearing_depth', chosen//'half the height of the tenon'), &
      origin_type('column_depth', chosen//'half the height of the tenon'), &
      origin_type('column_load', 'paper: 54 kN; does not act in a plane model of the joint'), &
      origin_type('amplitudes', 'paper, Fig. 22'), &
      origin_type('cycles', 'paper, Fig. 22')]

   !> What the model leaves out or simplifies
   character(len=*), parameter, public :: assumptions(*) = [character(len=360) :: &
      'The joint is plane. Tenon and mortise are rigid bodies, and all give is in their '// &
      'faces: every point is the interface and a piece of wood in series. Neighbouring '// &
      'pieces do not hold each other; the beam does not bend, and nothing splits or '// &
      'wears.', &
      'The wood below a point is elastic over a stated depth, yields at its strength, '// &
      'hardens, keeps its indentation and pulls on nothing. The indentation leaves the '// &
      'gap that pinches the loops.', &
      'Hard contact is the same joint with a rigid interface, the same friction and the '// &
      'same largest elastic slip; the models differ in nothing else.', &
      'The side faces bear a given pressure, so that the rough law has no say there; they'// &
      ' slip in two directions.', &
      'The displacement of the programme over the arm is the rotation, which is finite. '// &
      'Pull-out and vertical position follow from equilibrium, with moments about the '// &
      'load point, so that the force of the load comes out. The axial rule acts through '// &
      'the middle of the tenon at the column face.', &
      'Loading is slow: no inertia, no rate. The law of the rough faces is reversible, as the '// &
      'paper''s, unless unloading is elastic: summits then remember how flat they were pressed.']

   !> What the figures can be used for, and what for not
   character(len=*), parameter, public :: cautions(*) = [character(len=360) :: &
      'This is a prediction of a reduced model. Nothing was tuned to any test.', &
      'What counts is the ratio of the rough law to hard contact. Moments depend on what the '// &
      'arm is measured from, on side pressure, axial rule and depths of bearing, which are '// &
      'chosen where they are not measured, more than on the contact model.', &
      'Energies of cycles are areas of moment-rotation loops. The work '// &
      'of the load is larger, as the load point also moves with the tenon''s vertical '// &
      'motion: the joint turns about a point inside the mortise, not about the column '// &
      'face.', &
      'K is the ultimate moment over the ultimate rotation.']

   !> The same of the paper's joint
   character(len=*), parameter, public :: paper_cautions(*) = [character(len=360) :: &
      'The height and the side pressure were chosen by the paper''s results: the first by the '// &
      'order of Table 5''s moments, the second so that the stiffness falls as in Fig. 29. '// &
      'Nothing was tuned to its stiffness K.', &
      'The text of the paper gives neither the sizes of its joint nor what its moment is '// &
      'about. Sizes, datum of the arm, side pressure and axial rule are chosen; they move'// &
      ' the moments by more than the contact model does. So moments in kN m cannot be '// &
      'compared with Table 5.', &
      'What can be compared is the ratio of the rough law to hard contact. The paper '// &
      'reports +12.5 % in yield moment, +10.8 % in ultimate moment and +6.1 % in '// &
      'stiffness. With the paper''s roughness this model finds 1 % or less in ultimate '// &
      'moment: the faces close by 0.14 mm under the wood''s strength, while the rotation '// &
      'presses the edge in by more than 10 mm.', &
      'The paper''s own figures give its K a rotation of 0.116 to 0.122 rad, beyond the 0.096 '// &
      'rad of its energy curves.']

end module asperity_program_commands_tenon_page_texts
