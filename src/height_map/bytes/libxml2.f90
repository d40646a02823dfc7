!> Interfaces of the functions of libxml2 that read XML as a stream.
module asperity_height_map_bytes_libxml2
   use, intrinsic :: iso_c_binding, only: c_funptr, c_int, c_ptr
   implicit none
   private
   public :: c_free_reader, c_is_empty, c_line, c_local_name, c_node_type, c_reader_for_io, &
      c_reader_read, c_set_error_handler, c_set_print_handler, c_value

   interface
      type(c_ptr) function c_reader_for_io(read, close, context, url, encoding, options) &
         bind(c, name='xmlReaderForIO')
         import :: c_funptr, c_int, c_ptr
         type(c_funptr), value :: read, close
         type(c_ptr), value :: context, url, encoding
         integer(c_int), value :: options
      end function c_reader_for_io
      integer(c_int) function c_reader_read(reader) bind(c, name='xmlTextReaderRead')
         import :: c_int, c_ptr
         type(c_ptr), value :: reader
      end function c_reader_read
      integer(c_int) function c_node_type(reader) bind(c, name='xmlTextReaderNodeType')
         import :: c_int, c_ptr
         type(c_ptr), value :: reader
      end function c_node_type
      integer(c_int) function c_is_empty(reader) bind(c, name='xmlTextReaderIsEmptyElement')
         import :: c_int, c_ptr
         type(c_ptr), value :: reader
      end function c_is_empty
      type(c_ptr) function c_local_name(reader) bind(c, name='xmlTextReaderConstLocalName')
         import :: c_ptr
         type(c_ptr), value :: reader
      end function c_local_name
      type(c_ptr) function c_value(reader) bind(c, name='xmlTextReaderConstValue')
         import :: c_ptr
         type(c_ptr), value :: reader
      end function c_value
      integer(c_int) function c_line(reader) bind(c, name='xmlTextReaderGetParserLineNumber')
         import :: c_int, c_ptr
         type(c_ptr), value :: reader
      end function c_line
      subroutine c_set_error_handler(context, handler) bind(c, name='xmlSetStructuredErrorFunc')
         import :: c_funptr, c_ptr
         type(c_ptr), value :: context
         type(c_funptr), value :: handler
      end subroutine c_set_error_handler
      ! Its handler has further arguments, which ours leaves alone
      subroutine c_set_print_handler(context, handler) bind(c, name='xmlSetGenericErrorFunc')
         import :: c_funptr, c_ptr
         type(c_ptr), value :: context
         type(c_funptr), value :: handler
      end subroutine c_set_print_handler
      subroutine c_free_reader(reader) bind(c, name='xmlFreeTextReader')
         import :: c_ptr
         type(c_ptr), value :: reader
      end subroutine c_free_reader
   end interface

end module asperity_height_map_bytes_libxml2
