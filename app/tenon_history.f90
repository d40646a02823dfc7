!> The recorded displacements that a tenon joint may be led along.
module app_tenon_history
   use asperity, only: error_type
   use replay_tenon_settings, only: check_tenon_settings, tenon_settings
   use app_keys, only: find_key
   use app_record_file, only: read_record, record_column, record_format
   use app_settings, only: settings_type
   implicit none
   private
   public :: take_history

contains

   !> Read the history that the settings name, if they do. `error` names file and line.
   subroutine take_history(tenon, settings, error)
      !> The joint, whose displacements are set
      type(tenon_settings), intent(inout) :: tenon
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> Set when the file cannot be read, is faulty, or goes too far
      type(error_type), allocatable, intent(out) :: error
      type(record_column) :: columns(1)
      type(record_format) :: format
      character(len=:), allocatable :: path

      path = settings%text_of('history')
      if (path == '') return
      format%separator = 'auto'
      format%decimal = 'point'
      columns(1)%name = 'displacement'
      columns(1)%wanted = settings%text_of('displacement_column')
      columns(1)%source = settings%of(find_key('displacement_column'))%source
      call read_record(path, format, columns, error)
      if (allocated(error)) return
      tenon%displacement = columns(1)%values
      call check_tenon_settings(tenon, error)
      if (allocated(error)) error%message = path//': '//error%message
   end subroutine take_history

end module app_tenon_history
