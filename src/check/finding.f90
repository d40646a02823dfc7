!> What a check of a user routine finds, and the rules that it finds it by.
module asperity_check_finding
   implicit none
   private
   public :: finding_type, finding_list

   !> The rules
   enum, bind(c)
      enumerator :: rule_argument_list = 1, rule_unset_output, rule_guard, rule_tangent, &
         rule_repeat, rule_uninitialised, rule_statics, rule_common, rule_no_traction, &
         rule_no_surface, rule_first_call, rule_cut_back, rule_perturbation, rule_rotation, &
         rule_two_d, rule_sign, rule_energy, rule_step_size, rule_prints, rule_crash, rule_timeout
   end enum
   public :: rule_argument_list, rule_unset_output, rule_guard, rule_tangent, rule_repeat, &
      rule_uninitialised, rule_statics, rule_common, rule_no_traction, rule_no_surface, &
      rule_first_call, rule_cut_back, rule_perturbation, rule_rotation, rule_two_d, rule_sign, &
      rule_energy, rule_step_size, rule_prints, rule_crash, rule_timeout
   !> How many there are, and their names in tables and files
   integer, parameter, public :: n_rules = rule_timeout
   character(len=*), parameter, public :: rule_names(n_rules) = [character(len=13) :: &
      'argument_list', 'unset_output', 'guard', 'tangent', 'repeat', 'uninitialised', 'statics', &
      'common', 'no_traction', 'no_surface', 'first_call', 'cut_back', 'perturbation', &
      'rotation', 'two_d', 'sign', 'energy', 'step_size', 'prints', 'crash', 'timeout']

   !> How much a finding matters: ABAQUS computes wrongly or not at all; it may, in some procedure
   !> or model; it does not
   enum, bind(c)
      enumerator :: severity_error = 1, severity_warning, severity_note
   end enum
   public :: severity_error, severity_warning, severity_note
   character(len=*), parameter, public :: severity_names(3) = [character(len=7) :: 'error', &
      'warning', 'note']

   !> One thing found.
   type :: finding_type
      integer :: rule = 0, severity = severity_error
      !> Where: a line of the source, an output, a state of the path
      character(len=:), allocatable :: place
      !> What should be there, and what is
      character(len=:), allocatable :: expected, found
      !> What it does in ABAQUS
      character(len=:), allocatable :: effect
   end type finding_type

   !> Findings in the order of finding.
   type :: finding_list
      !> The first `n` are set
      type(finding_type), allocatable :: items(:)
      integer :: n = 0
   contains
      procedure :: add
   end type finding_list

contains

   !> Add a finding, unless the list has one of the same rule and place.
   pure subroutine add(list, rule, severity, place, expected, found, effect)
      !> The list
      class(finding_list), intent(inout) :: list
      !> A rule and a severity of this module
      integer, intent(in) :: rule, severity
      !> As in `finding_type`
      character(len=*), intent(in) :: place, expected, found, effect
      type(finding_type), allocatable :: grown(:)
      integer :: i

      do i = 1, list%n
         if (list%items(i)%rule == rule .and. list%items(i)%place == place) return
      end do
      if (.not. allocated(list%items)) allocate (list%items(8))
      if (list%n == size(list%items)) then
         allocate (grown(2*list%n))
         grown(:list%n) = list%items
         call move_alloc(grown, list%items)
      end if
      list%n = list%n + 1
      list%items(list%n)%rule = rule
      list%items(list%n)%severity = severity
      list%items(list%n)%place = place
      list%items(list%n)%expected = expected
      list%items(list%n)%found = found
      list%items(list%n)%effect = effect
   end subroutine add

end module asperity_check_finding
