!> What a page on the solid joint says of its input: what was chosen and why, what is assumed, and
!> what cannot be compared. What the keys of the joint share with the plane one is said there.
module asperity_program_commands_solid_page_texts
   use asperity_program_report_page, only: origin_type
   implicit none
   private

   character(len=*), parameter :: chosen = 'chosen: ', &
      of_shear = 'fc90/sqrt(3), as Mises'' criterion makes of fc90; the paper gives none'

   !> Where defaults come from, also where a plane joint has another reason
   type(origin_type), parameter, public :: origins(*) = [ &
      origin_type('contact', chosen//'both, to be compared'), &
      origin_type('column_load', 'none unless given; the paper''s column bears 54 kN'), &
      origin_type('column', chosen//'as solid as the beam'), &
      origin_type('column_height', chosen//'past the mortise by more than its height, so that '// &
      'the ends do not matter'), &
      origin_type('column_width', chosen//'a square column'), &
      origin_type('tail', chosen//'the tenon ends with the mortise'), &
      origin_type('edge_relief', chosen//'so that no corner of the mortise catches'), &
      origin_type('side_interference', chosen//'what makes side_pressure'), &
      origin_type('wood', 'paper, Table 1: larch'), &
      origin_type('young_modulus_l', 'paper, Table 1'), &
      origin_type('young_modulus_r', 'paper, Table 1: one modulus across the grain'), &
      origin_type('young_modulus_t', 'paper, Table 1: one modulus across the grain'), &
      origin_type('poisson_ratio_lr', 'paper, Table 1'), &
      origin_type('poisson_ratio_lt', 'paper, Table 1'), &
      origin_type('poisson_ratio_rt', 'paper, Table 1'), &
      origin_type('shear_modulus_lr', 'paper, Table 1'), &
      origin_type('shear_modulus_lt', 'paper, Table 1'), &
      origin_type('shear_modulus_rt', 'paper, Table 1'), &
      origin_type('compression_strength_t', 'paper, Table 1: fc90'), &
      origin_type('tension_strength_l', 'paper, Table 1: ft0'), &
      origin_type('tension_strength_r', chosen//'as in compression; the paper gives none'), &
      origin_type('tension_strength_t', chosen//'as in compression; the paper gives none'), &
      origin_type('shear_strength_lr', chosen//of_shear), &
      origin_type('shear_strength_lt', chosen//of_shear), &
      origin_type('shear_strength_rt', chosen//of_shear), &
      origin_type('criterion', chosen//'the paper names none; wood crushes across the grain '// &
      'without strain to the sides, which Hill''s flow would need'), &
      origin_type('mesh_size', chosen//'a tenth of the height; finer meshes are softer'), &
      origin_type('rim_mesh_size', chosen//'an even mesh unless given'), &
      origin_type('mesh_growth', chosen//'neighbouring elements are not too unlike'), &
      origin_type('strain', chosen//'what crushing tests measure; logarithmic strain bears more'), &
      origin_type('contact_cells', chosen//'two are softer by 1 % at 60 mm, five change nothing'), &
      origin_type('penalty', chosen//'0.05 mm at 50 MPa; ten times as much moves the force by '// &
      '0.3 %'), &
      origin_type('soft_overclosure', chosen//'a soft start, so that hard contact converges'), &
      origin_type('search_distance', chosen//'more than the faces near in an iteration; it '// &
      'moves no result'), &
      origin_type('holding_stiffness', chosen//'nothing beside wood'), &
      origin_type('stroke_increments', chosen//'more leave less work unaccounted for; the '// &
      'force hardly moves'), &
      origin_type('tolerance', chosen//'a thousandth of the forces in play'), &
      origin_type('forcing', chosen//'cheaper than a new factorisation, and no more iterations'), &
      origin_type('preconditioner', chosen//'both find the same; see docs/performance.md'), &
      origin_type('most_iterations', chosen//'what takes more is better halved'), &
      origin_type('through', chosen//'the same update as through UINTER, without its arrays')]

   !> What the model leaves out or simplifies
   character(len=*), parameter, public :: assumptions(*) = [character(len=360) :: &
      'Half the joint is analysed, as it is symmetric. Column and beam are bricks of eight '// &
      'corners with mean dilatation that follow large rotations; engineering strains are taken '// &
      'as small in the turned element, logarithmic ones are of any size.', &
      'Wood is elastic along three axes, with the grain along column and beam, and yields by '// &
      'the criterion of the case; hardening is isotropic. Nothing splits, wears or creeps.', &
      'Contact is integrated over the faces of the mortise, cell by cell, and ends where a '// &
      'cell leaves the beam. Every cell goes through the same contact-point update as ABAQUS'' '// &
      'UINTER would.', &
      'Hard contact is a penalty: it gives way by pressure over penalty, which is stated. '// &
      'Friction and largest elastic slip are the same; the models differ in nothing else.', &
      'The column is loaded first; then the beam swells across the grain between the sides of '// &
      'the mortise until they bear the pressure of the case; then the load point moves.', &
      'The column stands on a fixed foot; its head stays level and is free to move down. A '// &
      'spring along the beam, or a hold, resists pull-out.', &
      'Loading is slow: no inertia, no rate. The law of the rough faces is reversible, as the '// &
      'paper''s, unless unloading is elastic: summits then remember how flat they were pressed.']

   !> What the figures can be used for, and what for not
   character(len=*), parameter, public :: cautions(*) = [character(len=360) :: &
      'This is a prediction. Nothing was tuned to any test.', &
      'What counts is the ratio of the rough law to hard contact. Forces depend on criterion, '// &
      'mesh, side pressure and strengths, which are chosen where they are not measured, more '// &
      'than on the contact model.', &
      'Drift is the displacement of the load point over its distance from the column face, and '// &
      'moments are force times that distance. The beam''s own rotation at the column face is '// &
      'smaller, as column and beam bend.', &
      'K is the ultimate moment over the ultimate drift.']

   !> The same of the paper's joint
   character(len=*), parameter, public :: paper_cautions(*) = [character(len=360) :: &
      'The text of the paper gives neither the sizes of its joint nor what its moment is '// &
      'about, nor the criterion of its wood: moments in kN m cannot be compared with Table 5, '// &
      'ratios and shapes can.', &
      'The paper reports +12.5 % in yield moment, +10.8 % in ultimate moment and +6.1 % in '// &
      'stiffness of the rough law over hard contact.']

end module asperity_program_commands_solid_page_texts
