!> `asperity curve`: the normal law at a list of separations, or one summit.
module asperity_program_commands_curve
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_heights_remark, only: remark_surface_heights
   use asperity_program_commands_faces_properties, only: radius, sigma
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_plots, only: draw_curve
   use asperity_program_commands_single_summit, only: report_summit, usual_deformations
   use asperity_program_commands_sweep_runs, only: run_sweep
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_ranges, only: linear_range
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_validity, new_table
   use asperity_program_system_progress, only: progress_type
   implicit none
   private
   public :: curve_command

   !> Evaluates the law.
   type, extends(command_type) :: curve_command
      private
      type(faces_type) :: faces
      !> Separations, mm
      real(wp), allocatable :: separation(:)
      !> Closest separation before, mm; not allocated for faces that have not touched yet
      real(wp), allocatable :: closest_separation
      !> One summit instead of the faces, and its deformations, mm
      logical :: single = .false.
      real(wp), allocatable :: deformation(:)
      !> Checked properties of the faces
      type(contact_properties) :: properties
   contains
      procedure :: describe, declare, check, run
   end type curve_command

   !> Separations unless given: so many from that at zero overclosure down to 0
   integer, parameter :: default_points = 41
   !> Largest separation over sigma
   real(wp), parameter :: farthest = 1.0e100_wp
   !> Points between two looks at the clock
   integer, parameter :: chunk = 1000
   !> Bytes of a separation in results and table
   integer(int64), parameter :: bytes_of_row = 300

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(curve_command), intent(inout) :: self

      self%name = 'curve'
      self%summary = 'pressure and real area against separation'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Pressure, stiffness, real area and energy of rough faces against '// &
         'separation, or force, area and mean pressure of one summit (--single; Fig. 5).'
   end subroutine describe

   !> Faces and separations.
   pure subroutine declare(self, keys)
      !> The command
      class(curve_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%faces%declare(keys, has_friction=.false.)
      call self%faces%declare_separation(keys)
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      call self%faces%declare_accept(keys)
      self%separation = linear_range(self%faces%usual_separation(), 0.0_wp, default_points)
      call keys%list('separation', self%separation, 'mm', &
         'separations, also from:to:count as an option; 4 sigma to 0 unless given')
      call keys%follows(self%faces%keys(sigma), '4 sigma to 0')
      call keys%optional_real('closest_separation', self%closest_separation, 'mm', &
         'closest so far, which the faces part from; needs unloading = elastic')
      call declare_single(self, keys)
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_sweep(keys)
      call self%declare_requests(keys)
   end subroutine declare

   !> One summit and its deformations, for which separations mean nothing.
   pure subroutine declare_single(self, keys)
      class(curve_command), intent(inout) :: self
      type(key_list), intent(inout) :: keys
      character(len=*), parameter :: of_faces(3) = [character(len=18) :: 'separation', &
         'closest_separation', 'initial_separation']
      type(normal_properties) :: law
      type(error_type), allocatable :: refused
      integer :: i

      call keys%switch('single', self%single, 'one summit instead of the faces, through its stages')
      call keys%unused(.not. self%single)
      ! what is refused here is told by check
      call self%faces%normal(law, refused)
      if (.not. allocated(refused)) self%deformation = usual_deformations(law)
      call keys%list('deformation', self%deformation, 'mm', &
         'deformations w of the one summit; w1/10 to 10 w2 unless given')
      call keys%follows(self%faces%keys(radius), 'w1/10 to 10 w2')
      call keys%needs(self%single, 'is for --single')
      if (.not. self%single) return
      do i = 1, size(of_faces)
         call keys%needs(.false., 'is of no use to one summit', keys%find(trim(of_faces(i))))
      end do
   end subroutine declare_single

   !> Check faces and separations, at which the energy must not overflow.
   subroutine check(self, error)
      !> The command
      class(curve_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      call self%faces%contact(self%properties, error)
      if (allocated(error) .or. self%single) return
      i = findloc(abs(self%separation)/self%properties%normal%sigma > farthest, .true., 1)
      if (i > 0) call fatal_error(error, 'separation = '//to_text(self%separation(i))// &
         ' mm is not allowed: it must be below '//to_text(farthest)//' sigma in size', &
         subject='separation')
      if (allocated(error) .or. .not. allocated(self%closest_separation)) return
      if (.not. self%faces%has_memory) then
         call fatal_error(error, 'closest_separation = '//to_text(self%closest_separation)// &
            ' mm is for unloading = elastic alone: the reversible law remembers nothing', &
            subject='closest_separation')
      else if (abs(self%closest_separation)/self%properties%normal%sigma > farthest) then
         call fatal_error(error, 'closest_separation = '//to_text(self%closest_separation)// &
            ' mm is not allowed: it must be below '//to_text(farthest)//' sigma in size', &
            subject='closest_separation')
      end if
   end subroutine check

   !> Evaluate the law. `error` is set when a result is out of the range of numbers.
   recursive subroutine run(self, report, error)
      !> The command
      class(curve_command), intent(inout) :: self
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(normal_response), allocatable :: r(:)
      type(progress_type) :: progress
      integer :: i, last, n

      if (self%sweep /= '') then
         call run_sweep(self, report, error)
         return
      end if
      report%faces = self%faces%words()
      if (self%single) then
         call report_summit(report, self%properties%normal, self%deformation, error)
         return
      end if
      n = size(self%separation)
      call check_work(to_text(n)//' separations', bytes_of_row*n, error)
      if (allocated(error)) return
      allocate (r(n))
      call progress%start('curve')
      do i = 1, n, chunk
         call progress%show(i - 1, n, 'separations')
         last = min(i + chunk - 1, n)
         r(i:last) = response_at(self, self%separation(i:last))
      end do
      call progress%finish()

      report%table = new_table(columns=11 + merge(1, 0, self%faces%has_memory), rows=n)
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      associate (table => report%table)
         call table%add_numbers('separation', 'mm', self%separation)
         call table%add_numbers('closure', 'mm', &
            self%properties%initial_separation - self%separation)
         call table%add_numbers('pressure', 'MPa', (r%pressure))
         call table%add_numbers('stiffness', 'MPa/mm', (r%stiffness))
         call table%add_numbers('area_fraction', '-', (r%area_fraction))
         call table%add_numbers('contact_density', '1/mm^2', (r%contact_density))
         call table%add_numbers('energy', 'N/mm', (r%energy))
         if (self%faces%has_memory) &
            call table%add_numbers('plastic_dissipation', 'N/mm', (r%plastic_dissipation))
         call table%add_numbers('elastic_share', '-', (r%elastic_share))
         call table%add_numbers('elastoplastic_share', '-', (r%elastoplastic_share))
         call table%add_numbers('plastic_share', '-', (r%plastic_share))
         call table%add_codes('validity', column_validity, (r%validity))
         call table%check_finite(error)
      end associate
      call remark_surface_heights(report, self%faces%heights, self%properties%normal)
      report%first_rows = [1, n + 1]
      report%important = turning_points(self%separation)
      if (.not. allocated(error) .and. report%is_drawn()) call draw_curve(report)
   end subroutine run

   !> The law at a separation, with memory or without.
   pure elemental function response_at(self, separation) result(response)
      type(curve_command), intent(in) :: self
      real(wp), intent(in) :: separation
      type(normal_response) :: response
      real(wp) :: closest

      closest = separation
      if (allocated(self%closest_separation)) closest = min(separation, self%closest_separation)
      if (self%faces%has_memory) then
         response = evaluate_unloading_law(self%properties%normal, closest, separation - closest)
      else
         response = evaluate_normal_law(self%properties%normal, separation)
      end if
   end function response_at

end module asperity_program_commands_curve
