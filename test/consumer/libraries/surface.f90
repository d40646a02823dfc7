! A random surface, which FFTW makes, written as SDF and read again by the readers of all formats,
! which are linked to libzip, libxml2 and zlib
program surface
   use asperity, only: error_type, wp
   use asperity_height_map_read, only: map_hints, read_height_map_bytes
   use asperity_height_map_type, only: height_map
   use asperity_height_map_write, only: height_map_bytes
   use asperity_surface_generate_map, only: generate_surface
   use asperity_surface_generate_settings, only: surface_settings
   implicit none
   type(height_map) :: map, again
   type(error_type), allocatable :: error
   character(len=:), allocatable :: bytes

   call generate_surface(surface_settings(points_x=64, points_y=48), map, error)
   if (allocated(error)) error stop 1
   call height_map_bytes(map, 'sdf', bytes, error)
   if (allocated(error)) error stop 2
   call read_height_map_bytes('made.sdf', bytes, map_hints(), again, error)
   if (allocated(error)) error stop 3
   if (any(shape(again%heights) /= [64, 48])) error stop 4
   if (maxval(abs(again%heights - map%heights)) > 1.0e-12_wp) error stop 5
   print '(a)', 'surface: 64 x 48 points, written and read'
end program surface
