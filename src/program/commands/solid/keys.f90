!> Keys of `asperity solid`: the case of a joint, its mesh, how it is solved.
module asperity_program_commands_solid_keys
   use asperity_base_error, only: error_type
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_mesh_size, tenon_sizes
   use asperity_program_commands_deck_mesh_keys, only: declare_grading, declare_joint_sizes
   use asperity_program_commands_tenon_bearing_keys, only: declare_column
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_program_commands_wood_keys, only: declare_wood
   use asperity_program_input_key_list, only: key_list
   use asperity_solid_model_settings, only: solid_settings
   implicit none
   private
   public :: solid_case

   !> The case of a solid joint.
   type :: solid_case
      !> Joint, faces, wood and programme
      type(tenon_case) :: joint
      !> Sizes that a plane joint has not, and the mesh
      type(tenon_sizes) :: sizes
      type(deck_choice) :: mesh
      !> `hard`, `rough` or `both`
      character(len=8) :: contact = 'both'
      !> How it is solved
      type(solid_settings) :: settings
   contains
      procedure :: declare, declare_contact, declare_analysis, deck_of
   end type solid_case

contains

   !> Declare the case.
   pure subroutine declare(self, keys)
      !> The case
      class(solid_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call self%joint%declare_faces(keys)
      call self%declare_contact(keys)
      call self%joint%declare_sizes(keys)
      call self%joint%declare_hold(keys, is_replay=.false.)
      call declare_column(self%joint%joint, keys)
      call declare_wood(self%joint%joint%wood, keys, sections=self%joint%sections(), &
         ageing=self%joint%faces%ageing)
      call self%joint%declare_programme(keys)
      call declare_joint_sizes(self%sizes, self%joint, keys)
      call self%declare_analysis(keys)
      call self%joint%declare_reading(keys)
   end subroutine declare

   !> Declare the law of the faces.
   pure subroutine declare_contact(self, keys)
      !> The case
      class(solid_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%choice('contact', self%contact, 'hard rough both', 'law of all faces')
   end subroutine declare_contact

   !> Declare the mesh and how the case is solved.
   pure subroutine declare_analysis(self, keys)
      !> The case, its joint declared
      class(solid_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      self%mesh%mesh_size = default_mesh_size(self%joint%joint)
      call keys%real('mesh_size', self%mesh%mesh_size, 'mm', 'edge of an element aimed at')
      call keys%follows(self%joint%height_key, 'a tenth of height')
      call declare_grading(self%mesh, keys)
      associate (s => self%settings)
         call keys%choice('strain', s%is_logarithmic, 'engineering logarithmic', &
            'strain of the wood, with which its stress goes')
         call keys%whole('contact_cells', s%cells, &
            'contact points along each edge of a face of the mortise')
         call keys%real('penalty', s%penalty, 'MPa/mm', &
            'pressure over penetration of hard contact')
         call keys%unused(self%contact == 'rough')
         call keys%real('soft_overclosure', s%soft_overclosure, 'mm', &
            'penetration over which hard contact stiffens to its penalty')
         call keys%unused(self%contact == 'rough')
         call keys%real('search_distance', s%search_distance, 'mm', &
            'gap up to which faces opposite are known to the matrix before they touch')
         call keys%real('holding_stiffness', s%holding_stiffness, 'N/mm', &
            'spring in z at the end of the tenon, which holds the joint while it is open')
         call keys%whole('stroke_increments', s%stroke_increments, &
            'fewest increments of a stroke; twice as many beyond 16 mm')
         call keys%real('tolerance', s%tolerance, '', &
            'residual over the forces of contact and load at which an increment is solved')
         call keys%real('forcing', s%forcing, '', &
            'residual that the linear solver leaves, over that of the iteration')
         call keys%choice('preconditioner', s%uses_multigrid, 'lu multigrid', &
            'what the linear solver is preconditioned with')
         call keys%whole('most_iterations', s%most_iterations, &
            'iterations after which an increment is halved')
         call keys%choice('through', s%through_uinter, 'direct uinter', &
            'what updates a contact point of the rough law')
         call keys%unused(self%contact == 'hard')
      end associate
   end subroutine declare_analysis

   !> The joint as its deck has it. `error` is set when a value is refused.
   subroutine deck_of(self, is_hard, deck, error)
      !> The case
      class(solid_case), intent(in) :: self
      !> Whether contact is hard, which has no distance of first touch
      logical, intent(in) :: is_hard
      !> The joint
      type(tenon_deck), intent(out) :: deck
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      type(deck_choice) :: choice

      choice = self%mesh
      choice%contact = 'uinter'
      if (is_hard) choice%contact = 'hard'
      call new_tenon_deck(deck, choice, self%joint%joint, self%sizes, &
         self%settings%stroke_increments, self%joint%properties, self%joint%sides, error)
   end subroutine deck_of

end module asperity_program_commands_solid_keys
