! An elastic block is pressed onto another and then drawn along it, with or without Coulomb friction: press.c in
! Fortran, on faces of four, eight or nine nodes.
!
!     press KIND FRICTION          KIND: quad4, quad8, quad9
!
!     make -C ../.. runtime
!     gfortran -O3 -I../../build blocks.f90 press.f90 ../../build/libfootpoint.a -o press -lm && ./press quad8 0.3
module friction
  use blocks
  use footpoint
  use, intrinsic :: iso_c_binding, only: c_size_t
  implicit none
  real(dp), parameter :: PENALTY = 4000, TANGENTIAL = 2000 ! N/mm
  integer, parameter :: MOST_FACE = 9, MOST = 3 * (MOST_FACE + 1)

  ! State of a slave node. Between steps: its face, the place (xi, eta) on the face that it would take without
  ! friction's force, and its distance from there along the face. At present: the pressing force, and whether it slides.
  type :: touch
    integer :: face = 0
    real(dp) :: stick(2) = 0, stretch(3) = 0, pressure = 0
    logical :: slides = .false.
  end type

  type :: foot
    real(dp) :: loc(2), gap, phi(MOST_FACE), r_xi(3), r_eta(3), normal(3)
  end type

contains

  subroutine check(status)
    integer, intent(in) :: status
    if (status /= FOOTPOINT_OK) error stop 'press: no foot point'
  end subroutine

  subroutine place(kind, y, at)
    integer, intent(in) :: kind
    real(dp), intent(in) :: y(:, :)
    type(foot), intent(inout) :: at
    call check(footpoint_face_place(kind, y, at%loc, at%phi, at%r_xi, at%r_eta, at%normal, at%gap))
  end subroutine

  ! Chooses each slave node's nearest face before a step; the node keeps it during the step. The place that it would
  ! take without friction's force keeps its distance from the foot point, whichever the face.
  subroutine choose_faces(m, x, touches)
    type(model), intent(in) :: m
    real(dp), intent(in) :: x(:, :)
    type(touch), intent(inout) :: touches(:)
    type(foot) :: at
    real(dp) :: y(3, m%face_nodes + 1), distance, aa, ab, bb, u, v
    integer(c_size_t) :: chosen
    integer :: i, region
    do i = 1, size(m%slave)
      associate (t => touches(i))
        call check(footpoint_face_select(m%kind, x, size(m%face, 2, c_size_t), m%face, x(:, m%slave(i) + 1), chosen, at%loc, &
                                         distance, region))
        t%face = int(chosen) + 1
        y = x(:, [m%face(:, t%face), m%slave(i)] + 1)
        call check(footpoint_face_locate(m%kind, y, at%loc, at%gap))
        call place(m%kind, y, at)
        aa = dot_product(at%r_xi, at%r_xi)
        ab = dot_product(at%r_xi, at%r_eta)
        bb = dot_product(at%r_eta, at%r_eta)
        u = dot_product(at%r_xi, t%stretch)
        v = dot_product(at%r_eta, t%stretch)
        t%stick = at%loc - [bb * u - ab * v, aa * v - ab * u] / (aa * bb - ab * ab)
      end associate
    end do
  end subroutine

  ! Adds contact forces on the nodes, their tangent -df/dx, and the sum over slave nodes to `force`.
  subroutine add_contact(m, x, coefficient, touches, f, K, force)
    type(model), intent(in) :: m
    real(dp), intent(in) :: x(:, :), coefficient
    type(touch), intent(inout) :: touches(:)
    real(dp), intent(inout) :: f(:, :), K(:, :)
    real(dp), intent(out) :: force(3)
    type(foot) :: at, stick
    real(dp) :: y(3, m%face_nodes + 1), pull(3, m%face_nodes + 1), drag(3, m%face_nodes + 1), slip(2), gap
    real(dp), dimension(MOST) :: d_xi, d_eta, d_gap
    real(dp) :: d_normal(3 * MOST), hessian(MOST * (MOST + 1) / 2), packed(MOST * (MOST + 1) / 2)
    real(dp) :: tangent(3 * m%face_nodes + 3, 3 * m%face_nodes + 3)
    integer :: node(m%face_nodes + 1), i, a, b, r, c, slave
    slave = m%face_nodes + 1
    force = 0
    do i = 1, size(m%slave)
      associate (t => touches(i))
        t%pressure = 0
        t%slides = .false.
        t%stretch = 0
        node = [m%face(:, t%face), m%slave(i)] + 1
        y = x(:, node)
        call check(footpoint_face_locate(m%kind, y, at%loc, at%gap))
        if (at%gap >= 0) cycle
        call place(m%kind, y, at)
        call check(footpoint_face_hessian(m%kind, y, at%loc, gap, d_xi, d_eta, d_gap, d_normal, hessian))
        call check(footpoint_element_normal(m%face_nodes, at%gap, d_gap, hessian, PENALTY, 0.0_dp, t%pressure, pull, packed))
        drag = 0
        tangent = 0
        if (coefficient > 0) then
          stick%loc = t%stick
          call place(m%kind, y, stick)
          ! a matrix by rows, as in C
          call check(footpoint_element_friction(m%face_nodes, y, stick%phi, at%r_xi, at%r_eta, at%normal, d_gap, d_normal, &
                                                t%pressure, PENALTY, coefficient, TANGENTIAL, slip, drag, tangent))
          tangent = transpose(tangent)
          t%slides = any(slip /= 0)
        end if
        do r = 1, 3 * slave
          do c = 1, 3 * slave
            a = max(r, c)
            tangent(r, c) = tangent(r, c) + packed(a * (a - 1) / 2 + min(r, c))
          end do
        end do
        force = force + pull(:, slave) + drag(:, slave)
        t%stretch = -drag(:, slave) / TANGENTIAL
        do a = 1, slave
          f(:, node(a)) = f(:, node(a)) + pull(:, a) + drag(:, a)
          do b = 1, slave
            call add_tangent(m, K, node(a), node(b), tangent(3 * a - 2:3 * a, 3 * b - 2:3 * b))
          end do
        end do
      end associate
    end do
  end subroutine
end module

program press
  use friction
  implicit none
  integer, parameter :: STEPS = 8, PRESSING = 4, MOST_RESIDUALS = 30, HALVINGS = 4
  real(dp), parameter :: DEPTH = 0.14_dp, WAY = 0.2_dp ! of the block's top; mm
  real(dp), parameter :: DONE = 1e-12_dp               ! relative residual
  character(8), parameter :: names(3) = ['quad4   ', 'quad8   ', 'quad9   ']
  character(20) :: argument
  type(model) :: m
  type(touch), allocatable :: touches(:)
  real(dp), allocatable :: x(:, :), f(:, :), K(:, :), right(:, :)
  real(dp) :: coefficient, force(3), residual(MOST_RESIDUALS), by(3)
  integer :: step, down, n, error
  call get_command_argument(1, argument)
  m = blocks_of(merge(0, FOOTPOINT_QUAD4 - 1 + findloc(names, argument(:8), 1), findloc(names, argument(:8), 1) == 0))
  call get_command_argument(2, argument)
  read (argument, *, iostat=error) coefficient
  if (m%kind < FOOTPOINT_QUAD4 .or. error /= 0) then
    write (*, '(a)') 'usage: press KIND FRICTION       KIND: quad4, quad8, quad9'
    stop 2
  end if
  x = m%X
  f = m%X
  allocate (K(m%unknowns, m%unknowns), right(m%unknowns, 1), touches(size(m%slave)))
  print '(2a, f5.2)', trim(names(m%kind - FOOTPOINT_QUAD4 + 1)), ', friction', coefficient
  print '(a)', '   down  along  pressing   drawing  touch  slide  residuals'
  do step = 1, STEPS
    down = min(step, PRESSING)
    by = merge([0.0_dp, 0.0_dp, -DEPTH / PRESSING], [WAY / (STEPS - PRESSING), 0.0_dp, 0.0_dp], step <= PRESSING)
    call choose_faces(m, x, touches)
    call move()
    n = equilibrium()
    print '(f7.3, f7.3, 2f10.4, 2i7, " ", *(es8.0))', DEPTH * down / PRESSING, WAY * (step - down) / (STEPS - PRESSING), &
      force(3), -force(1), count(touches%pressure > 0), count(touches%slides), residual(:n)
    if (residual(n) > DONE) error stop 'no equilibrium'
  end do

contains

  ! Moves the upper block's top. To begin with, the block is sheared and pressed evenly, and its underside stays.
  subroutine move()
    integer :: i
    associate (low => m%X(3, m%first_upper + 1), high => m%X(3, m%nodes))
      do i = m%first_upper + 1, m%nodes
        x(:, i) = x(:, i) + by * (m%X(3, i) - low) / (high - low)
      end do
    end associate
  end subroutine

  ! Adds all forces and tangents; returns the residual.
  real(dp) function assemble()
    real(dp) :: free, held
    integer :: i
    f = 0
    K = 0
    free = 0
    held = 0
    call add_elements(m, x, f, K)
    call add_contact(m, x, coefficient, touches, f, K, force)
    do i = 1, m%nodes
      if (m%unknown(i) >= 0) then
        free = free + sum(f(:, i)**2)
        right(m%unknown(i) + 1:m%unknown(i) + 3, 1) = f(:, i)
      else if (i > m%first_upper) then
        held = held + sum(f(:, i)**2)
      end if
    end do
    assemble = sqrt(free / held)
  end function

  subroutine advance(change, part)
    real(dp), intent(in) :: change(:), part
    integer :: i
    do i = 1, m%nodes
      if (m%unknown(i) >= 0) x(:, i) = x(:, i) + part * change(m%unknown(i) + 1:m%unknown(i) + 3)
    end do
  end subroutine

  ! Runs Newton's iteration and returns the number of residuals. A step that increases the residual is halved a few
  ! times, because contact and slip change along it.
  integer function equilibrium() result(n)
    real(dp) :: change(m%unknowns), part
    integer :: half
    n = 1
    residual(1) = assemble()
    do while (residual(n) > DONE .and. n < MOST_RESIDUALS)
      if (.not. solve(K, right)) return
      change = right(:, 1)
      part = 1
      call advance(change, part)
      n = n + 1
      residual(n) = assemble()
      do half = 1, HALVINGS
        if (residual(n) < residual(n - 1)) exit
        part = part / 2
        call advance(change, -part)
        residual(n) = assemble()
      end do
    end do
  end function
end program
