!> One contact spring: kinematics, the call of UINTER with every argument as ABAQUS fills it, forces
!> and stiffness. Start-of-increment values in, end-of-increment values out; nothing is kept here.
module asperity_calculix_springs
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_kinds, only: wp
   use asperity_calculix_ccx_state, only: count_call, host, name_of, pair_of, surface_name
   use asperity_calculix_faces, only: has_face, most_nodes
   use asperity_calculix_interactions, only: interaction_type
   use asperity_calculix_kinematics, only: find_motion, find_variation, most_freedoms, &
      motion_type, variation_type
   use asperity_calculix_outputs, only: new_outputs, note_optional, outputs_type, unset_outputs
   use asperity_calculix_refusal, only: refuse
   use asperity_calculix_spring_state, only: own_slots, slot_energy, slot_pnewdt, slot_slip, &
      slot_status, slot_stress, slot_time, slot_user_status
   implicit none
   private
   public :: spring_type, response_type, fill_spring, evaluate_spring, spring_force, &
      spring_stiffness

   !> What one spring is given.
   type :: spring_type
      !> Its interaction
      type(interaction_type), pointer :: interaction => null()
      !> Number of nodes: those of the face, then the slave node
      integer :: nodes = 0
      !> The slave node in the deck, and among those of all pairs
      integer :: node = 0, counter = 0
      !> Positions at the end and at the start of the increment (3, node)
      real(wp) :: positions(3, most_nodes + 1) = 0.0_wp
      real(wp) :: start_positions(3, most_nodes + 1) = 0.0_wp
      !> Tributary area of the slave node
      real(wp) :: area = 0.0_wp
   end type spring_type

   !> What comes out.
   type :: response_type
      !> Kinematics
      type(motion_type) :: motion
      !> Pressure and the two shear stresses, MPa
      real(wp) :: stress(3) = 0.0_wp
      !> Their derivatives by overclosure and slip
      real(wp) :: stiffness(3, 3) = 0.0_wp
      !> Stored energy per area at the end; dissipated energies of the increment
      real(wp) :: energy = 0.0_wp, dissipation = 0.0_wp
   end type response_type

   !> ABAQUS' position of a point that has no opposite surface
   real(wp), parameter :: no_surface = -1.0e36_wp
   !> ABAQUS passes a large value
   real(wp), parameter :: no_request = 1.0e36_wp

   procedure(uinter_interface) :: uinter

contains

   !> Gather a spring from what the solver passes. Ends the job where UINTER cannot serve.
   subroutine fill_spring(spring, interaction, initial, displacements, numbers, area, method)
      !> The spring
      type(spring_type), intent(out) :: spring
      !> Its interaction
      type(interaction_type), pointer, intent(in) :: interaction
      !> Initial positions (3, node) and displacements (0:, node), slave node last
      real(wp), intent(in) :: initial(:, :), displacements(:, :)
      !> Numbers of the nodes, then the slave node's among those of all pairs
      integer, intent(in) :: numbers(:)
      !> Tributary area
      real(wp), intent(in) :: area
      !> Kind of the analysis, 1 is static, 4 dynamic
      integer, intent(in) :: method
      integer :: i, n

      n = size(initial, 2)
      if (method /= 1 .and. method /= 4) call refuse('UINTER does not serve a step that is '// &
         'neither static nor dynamic')
      if (.not. has_face(n - 1)) call refuse('UINTER does not serve a master face with other '// &
         'than 3, 4, 6 or 8 nodes')
      if (.not. area > 0.0_wp) call refuse_node(numbers(n))
      spring%interaction => interaction
      spring%nodes = n
      spring%node = numbers(n)
      spring%counter = numbers(n + 1)
      spring%area = area
      spring%positions(:, :n) = initial + displacements(2:4, :)
      do i = 1, n
         spring%start_positions(:, i) = initial(:, i) + host%start(2:4, numbers(i))
      end do
   end subroutine fill_spring

   !> End the job for want of an area.
   subroutine refuse_node(node)
      integer, intent(in) :: node
      character(len=12) :: number

      write (number, '(i0)') node
      call refuse('slave node '//trim(number)//' has no area: no face of an element has all of '// &
         'its nodes in the slave surface. Name the faces, or all nodes of each')
   end subroutine refuse_node

   !> Kinematics and UINTER.
   subroutine evaluate_spring(spring, start, state, response)
      !> The spring
      type(spring_type), intent(in) :: spring
      !> What it kept at the start of the increment
      real(wp), intent(in) :: start(:)
      !> What it keeps at the end
      real(wp), intent(out) :: state(:)
      !> Stresses, stiffness and energies
      type(response_type), intent(out) :: response
      !> Share of an increment by which times may differ and still be the same
      real(wp), parameter :: same_time = 1.0e-6_wp
      real(wp) :: rdisp(3), drdisp(3), began
      logical :: existed

      associate (positions => spring%positions(:, :spring%nodes))
         if (host%at_rest) then
            response%motion = find_motion(positions, positions)
            began = host%total
         else
            response%motion = find_motion(positions, spring%start_positions(:, :spring%nodes))
            began = host%total + host%time - host%increment
         end if
      end associate
      state = start
      existed = abs(start(slot_time) - began) <= same_time*host%increment
      ! The increments without a spring, in which ABAQUS would have called as well
      if (.not. existed) call call_uinter(spring, state, [no_surface, 0.0_wp, 0.0_wp], &
         [0.0_wp, 0.0_wp, 0.0_wp], response)

      associate (motion => response%motion, slip => state(slot_slip:slot_slip + 1))
         slip = matmul(motion%rotation, slip) + motion%slip
         rdisp = [motion%overclosure, slip]
         drdisp = [motion%overclosure - motion%start_overclosure, motion%slip]
         if (.not. existed) drdisp(1) = motion%overclosure - no_surface
      end associate
      call call_uinter(spring, state, rdisp, drdisp, response)
      state(slot_time) = host%total + host%time
   end subroutine evaluate_spring

   !> Call UINTER, in a poisoned run once more from other stresses. The state goes in as of the
   !> start of the increment.
   subroutine call_uinter(spring, state, rdisp, drdisp, response)
      type(spring_type), intent(in) :: spring
      real(wp), intent(inout) :: state(:)
      real(wp), intent(in) :: rdisp(3), drdisp(3)
      type(response_type), intent(inout) :: response
      !> MPa, a number that no law begins with
      real(wp), parameter :: shift(3) = [0.1234567_wp, 0.2345671_wp, 0.3456712_wp]
      type(outputs_type) :: outputs, again
      real(wp) :: start(3, 2), thrown_away(size(state))

      start(:, 1) = state(slot_stress:slot_stress + 2)
      if (host%poisoned) then
         start(:, 2) = start(:, 1) + shift
         thrown_away = state
         again = new_outputs(start(:, 2), poisoned=.true.)
         call pass(spring, thrown_away, rdisp, drdisp, response%motion, again)
      end if
      outputs = new_outputs(start(:, 1), host%poisoned)
      call pass(spring, state, rdisp, drdisp, response%motion, outputs)
      if (host%poisoned) then
         call refuse_unset(spring, rdisp, unset_outputs(outputs, again, start, drdisp))
         call note_optional(outputs)
      end if
      response%stress = outputs%stress
      response%stiffness = outputs%ddsddr
      response%energy = state(slot_energy)
      response%dissipation = outputs%sfd + outputs%spd + outputs%svd + outputs%scd
      state(slot_stress:slot_stress + 2) = response%stress
   end subroutine call_uinter

   !> End the job when UINTER left something unset.
   subroutine refuse_unset(spring, rdisp, names)
      type(spring_type), intent(in) :: spring
      real(wp), intent(in) :: rdisp(3)
      character(len=*), intent(in) :: names
      character(len=160) :: place

      if (names == '') return
      write (place, '(3(a, i0), a, es12.4)') 'node ', spring%node, ', step ', host%step, &
         ', increment ', host%number, ', RDISP(1) = ', rdisp(1)
      call refuse('UINTER did not set'//trim(names)//' at '//trim(place))
   end subroutine refuse_unset

   !> The call with all its arguments.
   subroutine pass(spring, state, rdisp, drdisp, motion, outputs)
      type(spring_type), intent(in) :: spring
      real(wp), intent(inout) :: state(:)
      real(wp), intent(in) :: rdisp(3), drdisp(3)
      type(motion_type), intent(in) :: motion
      type(outputs_type), intent(inout) :: outputs
      real(wp) :: flux(2), factor, none(2, 0)
      integer :: opened, user_status, discontinuity, pair
      integer(int64) :: began

      flux = 0.0_wp
      factor = no_request
      opened = nint(state(slot_status)) - 1
      user_status = nint(state(slot_user_status)) - 1
      discontinuity = 0
      pair = pair_of(spring%counter)
      call system_clock(began)
      associate (interaction => spring%interaction)
         call uinter(outputs%stress, outputs%ddsddr, outputs%dviscous, outputs%dstructural, flux, &
            outputs%ddfddt, outputs%ddsddt, outputs%ddfddr, &
            state(own_slots + 1:own_slots + interaction%depvar), state(slot_energy), &
            outputs%sfd, outputs%spd, outputs%svd, outputs%scd, factor, rdisp, drdisp, &
            [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], none, none, [host%time, host%total + host%time], &
            host%increment, 0.0_wp, &
            name_of(host%material_names, interaction%material, 80), surface_name(pair, 2), &
            surface_name(pair, 3), interaction%props, spring%positions(:, spring%nodes), &
            motion%frame%axes, motion%rotation, spring%area, sqrt(spring%area), spring%node, 3, &
            interaction%depvar, 0, size(interaction%props), 3, host%step, host%number, &
            host%iteration, 0, opened, user_status, discontinuity, 0)
      end associate
      call count_call(began, rdisp(1), outputs%stress)
      state(slot_status) = opened + 1
      state(slot_user_status) = user_status + 1
      state(slot_pnewdt) = 0.0_wp
      if (factor < 1.0_wp) state(slot_pnewdt) = max(factor, tiny(factor))
   end subroutine pass

   !> Internal forces (3, node): what the slave node is pressed and sheared with, and the face's
   !> share by its shape functions.
   pure function spring_force(response, area) result(force)
      !> Response of the spring
      type(response_type), intent(in) :: response
      !> Area
      real(wp), intent(in) :: area
      real(wp) :: force(3, response%motion%nodes + 1)
      real(wp) :: traction(3)
      integer :: k

      associate (m => response%motion%nodes, axes => response%motion%frame%axes)
         traction = area*(matmul(axes(:, 2:), response%stress(2:)) - response%stress(1)*axes(:, 1))
         force(:, m + 1) = traction
         do k = 1, m
            force(:, k) = -response%motion%frame%point%n(k)*traction
         end do
      end associate
   end function spring_force

   !> Derivatives of the forces by the displacements, 3 rows and columns a node, not symmetric.
   pure function spring_stiffness(response, area) result(stiffness)
      !> Response of the spring
      type(response_type), intent(in) :: response
      !> Area
      real(wp), intent(in) :: area
      real(wp) :: stiffness(3*(response%motion%nodes + 1), 3*(response%motion%nodes + 1))
      type(variation_type) :: variation
      real(wp) :: traction(3), change(3, most_freedoms), shares(3), signed(3)
      integer :: k, c, m, freedoms

      m = response%motion%nodes
      freedoms = 3*(m + 1)
      variation = find_variation(response%motion)
      associate (axes => response%motion%frame%axes, stress => response%stress)
         signed = [-stress(1), stress(2), stress(3)]
         traction = area*matmul(axes, signed)
         do c = 1, freedoms
            shares = matmul(response%stiffness, variation%motion(:, c))
            shares(1) = -shares(1)
            change(:, c) = area*(matmul(axes, shares) + matmul(variation%axes(:, :, c), signed))
         end do
      end associate
      associate (point => response%motion%frame%point)
         do c = 1, freedoms
            stiffness(3*m + 1:, c) = change(:, c)
            do k = 1, m
               stiffness(3*k - 2:3*k, c) = -point%n(k)*change(:, c) &
                  - dot_product(point%dn(k, :), variation%xi(:, c))*traction
            end do
         end do
      end associate
   end function spring_stiffness

end module asperity_calculix_springs
