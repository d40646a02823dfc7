!> Files of a solid joint for ParaView: body and contact of the states asked for, and their series.
module asperity_program_commands_solid_vtk_files
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_commands_joint_loops, only: hard, model_names, rough
   use asperity_program_system_atomic_files, only: open_target, output_file, write_files
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_programme, only: solid_run
   use asperity_solid_vtu_document, only: write_pvd
   use asperity_solid_vtu_fields, only: body_fields, contact_fields, write_body, write_contact
   implicit none
   private
   public :: check_vtk_folder, write_vtk_step, write_vtk_series

   character(len=*), parameter :: option = '--vtk'
   !> What there is a file of
   character(len=*), parameter :: kinds(2) = [character(len=7) :: 'body', 'contact']

contains

   !> `error` is set when files cannot be written into a folder.
   subroutine check_vtk_folder(folder, error)
      !> The folder
      character(len=*), intent(in) :: folder
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(output_file) :: file

      call open_target(file, option, folder//'/'//series_name(hard, 1), error)
   end subroutine check_vtk_folder

   !> Write body and contact of a run as it stands. `error` is set when a file cannot be written.
   subroutine write_vtk_step(folder, run, error)
      !> Where to
      character(len=*), intent(in) :: folder
      !> The run
      type(solid_run), intent(in) :: run
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(output_file) :: files(size(kinds))
      integer :: i

      associate (model => model_of(run%model))
         do i = 1, size(kinds)
            call open_target(files(i), option, folder//'/'// &
               trim(step_name(model, i, size(run%records))), error)
            if (allocated(error)) return
         end do
      end associate
      call write_body(body_of(run), files(1)%text, error)
      if (.not. allocated(error)) call write_contact(contact_of(run), files(2)%text, error)
      if (.not. allocated(error)) call write_files(files, error)
   end subroutine write_vtk_step

   !> Write the series of all steps of a run that is done. `error` is set when a file cannot be
   !> written.
   subroutine write_vtk_series(folder, run, error)
      !> Where the steps are
      character(len=*), intent(in) :: folder
      !> The run
      type(solid_run), intent(in) :: run
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(output_file) :: files(size(kinds))
      integer :: i, j

      associate (model => model_of(run%model), steps => ends_of(run))
         do i = 1, size(kinds)
            call open_target(files(i), option, folder//'/'//series_name(model, i), error)
            if (.not. allocated(error)) call write_pvd(real(steps, wp), &
               [(step_name(model, i, steps(j)), j=1, size(steps))], files(i)%text, error)
            if (allocated(error)) return
         end do
      end associate
      call write_files(files, error)
   end subroutine write_vtk_series

   !> Last increment of every stroke.
   pure function ends_of(run) result(ends)
      type(solid_run), intent(in) :: run
      integer, allocatable :: ends(:)
      integer :: i

      associate (stroke => run%records%stroke)
         ends = pack([(i, i=1, size(stroke))], [stroke(2:) /= stroke(:size(stroke) - 1), .true.])
      end associate
   end function ends_of

   pure integer function model_of(model)
      type(solid_model), intent(in) :: model

      model_of = merge(hard, rough, model%is_hard)
   end function model_of

   !> Name of a series.
   pure function series_name(model, kind) result(name)
      integer, intent(in) :: model, kind
      character(len=:), allocatable :: name

      name = trim(model_names(model))//'_'//trim(kinds(kind))//'.pvd'
   end function series_name

   !> Name of the file of one step.
   pure function step_name(model, kind, step) result(name)
      integer, intent(in) :: model, kind, step
      character(len=24) :: name

      write (name, '(a,i5.5,a)') trim(model_names(model))//'_'//trim(kinds(kind))//'_', step, '.vtu'
   end function step_name

   !> Fields of the wood.
   pure function body_of(run) result(body)
      type(solid_run), intent(in) :: run
      type(body_fields) :: body
      integer :: i, j

      associate (mesh => run%model%mesh, points => run%model%points)
         allocate (body%nodes, source=mesh%nodes)
         allocate (body%displacement, source=run%displacement)
         allocate (body%elements, source=mesh%elements)
         allocate (body%part, source=mesh%part)
         allocate (body%stress(6, size(points, 1), size(points, 2)))
         do j = 1, size(points, 2)
            do i = 1, size(points, 1)
               body%stress(:, i, j) = points(i, j)%stress
            end do
         end do
         allocate (body%plastic_strain, source=(points%equivalent_strain))
      end associate
   end function body_of

   !> Fields of the contact cells.
   pure function contact_of(run) result(contact)
      type(solid_run), intent(in) :: run
      type(contact_fields) :: contact
      integer :: i, j, k, n, n_faces

      associate (pairs => run%model%pairs)
         allocate (contact%nodes, source=run%model%mesh%nodes)
         allocate (contact%displacement, source=run%displacement)
         contact%cells = run%model%settings%cells
         n_faces = 0
         do i = 1, size(pairs)
            n_faces = n_faces + size(pairs(i)%faces)
         end do
         n = n_faces*contact%cells**2
         allocate (contact%facets(4, n_faces), contact%face(n), contact%status(n), &
            contact%pressure(n), contact%gap(n), contact%coverage(n), contact%shear(3, n))
         n_faces = 0
         n = 0
         do i = 1, size(pairs)
            do j = 1, size(pairs(i)%faces)
               associate (face => pairs(i)%faces(j))
                  n_faces = n_faces + 1
                  contact%facets(:, n_faces) = face%nodes(:4)
                  do k = 1, size(face%cells)
                     n = n + 1
                     associate (cell => face%cells(k))
                        contact%face(n) = i
                        contact%status(n) = cell%trial%status
                        contact%pressure(n) = cell%trial%traction(1)
                        contact%shear(:, n) = matmul(face%tangents, cell%trial%traction(2:3))
                        contact%coverage(n) = cell%coverage
                        contact%gap(n) = merge(cell%gap, 0.0_wp, cell%coverage > 0.0_wp)
                     end associate
                  end do
               end associate
            end do
         end do
      end associate
   end function contact_of

end module asperity_program_commands_solid_vtk_files
