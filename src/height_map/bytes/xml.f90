!> Reads an XML member of a zip archive as a stream of elements with their texts, by libxml2's
!> reader: without network, without document types, and so without entities to expand.
module asperity_height_map_bytes_xml
   use, intrinsic :: iso_c_binding, only: c_associated, c_funloc, c_funptr, c_int, c_null_funptr, &
      c_null_ptr, c_ptr
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_c_text, only: get_string
   use asperity_height_map_bytes_libxml2, only: c_free_reader, c_is_empty, c_line, c_local_name, &
      c_node_type, c_reader_for_io, c_reader_read, c_set_error_handler, c_set_print_handler, c_value
   use asperity_height_map_bytes_zip, only: handle_of, read_handle, zip_member
   use asperity_height_map_file_errors, only: map_error
   implicit none
   private
   public :: close_xml, next_text, open_xml, xml_reader

   !> Neither network, errors on the screen nor warnings there
   integer(c_int), parameter :: options = 2048_c_int + 32_c_int + 64_c_int
   !> Kinds of nodes
   integer(c_int), parameter :: is_element = 1_c_int, is_text = 3_c_int, is_cdata = 4_c_int, &
      is_reference = 5_c_int, is_document_type = 10_c_int, is_end = 15_c_int
   integer, parameter :: deepest = 16, longest_name = 64, longest_text = 1024

   !> A reader of elements.
   type :: xml_reader
      !> Names of the elements around, without the root, such as /Record1/Axes
      character(len=:), allocatable :: path
      !> Text of the element that has just ended
      character(len=:), allocatable :: text
      !> Line of it
      integer :: line = 0
      character(len=longest_name), private :: names(deepest) = ''
      integer, private :: depth = 0
      type(c_ptr), private :: handle = c_null_ptr
      character(len=:), allocatable, private :: place
   end type xml_reader

contains

   !> Begin to read a member that is open.
   subroutine open_xml(reader, source, member, error)
      !> The reader; close it with `close_xml`
      type(xml_reader), intent(out) :: reader
      !> The file
      type(byte_source), intent(in) :: source
      !> The member
      type(zip_member), intent(in) :: member
      !> Set when there is no memory for it
      type(error_type), allocatable, intent(out) :: error

      reader%path = ''
      reader%text = ''
      reader%place = source%name//': '//member%name
      ! Some faults of encoding would be printed all the same
      call c_set_error_handler(c_null_ptr, c_funloc(ignore_error))
      call c_set_print_handler(c_null_ptr, c_funloc(ignore_error))
      reader%handle = c_reader_for_io(c_funloc(read_some), c_funloc(close_nothing), &
         handle_of(member), c_null_ptr, c_null_ptr, options)
      if (.not. c_associated(reader%handle)) call map_error(error, source, &
         'libxml2 cannot read '// &
         member%name)
   end subroutine open_xml

   !> Called by libxml2 for more bytes.
   integer(c_int) function read_some(context, to, length) bind(c)
      type(c_ptr), value :: context, to
      integer(c_int), value :: length

      read_some = int(read_handle(context, to, int(length, int64)), c_int)
   end function read_some

   !> Called by libxml2 when it needs no more bytes.
   integer(c_int) function close_nothing(context) bind(c)
      type(c_ptr), value :: context

      close_nothing = 0_c_int
      if (.not. c_associated(context)) close_nothing = -1_c_int
   end function close_nothing

   !> Called by libxml2 with what it would print.
   subroutine ignore_error(context, fault) bind(c)
      type(c_ptr), value :: context, fault

      if (c_associated(context) .and. c_associated(fault)) return
   end subroutine ignore_error

   !> Go to the next element's end; then `path` and `text` are its own.
   subroutine next_text(reader, found, error)
      !> The reader
      type(xml_reader), intent(inout) :: reader
      !> False after the last
      logical, intent(out) :: found
      !> Set when it is no sound XML
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: status
      character(len=:), allocatable :: piece

      found = .false.
      do
         status = c_reader_read(reader%handle)
         reader%line = int(c_line(reader%handle))
         if (status == 0_c_int) return
         if (status < 0_c_int) then
            call xml_error(reader, 'is no sound XML: it was cut off or damaged', error)
            return
         end if
         select case (c_node_type(reader%handle))
         case (is_element)
            reader%text = ''
            call get_string(c_local_name(reader%handle), longest_name, piece)
            if (reader%depth >= deepest) then
               call xml_error(reader, 'has elements within more than '//to_text(deepest)// &
                  ' others', error)
               return
            end if
            reader%depth = reader%depth + 1
            reader%names(reader%depth) = piece
            call set_path(reader)
            found = c_is_empty(reader%handle) == 1_c_int
            if (found) reader%depth = reader%depth - 1
            if (found) return
         case (is_text, is_cdata)
            call get_string(c_value(reader%handle), longest_text, piece)
            if (len(reader%text) + len(piece) < longest_text) reader%text = reader%text//piece
         case (is_end)
            call set_path(reader)
            reader%depth = reader%depth - 1
            found = .true.
            return
         case (is_document_type, is_reference)
            call xml_error(reader, &
               'has a document type or entities: they are not read, as they could be used for '// &
               'attacks', error)
            return
         case default
            cycle
         end select
      end do
   end subroutine next_text

   subroutine set_path(reader)
      type(xml_reader), intent(inout) :: reader
      integer :: i

      reader%path = ''
      do i = 2, reader%depth
         reader%path = reader%path//'/'//trim(reader%names(i))
      end do
   end subroutine set_path

   !> Set `error` to a fault at the current line.
   subroutine xml_error(reader, message, error)
      type(xml_reader), intent(in) :: reader
      character(len=*), intent(in) :: message
      type(error_type), allocatable, intent(out) :: error

      call fatal_error(error, reader%place//':'//to_text(reader%line)//': '//message)
   end subroutine xml_error

   !> Close a reader.
   subroutine close_xml(reader)
      !> The reader
      type(xml_reader), intent(inout) :: reader

      if (c_associated(reader%handle)) call c_free_reader(reader%handle)
      reader%handle = c_null_ptr
      call c_set_error_handler(c_null_ptr, c_null_funptr)
      call c_set_print_handler(c_null_ptr, c_null_funptr)
   end subroutine close_xml

end module asperity_height_map_bytes_xml
