!> A material of a frame program as asperity replays and fits it.
module asperity_frame_material
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_frame_history, only: frame_history
   implicit none
   private
   public :: frame_command, frame_material

   !> Most parts of a command, and numbers of a part
   integer, parameter :: most_parts = 2, most_numbers = 40

   !> One `uniaxialMaterial` of OpenSees: behind its tag stand parts, each a word, empty for none,
   !> and numbers.
   type :: frame_command
      !> Type of material
      character(len=24) :: name = ''
      !> Word of each part, and how many numbers are behind it
      character(len=16) :: word(most_parts) = ''
      integer :: size(most_parts) = 0
      !> The numbers
      real(wp) :: numbers(most_numbers, most_parts) = 0.0_wp
      !> How many parts
      integer :: parts = 0
   contains
      !> One part more
      procedure :: add
   end type frame_command

   !> A material. Its numbers are set by `apply`.
   type, abstract :: frame_material
   contains
      !> What may be fitted, with a start: one of several
      procedure(list_parameters), deferred :: parameters
      !> Set the numbers
      procedure(apply_values), deferred :: apply
      !> Force along a path that begins at rest
      procedure(find_forces), deferred :: replay
      !> What OpenSees is told: the materials that act in parallel
      procedure(list_commands), deferred :: commands
   end type frame_material

   abstract interface
      !> Parameters with bounds. Start numbers count from 1; there are none beyond the last start.
      subroutine list_parameters(self, history, start, list)
         import :: fit_parameter, frame_history, frame_material
         !> The material; what is fixed by the history is set
         class(frame_material), intent(inout) :: self
         !> What it is fitted to
         type(frame_history), intent(in) :: history
         !> Which start
         integer, intent(in) :: start
         !> None when there are no more starts
         type(fit_parameter), allocatable, intent(out) :: list(:)
      end subroutine list_parameters

      !> Set the numbers from values in the order of the parameters.
      pure subroutine apply_values(self, values)
         import :: frame_material, wp
         !> The material
         class(frame_material), intent(inout) :: self
         !> Values
         real(wp), intent(in) :: values(:)
      end subroutine apply_values

      !> Force at each displacement of a path; between turns the path goes one way.
      pure subroutine find_forces(self, displacement, force, error)
         import :: error_type, frame_material, wp
         !> The material
         class(frame_material), intent(in) :: self
         !> Displacements
         real(wp), intent(in) :: displacement(:)
         !> Forces
         real(wp), intent(out) :: force(:)
         !> Set when the rules of the material have no answer
         type(error_type), allocatable, intent(out) :: error
      end subroutine find_forces

      !> The materials that act in parallel.
      pure subroutine list_commands(self, list)
         import :: frame_command, frame_material
         !> The material
         class(frame_material), intent(in) :: self
         !> The commands
         type(frame_command), allocatable, intent(out) :: list(:)
      end subroutine list_commands
   end interface

contains

   !> One part more.
   pure subroutine add(self, word, numbers)
      !> The command
      class(frame_command), intent(inout) :: self
      !> Its word, empty for none
      character(len=*), intent(in) :: word
      !> Its numbers
      real(wp), intent(in) :: numbers(:)

      self%parts = self%parts + 1
      self%word(self%parts) = word
      self%size(self%parts) = size(numbers)
      self%numbers(:size(numbers), self%parts) = numbers
   end subroutine add

end module asperity_frame_material
