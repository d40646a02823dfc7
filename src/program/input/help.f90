!> Help texts, made from the table of keys.
module asperity_program_input_help
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_program_input_keys, only: belongs, command_curve, command_deck_shear, &
      command_deck_tenon, command_hysteresis, command_pairs, command_press, command_shear, &
      command_surface, command_table, command_tenon, keys, kind_choice, kind_file, kind_integer, &
      kind_list, kind_logical, kind_real, kind_sweep, kind_text, n_keys, option_name
   use asperity_program_system_strings, only: escaped, newline
   implicit none
   private
   public :: usage_text, help_text, version_text, citation_text

   !> Column at which the explanation of an option starts
   integer, parameter :: help_column = 39

contains

   !> How to call the program, in a few lines; begins with a line break.
   pure function usage_text() result(text)
      character(len=:), allocatable :: text

      text = newline// &
         'usage: asperity curve|press|shear|tenon|table [CASE.nml] [options]'//newline// &
         '       asperity deck shear|tenon [CASE.nml] [options]'//newline// &
         '       asperity hysteresis FILE.csv [options]'//newline// &
         '       asperity surface FILE [FILE --pair] [options]'//newline// &
         '       asperity pairs|version|help [COMMAND]'//newline// &
         'help:  asperity help'
   end function usage_text

   !> Help on one command, or on all of them.
   pure function help_text(topic) result(text)
      !> A command; zero or any other for the overview
      integer, intent(in) :: topic
      character(len=:), allocatable :: text

      select case (topic)
      case (command_curve)
         text = command_help('asperity curve [CASE.nml] [options]', &
            'Pressure, stiffness, real area and energy of rough faces against separation.', topic)
      case (command_press)
         text = command_help('asperity press [CASE.nml] [options]', &
            'Press two faces together and release them, through UINTER. Fig. 17 of the paper'// &
            newline//'is the ramp of overclosure. A ramp of pressure starts and ends where the'// &
            newline//'faces just part.', topic)
      case (command_shear)
         text = command_help('asperity shear [CASE.nml] [options]', &
            'Direct shear of two discs under dead weight, through UINTER (Figs 13-18).', topic)
      case (command_tenon)
         text = command_help('asperity tenon [CASE.nml] [options]', &
            'Cyclic replay of a straight tenon joint: moment, stiffness and energy of hard'// &
            ' contact and'//newline//'of the rough law, beside the paper''s (Figs 19-35,'// &
            ' Table 5).', topic)
      case (command_table)
         text = command_help('asperity table [CASE.nml] [options]', &
            'The law as rows of pressure and overclosure, for programs that interpolate between'// &
            newline//'them: *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR of ABAQUS and'// &
            ' CalculiX, with friction.', topic)
      case (command_deck_shear)
         text = command_help('asperity deck shear [CASE.nml] [options]', &
            'Input deck of the direct shear test in three dimensions, for CalculiX or ABAQUS'// &
            newline//'(Figs 15-18): two discs of wood with the rough law, a table of it, or'// &
            ' hard contact.', topic)
      case (command_deck_tenon)
         text = command_help('asperity deck tenon [CASE.nml] [options]', &
            'Input deck of the straight tenon joint in three dimensions, for CalculiX or ABAQUS'// &
            newline//'(Figs 20-35): joint and programme of the case of asperity tenon.', topic)
      case (command_hysteresis)
         text = command_help('asperity hysteresis FILE.csv [options]', &
            'What a record of displacement and force, or of rotation and moment, is'//newline// &
            '(monotonic, with or without unloading, one-sided, cyclic), its cycles, skeleton,'// &
            newline//'yield and ultimate point, stiffness, energy and damping.', topic)
      case (command_surface)
         text = command_help('asperity surface FILE [FILE --pair] [options]'//newline// &
            '       asperity surface --generate [options]', &
            'From a scanned surface to the parameters of the law: roughness of a height map'// &
            newline//'(ISO 25178-2), spectral moments, summits, asperity density, radius and'// &
            ' sigma (Eqs 28-30),'//newline//'how sure they are, and whether the law holds on'// &
            ' the map. Reads SDF, X3P, SUR, xyz, asc, csv.', topic)
      case (command_pairs)
         text = command_help('asperity pairs [options]', &
            'Pairs of faces (--pair) and surfaces (--surface) of the paper, in N-mm-MPa.', topic)
      case default
         text = overview()
      end select
   end function help_text

   !> The overview of all commands.
   pure function overview() result(text)
      character(len=:), allocatable :: text

      text = 'asperity '//version//': elasto-plastic contact of rough timber faces'//newline// &
         newline// &
         'usage: asperity COMMAND [CASE.nml] [options]'//newline// &
         newline// &
         '  curve      pressure and real area against separation'//newline// &
         '  press      press and release, as ABAQUS calls UINTER'//newline// &
         '  shear      direct shear box, as ABAQUS calls UINTER'//newline// &
         '  tenon      cyclic tenon joint, hard contact against the rough law'//newline// &
         '  table      the law as a table for ABAQUS and CalculiX decks'//newline// &
         '  deck shear input deck of the shear test for ABAQUS or CalculiX'//newline// &
         '  deck tenon input deck of the tenon joint for ABAQUS or CalculiX'//newline// &
         '  hysteresis stiffness, energy and damping of a record of displacement and force'// &
         newline// &
         '  surface    parameters of the law from a scanned height map'//newline// &
         '  pairs      pairs of faces and surfaces of the paper'//newline// &
         '  version    version, also --version'//newline// &
         '  help       this text; asperity help COMMAND for one command'//newline// &
         newline// &
         '  --citation what to cite'//newline// &
         newline// &
         'A case file holds one group &asperity ... / of key = value; every key is also an'// &
         newline// &
         'option, with - for _, which overrides it; values override --surface, that --pair.'// &
         newline// &
         'asperity COMMAND --print-case writes a case file of all input.'// &
         newline//newline// &
         'Exit status: 0 done, 1 computation failed, 2 bad input, 3 file not read or written.' &
         //newline
   end function overview

   !> Usage, purpose and options of one command.
   pure function command_help(usage, purpose, command) result(text)
      character(len=*), intent(in) :: usage, purpose
      integer, intent(in) :: command
      character(len=:), allocatable :: text
      type(growing_text) :: buffer
      integer :: key, group

      call buffer%line('usage: '//usage)
      call buffer%line()
      call buffer%line(purpose)
      do group = 1, 3
         if (count([(in_group(key, group, command), key=1, n_keys)]) == 0) cycle
         call buffer%line()
         select case (group)
         case (1)
            if (command == command_surface) then
               call buffer%line('Properties that a map does not give:')
            else
               call buffer%line('Properties of the faces, also keys of a case file:')
            end if
         case (2)
            if (command == command_hysteresis) then
               call buffer%line('The record:')
            else if (command == command_surface) then
               call buffer%line('The map:')
            else
               call buffer%line('The test, also keys of a case file:')
            end if
         case default
            call buffer%line('Output:')
         end select
         do key = 1, n_keys
            if (in_group(key, group, command)) call buffer%add(option_help(key))
         end do
      end do
      text = buffer%text()
   end function command_help

   !> Whether a key is shown among the properties (1), the test (2) or the output (3).
   pure logical function in_group(key, group, command)
      integer, intent(in) :: key, group, command
      integer :: own

      own = 2
      if (keys(key)%is_property) own = 1
      if (keys(key)%kind >= kind_file) own = 3
      in_group = belongs(key, command) .and. own == group
   end function in_group

   !> One option: name, value, explanation, unit, choices, default.
   pure function option_help(key) result(text)
      integer, intent(in) :: key
      character(len=:), allocatable :: text
      character(len=:), allocatable :: option

      option = option_name(key)
      if (keys(key)%kind == kind_logical) option = '--[no-]'//option(3:)
      option = '  '//option
      select case (keys(key)%kind)
      case (kind_text, kind_choice)
         option = option//' NAME'
      case (kind_real)
         option = option//' NUMBER'
      case (kind_integer)
         option = option//' COUNT'
      case (kind_list)
         option = option//' LIST'
      case (kind_file)
         option = option//' FILE'
      case (kind_sweep)
         option = option//' NAME=VALUES'
      case default
         continue
      end select
      text = option//repeat(' ', max(1, help_column - len(option)))//trim(keys(key)%help)
      if (keys(key)%choices /= '') text = text//': '//escaped(trim(keys(key)%choices), ' ', ' or ')
      if (keys(key)%unit /= '') text = text//', '//trim(keys(key)%unit)
      if (keys(key)%default /= '') text = text//' ['//trim(keys(key)%default)//']'
      text = text//newline
   end function option_help

   !> Name and version.
   pure function version_text() result(text)
      character(len=:), allocatable :: text

      text = 'asperity '//version//newline
   end function version_text

   !> What to cite: the paper of the law, and the program.
   pure function citation_text() result(text)
      character(len=:), allocatable :: text

      text = 'The contact law:'//newline// &
         '  Qifang Xie, Baozhuang Zhang, Lipeng Zhang, Tiantian Guo, Yajie Wu. Normal contact'// &
         newline//'  performance of mortise and tenon joint: theoretical analysis and numerical'// &
         newline//'  simulation. Journal of Wood Science 67 (2021).'//newline// &
         '  https://doi.org/10.1186/s10086-021-01963-x' &
         //newline//newline// &
         'The software:'//newline// &
         '  asperity, version '//version//': elasto-plastic contact of rough timber faces.' &
         //newline//newline// &
         '@article{xie2021normal,'//newline// &
         '  author  = {Xie, Qifang and Zhang, Baozhuang and Zhang, Lipeng and Guo, Tiantian'// &
         ' and Wu, Yajie},'//newline// &
         '  title   = {Normal contact performance of mortise and tenon joint: theoretical'// &
         newline//'             analysis and numerical simulation},'//newline// &
         '  journal = {Journal of Wood Science},'//newline// &
         '  volume  = {67},'//newline// &
         '  year    = {2021},'//newline// &
         '  doi     = {10.1186/s10086-021-01963-x}'//newline// &
         '}'//newline// &
         '@software{asperity,'//newline// &
         '  title   = {asperity: elasto-plastic contact of rough timber faces},'//newline// &
         '  version = {'//version//'}'//newline// &
         '}'//newline
   end function citation_text

end module asperity_program_input_help
