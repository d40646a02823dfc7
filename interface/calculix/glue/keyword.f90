!> Reading of *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER, PROPERTIES=n, DEPVAR=m,
!> SEARCH DISTANCE=c and of the properties after it. The solver passes words without blanks, in
!> capitals.
module asperity_calculix_keyword
   use asperity_base_kinds, only: wp
   use asperity_calculix_interactions, only: interaction_type
   implicit none
   private
   public :: is_uinter, read_parameters, read_property

contains

   !> Whether the keyword line asks for UINTER.
   pure logical function is_uinter(words)
      !> Words of the line
      character(len=*), intent(in) :: words(:)

      is_uinter = any(words == 'PRESSURE-OVERCLOSURE=UINTER')
   end function is_uinter

   !> Read the parameters; `props` has its length afterwards.
   pure subroutine read_parameters(words, interaction, problem)
      !> Words of the line, the keyword first
      character(len=*), intent(in) :: words(:)
      !> What they say
      type(interaction_type), intent(out) :: interaction
      !> What is wrong with them
      character(len=:), allocatable, intent(out) :: problem
      integer :: i, equals, properties, status

      properties = -1
      interaction%depvar = -1
      do i = 2, size(words)
         equals = index(words(i), '=')
         status = 0
         select case (words(i)(:max(equals - 1, 0)))
         case ('PRESSURE-OVERCLOSURE')
            continue
         case ('PROPERTIES')
            read (words(i)(equals + 1:), '(i20)', iostat=status) properties
         case ('DEPVAR')
            read (words(i)(equals + 1:), '(i20)', iostat=status) interaction%depvar
         case ('SEARCHDISTANCE')
            read (words(i)(equals + 1:), '(f40.0)', iostat=status) interaction%search_distance
         case default
            if (len_trim(words(i)) == 0) cycle
            problem = 'unknown parameter '//trim(words(i))// &
               '; there are PROPERTIES, DEPVAR and SEARCH DISTANCE'
            return
         end select
         if (status /= 0) then
            problem = 'no number in '//trim(words(i))
            return
         end if
      end do
      if (properties < 0) then
         problem = 'PROPERTIES=n is missing, or negative'
      else if (interaction%depvar < 0) then
         problem = 'DEPVAR=m is missing, or negative'
      else if (.not. interaction%search_distance > 0.0_wp) then
         problem = 'SEARCH DISTANCE=c is missing, or not above zero: springs are made for '// &
            'slave nodes nearer than c'
      else
         allocate (interaction%props(properties), source=0.0_wp)
      end if
   end subroutine read_parameters

   !> Read one property; a blank word is none.
   pure subroutine read_property(word, props, found, problem)
      !> The word
      character(len=*), intent(in) :: word
      !> Properties
      real(wp), intent(inout) :: props(:)
      !> How many are read
      integer, intent(inout) :: found
      !> What is wrong with it
      character(len=:), allocatable, intent(inout) :: problem
      integer :: status

      if (len_trim(word) == 0 .or. allocated(problem)) return
      if (found == size(props)) then
         problem = 'there are more properties than PROPERTIES says'
         return
      end if
      found = found + 1
      read (word, '(f40.0)', iostat=status) props(found)
      if (status /= 0) problem = 'property '//trim(word)//' is no number'
   end subroutine read_property

end module asperity_calculix_keyword
