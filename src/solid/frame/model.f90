!> A frame as a solid: every joint by the code of the single one.
module asperity_solid_frame_model
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_solid_frame_mesh, only: new_frame_mesh
   use asperity_solid_frame_settings, only: check_frame_settings, complete_frame_settings, &
      frame_settings
   use asperity_solid_material_material, only: new_solid_material
   use asperity_solid_mesh_joint, only: part_shoe
   use asperity_solid_model_model, only: complete_model, ground_spring, solid_model
   use asperity_solid_model_settings, only: check_solid_settings, solid_settings
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: new_frame_model

   !> Modulus and ratio of the shoes, which are of steel, MPa
   real(wp), parameter :: steel_modulus = 210000.0_wp, steel_ratio = 0.3_wp

contains

   !> Make the model. `error` is set when it cannot be.
   subroutine new_frame_model(model, frame_wanted, deck, settings, error)
      !> Result
      type(solid_model), intent(out) :: model
      !> The frame
      type(frame_settings), intent(in) :: frame_wanted
      !> Its joints
      type(tenon_deck), intent(in) :: deck
      !> Settings of the analysis
      type(solid_settings), intent(in) :: settings
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      type(frame_settings) :: frame
      integer, allocatable :: beam_ends(:, :)

      frame = frame_wanted
      call check_solid_settings(settings, error)
      if (.not. allocated(error)) call complete_frame_settings(frame, deck%sizes, error)
      if (.not. allocated(error)) &
         call check_frame_settings(frame, deck%settings, deck%sizes, error)
      if (.not. allocated(error)) call new_frame_mesh(model%mesh, frame, deck, beam_ends, error)
      if (allocated(error)) return
      call hold_beams(model%springs, beam_ends, settings%holding_stiffness)
      model%column_loads = 0.5_wp*frame%column_loads
      model%arm = deck%sizes%column_height
      call new_solid_material(model%wood(part_shoe), steel(), 3, 2, .true., error)
      if (.not. allocated(error)) call complete_model(model, deck, settings, error)
   end subroutine new_frame_model

   !> Soft springs that hold the beams while joints are open: in z at both ends, in x at the first.
   pure subroutine hold_beams(springs, beam_ends, stiffness)
      type(ground_spring), allocatable, intent(out) :: springs(:)
      integer, intent(in) :: beam_ends(:, :)
      real(wp), intent(in) :: stiffness
      integer :: i

      allocate (springs(3*size(beam_ends, 2)))
      springs%stiffness = stiffness
      do i = 1, size(beam_ends, 2)
         springs(3*i - 2:3*i)%node = [beam_ends(:, i), beam_ends(1, i)]
         springs(3*i - 2:3*i)%direction = [3, 3, 1]
      end do
   end subroutine hold_beams

   !> What shoes are of.
   pure type(wood_properties) function steel()

      steel%young_moduli = steel_modulus
      steel%poisson_ratios = steel_ratio
      steel%shear_moduli = steel_modulus/(2.0_wp + 2.0_wp*steel_ratio)
      steel%criterion = 'none'
   end function steel

end module asperity_solid_frame_model
