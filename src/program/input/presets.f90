!> Fills in the properties that a pair of faces or a surface of the paper gives.
module asperity_program_input_presets
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_paper_pairs, only: find_pair, find_surface, pair_preset, surface_preset
   use asperity_program_input_keys, only: belongs, find_key, keys, kind_real, n_keys
   use asperity_program_input_settings, only: assign_values, forget, settings_type
   implicit none
   private
   public :: drop_overridden, apply_presets, check_presets_used, fill, faces_text

   !> Keys that a surface and a pair give
   character(len=*), parameter :: surface_keys(*) = [character(len=20) :: 'eta', 'radius', 'sigma']
   character(len=*), parameter :: pair_keys(*) = [character(len=20) :: 'surface', 'eta', &
      'modulus', 'radius', 'hardness', 'yield_factor', 'sigma', 'friction_coefficient', &
      'critical_slip']
   character(len=*), parameter :: default_pair = 'transverse-tangential'
   !> Properties that decide what the faces are
   character(len=*), parameter :: normal_keys(*) = [character(len=12) :: &
      'eta', 'modulus', 'radius', 'hardness', 'yield_factor', 'sigma']

contains

   !> Forget what a case file gives and a pair or surface given as an option gives anew.
   pure subroutine drop_overridden(settings, options)
      !> Settings of the case file
      type(settings_type), intent(inout) :: settings
      !> Settings given as options
      type(settings_type), intent(in) :: options
      integer :: i

      do i = 1, size(surface_keys)
         if (options%given('surface')) call forget(settings%of(find_key(trim(surface_keys(i)))))
      end do
      do i = 1, size(pair_keys)
         if (options%given('pair')) call forget(settings%of(find_key(trim(pair_keys(i)))))
      end do
   end subroutine drop_overridden

   !> Give every property that has no value yet that of the surface, else that of the pair.
   !> `error` is set when one of them is unknown.
   pure subroutine apply_presets(settings, command, error)
      !> Settings
      type(settings_type), intent(inout) :: settings
      !> Command that needs the properties
      integer, intent(in) :: command
      !> Set when a name is unknown
      type(error_type), allocatable, intent(out) :: error

      call apply_surface(settings, error)
      if (.not. allocated(error)) call apply_pair(settings, command, error)
   end subroutine apply_presets

   !> The surface's values.
   pure subroutine apply_surface(settings, error)
      type(settings_type), intent(inout) :: settings
      type(error_type), allocatable, intent(out) :: error
      type(surface_preset) :: surface
      character(len=:), allocatable :: source

      if (settings%text_of('surface') == '') return
      call find_surface(settings%text_of('surface'), surface, error)
      if (allocated(error)) return
      source = source_of('surface', settings)
      call fill(settings, 'eta', [surface%eta], source)
      call fill(settings, 'radius', [surface%radius], source)
      call fill(settings, 'sigma', [surface%sigma], source)
   end subroutine apply_surface

   !> The pair's values. A default pair is taken when none is given and a property is missing.
   pure subroutine apply_pair(settings, command, error)
      type(settings_type), intent(inout) :: settings
      integer, intent(in) :: command
      type(error_type), allocatable, intent(out) :: error
      type(pair_preset) :: pair
      character(len=:), allocatable :: source

      if (settings%text_of('pair') == '') then
         if (is_complete(settings, command)) return
         associate (setting => settings%of(find_key('pair')))
            setting%text = default_pair
            setting%has_value = .true.
         end associate
      end if
      call find_pair(settings%text_of('pair'), pair, error)
      if (allocated(error)) return
      source = source_of('pair', settings)
      call fill(settings, 'eta', [pair%eta], source)
      call fill(settings, 'modulus', [pair%modulus], source)
      call fill(settings, 'radius', [pair%radius], source)
      call fill(settings, 'hardness', [pair%hardness], source)
      call fill(settings, 'yield_factor', [pair%yield_factor], source)
      call fill(settings, 'sigma', [pair%sigma], source)
      call fill(settings, 'friction_coefficient', [pair%friction_coefficient], source)
      call fill(settings, 'critical_slip', [pair%critical_slip], source)
   end subroutine apply_pair

   !> Whether every property that a command needs has a value.
   pure logical function is_complete(settings, command)
      type(settings_type), intent(in) :: settings
      integer, intent(in) :: command
      integer :: key

      is_complete = .true.
      do key = 1, n_keys
         if (.not. (keys(key)%is_property .and. keys(key)%kind == kind_real)) cycle
         if (all(pair_keys /= keys(key)%name) .or. .not. belongs(key, command)) cycle
         is_complete = is_complete .and. settings%of(key)%has_value
      end do
   end function is_complete

   !> Refuse a pair or surface given as an option of which nothing is used.
   pure subroutine check_presets_used(settings, options, command, error)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> Settings given as options
      type(settings_type), intent(in) :: options
      !> Command that needs the properties
      integer, intent(in) :: command
      !> Set when an option has no effect
      type(error_type), allocatable, intent(out) :: error

      character(len=*), parameter :: names(2) = [character(len=7) :: 'surface', 'pair']
      character(len=:), allocatable :: source
      integer :: i, key

      source = ''
      do i = 1, size(names)
         if (.not. options%given(trim(names(i)))) cycle
         source = source_of(trim(names(i)), settings)
         do key = 1, n_keys
            if (belongs(key, command) .and. settings%of(key)%source == source) exit
         end do
         if (key <= n_keys) cycle
         call fatal_error(error, '--'//trim(names(i))// &
            ': has no effect, every property that it gives is given explicitly')
         return
      end do
   end subroutine check_presets_used

   !> Give a key values unless it has some.
   pure subroutine fill(settings, name, values, source, follows)
      !> Settings
      type(settings_type), intent(inout) :: settings
      !> Name of the key
      character(len=*), intent(in) :: name
      !> Its values
      real(wp), intent(in) :: values(:)
      !> Where they come from
      character(len=*), intent(in) :: source
      !> Whether they are made from another key, the last word of the source
      logical, intent(in), optional :: follows

      associate (setting => settings%of(find_key(name)))
         if (setting%has_value) return
         call assign_values(setting, values, source)
         if (present(follows)) setting%follows = follows
      end associate
   end subroutine fill

   !> Source of values that a pair or surface gives, such as `surface mesh-400-cross`.
   pure function source_of(name, settings) result(source)
      character(len=*), intent(in) :: name
      type(settings_type), intent(in) :: settings
      character(len=:), allocatable :: source

      source = name//' '//settings%text_of(name)
   end function source_of

   !> What the faces are, for a title: pair, surface, and whether a value differs from theirs.
   pure function faces_text(settings) result(text)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      character(len=:), allocatable :: text
      type(settings_type) :: pristine
      type(error_type), allocatable :: error
      integer :: i
      logical :: changed

      if (settings%text_of('pair') == '') then
         text = 'given properties'
         return
      end if
      pristine%of(find_key('pair')) = settings%of(find_key('pair'))
      pristine%of(find_key('surface')) = settings%of(find_key('surface'))
      call apply_presets(pristine, 0, error)
      changed = allocated(error)
      do i = 1, size(normal_keys)
         if (changed) exit
         changed = abs(settings%real_of(trim(normal_keys(i))) &
            - pristine%real_of(trim(normal_keys(i)))) > 0.0_wp
      end do
      text = settings%text_of('pair')
      if (settings%text_of('surface') /= '') text = text//', '//settings%text_of('surface')
      if (changed) text = text//', changed'
   end function faces_text

end module asperity_program_input_presets
