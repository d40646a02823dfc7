!> Keys of `asperity frame`: its joints are those of `asperity solid`, beside a small table of
!> columns and beams.
module asperity_program_commands_frame_keys
   use asperity_base_checks, only: check_positive
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_program_commands_deck_mesh_keys, only: declare_mortise_sizes
   use asperity_program_commands_solid_keys, only: solid_case
   use asperity_program_commands_wood_keys, only: declare_wood
   use asperity_program_input_key_list, only: key_list
   use asperity_replay_sizes, only: check_size
   use asperity_solid_frame_model, only: new_frame_model
   use asperity_solid_frame_settings, only: complete_frame_settings, check_frame_settings, &
      frame_settings, usual_column_height
   use asperity_solid_model_model, only: solid_model
   implicit none
   private
   public :: frame_case

   !> The case of a frame.
   type :: frame_case
      !> Its joints, their mesh, how they are solved
      type(solid_case) :: joints
      !> Columns and beams
      type(frame_settings) :: frame
   contains
      procedure :: declare, check, new_model
   end type frame_case

   !> Amplitudes of the sway, mm, and their cycles; chosen
   real(wp), parameter :: usual_amplitudes(3) = [25.0_wp, 50.0_wp, 100.0_wp]
   integer, parameter :: usual_cycles(3) = 1

contains

   !> Declare the case.
   pure subroutine declare(self, keys)
      !> The case
      class(frame_case), intent(inout) :: self
      !> The keys
      type(key_list), intent(inout) :: keys

      associate (joint => self%joints%joint, sizes => self%joints%sizes)
         call joint%declare_faces(keys)
         call self%joints%declare_contact(keys)
         call joint%declare_sizes(keys)
         call joint%declare_side_pressure(keys)
         call declare_table(self%frame, keys)
         sizes%column_height = usual_column_height
         call keys%real('column_height', sizes%column_height, 'mm', 'height of the columns')
         ! drift is sway over this
         joint%joint%arm = sizes%column_height
         joint%history = ''
         call declare_mortise_sizes(sizes, joint, keys)
         call declare_wood(joint%joint%wood, keys, sections=joint%sections(), &
            ageing=joint%faces%ageing)
         call joint%declare_amplitudes(keys, usual_amplitudes, usual_cycles, &
            'amplitudes of the sway of all heads, growing')
         call self%joints%declare_analysis(keys)
      end associate
   end subroutine declare

   !> Declare columns and beams.
   pure subroutine declare_table(frame, keys)
      !> The frame
      type(frame_settings), intent(inout) :: frame
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%list('column_places', frame%column_places, 'mm', &
         'places of the columns'' axes, rising; 0 and 2100 unless given')
      call keys%list('column_loads', frame%column_loads, 'N', &
         'vertical load at the head of each column, or one for all; none unless given')
      call keys%choice('column_feet', frame%column_feet, 'hinged fixed', &
         'how the columns stand; their heads are hinged')
      call keys%list('beam_heights', frame%beam_heights, 'mm', &
         'height of the axis of each beam; one at 2/3 of column_height unless given')
      call keys%list('beam_from', frame%beam_from, '', &
         'number of the first column of each beam, or one for all; 1 unless given')
      call keys%list('beam_to', frame%beam_to, '', &
         'number of the last column of each beam, or one for all; that of the last unless given')
   end subroutine declare_table

   !> Check the case.
   subroutine check(self, error)
      !> The case
      class(frame_case), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      type(frame_settings) :: frame

      frame = self%frame
      associate (joint => self%joints%joint, sizes => self%joints%sizes)
         call check_positive(error, 'column_height', sizes%column_height, 'mm')
         call check_size(error, 'column_height', sizes%column_height, joint%joint%accept_sizes)
         if (.not. allocated(error)) call joint%check(error, compiled=.true.)
         if (.not. allocated(error)) call complete_frame_settings(frame, sizes, error)
         if (.not. allocated(error)) call check_frame_settings(frame, joint%joint, sizes, error)
      end associate
   end subroutine check

   !> The model of the case. `error` is set when a value is refused.
   subroutine new_model(self, is_hard, model, error)
      !> The case, checked
      class(frame_case), intent(in) :: self
      !> Whether contact is hard
      logical, intent(in) :: is_hard
      !> The model
      type(solid_model), intent(out) :: model
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      type(tenon_deck), allocatable :: deck

      allocate (deck)
      call self%joints%deck_of(is_hard, deck, error)
      if (.not. allocated(error)) &
         call new_frame_model(model, self%frame, deck, self%joints%settings, error)
   end subroutine new_model

end module asperity_program_commands_frame_keys
