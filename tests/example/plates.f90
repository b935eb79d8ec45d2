! An explicit code without contact: a mesh, lumped masses, and forces of the elements. plates.h in Fortran, where the
! element is described. Units: mm, ms, g, N, MPa.
module plates
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp), parameter :: YOUNG = 1000, POISSON = 0.4_dp, DENSITY = 0.95e-3_dp ! MPa, g/mm^3: polyethylene
  real(dp), parameter :: COURANT = 0.5_dp ! time step / the longest stable one of an element alone
  real(dp), parameter :: LAMBDA = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
  real(dp), parameter :: MU = 0.5_dp * YOUNG / (1 + POISSON)
  real(dp), parameter :: PENALTY = 0.35_dp * (LAMBDA + 2 * MU) ! N/mm
  real(dp), parameter :: CORNER(3, 8) = reshape(real([-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, &
                                                      -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1], dp), [3, 8])

  type :: element
    real(dp) :: b(8, 3), g(8, 4) ! dN/dX at the centre; hourglass shapes, blind to linear motion
    real(dp) :: volume, stiffness ! the latter against hourglasses
  end type

  type :: plate
    integer :: n(3)
    real(dp) :: low(3), size(3), turn ! about z, radians
    logical :: above                  ! contact side: above or below
  end type

  type :: model
    integer :: first_upper ! nodes from there on are the upper plate's
    real(dp), allocatable :: x(:, :), mass(:)
    integer, allocatable :: hex(:, :), seg(:, :), slave(:)
    type(element), allocatable :: element(:)
    real(dp) :: dt = huge(1d0) ! stable time step
  end type

contains

  ! Returns the height of a plate's contact side: waves on the lower plate, a bowl below the upper plate.
  pure real(dp) function height(p, x, y)
    type(plate), intent(in) :: p
    real(dp), intent(in) :: x, y
    if (p%above) then
      height = 0.06_dp * sin(0.4_dp * x) * cos(0.3_dp * y)
    else
      height = (x**2 + y**2) / 600
    end if
  end function

  ! Places node (i,j,k) of a brick: inner nodes are moved in the plane, one side is curved, the brick is turned about z.
  pure function place_node(p, i, j, k) result(position)
    type(plate), intent(in) :: p
    integer, intent(in) :: i, j, k
    real(dp) :: position(3), u(3), r(3), inner, x, y
    u = real([i, j, k], dp) / p%n
    r = p%low + p%size * u
    inner = 16 * u(1) * (1 - u(1)) * u(2) * (1 - u(2))
    x = r(1) + 0.25_dp * inner * sin(1.3_dp * r(1)) * cos(0.9_dp * r(2))
    y = r(2) + 0.25_dp * inner * cos(1.1_dp * r(1)) * sin(1.2_dp * r(2))
    position(1) = x * cos(p%turn) - y * sin(p%turn)
    position(2) = x * sin(p%turn) + y * cos(p%turn)
    position(3) = r(3) + height(p, position(1), position(2)) * merge(u(3), 1 - u(3), p%above)
  end function

  ! Adds nodes and elements of a plate from m%x(:,node+1) and m%hex(:,e+1) on.
  subroutine add_plate(m, p, node, e)
    type(model), intent(inout) :: m
    type(plate), intent(in) :: p
    integer, intent(inout) :: node, e
    integer :: i, j, k, a, row, layer, first
    first = node
    row = p%n(1) + 1
    layer = row * (p%n(2) + 1)
    do k = 0, p%n(3)
      do j = 0, p%n(2)
        do i = 0, p%n(1)
          node = node + 1
          m%x(:, node) = place_node(p, i, j, k)
        end do
      end do
    end do
    do k = 0, p%n(3) - 1
      do j = 0, p%n(2) - 1
        do i = 0, p%n(1) - 1
          a = first + 1 + i + row * j + layer * k
          e = e + 1
          m%hex(:, e) = [a, a + 1, a + row + 1, a + row, a + layer, a + layer + 1, a + layer + row + 1, a + layer + row]
        end do
      end do
    end do
  end subroutine

  pure subroutine invert(j, inverse, det)
    real(dp), intent(in) :: j(3, 3)
    real(dp), intent(out) :: inverse(3, 3), det
    integer :: a, b
    do b = 1, 3
      do a = 1, 3
        inverse(a, b) = j(mod(b, 3) + 1, mod(a, 3) + 1) * j(mod(b + 1, 3) + 1, mod(a + 1, 3) + 1) &
                        - j(mod(b, 3) + 1, mod(a + 1, 3) + 1) * j(mod(b + 1, 3) + 1, mod(a, 3) + 1)
      end do
    end do
    det = dot_product(j(1, :), inverse(:, 1))
    inverse = inverse / det
  end subroutine

  ! Computes gradients at the centre, hourglass shapes minus their linear part, and the element's share in masses and dt.
  subroutine prepare_element(m, e)
    type(model), intent(inout) :: m
    integer, intent(in) :: e
    real(dp) :: xe(3, 8), jacobian(3, 3), inverse(3, 3), shape(8), bb
    integer :: a, h
    xe = m%x(:, m%hex(:, e))
    jacobian = matmul(CORNER, transpose(xe)) / 8
    call invert(jacobian, inverse, m%element(e)%volume)
    associate (q => m%element(e))
      q%volume = 8 * q%volume
      q%b = transpose(matmul(inverse, CORNER)) / 8
      bb = sum(q%b**2)
      do h = 1, 4
        shape = merge(CORNER(min(h, 3), :) * CORNER(mod(h, 3) + 1, :), product(CORNER, 1), h < 4)
        q%g(:, h) = shape - matmul(q%b, matmul(xe, shape))
      end do
      q%stiffness = 0.01_dp * (LAMBDA + 2 * MU) * q%volume * bb
      do a = 1, 8
        m%mass(m%hex(a, e)) = m%mass(m%hex(a, e)) + DENSITY * q%volume / 8
      end do
    end associate
    m%dt = min(m%dt, 2 * COURANT * sqrt(DENSITY / (LAMBDA + 2 * MU) / bb))
  end subroutine

  ! Adds forces of the elements to f; computes the strain energy, including hourglasses.
  real(dp) function internal_forces(m, x, f) result(energy)
    type(model), intent(in) :: m
    real(dp), intent(in) :: x(:, :)
    real(dp), intent(inout) :: f(:, :)
    real(dp) :: deform(3, 3), strain(3, 3), stress(3, 3), glass(3, 4), pull(3, 8), pressure
    integer :: e, a, i, j, h, n
    energy = 0
    do e = 1, size(m%element)
      associate (q => m%element(e))
        deform = 0
        glass = 0
        do a = 1, 8
          n = m%hex(a, e)
          do j = 1, 3
            deform(:, j) = deform(:, j) + x(:, n) * q%b(a, j)
          end do
          do h = 1, 4
            glass(:, h) = glass(:, h) + x(:, n) * q%g(a, h)
          end do
        end do
        do j = 1, 3
          do i = 1, 3
            strain(i, j) = 0.5_dp * (dot_product(deform(:, i), deform(:, j)) - merge(1, 0, i == j))
          end do
        end do
        pressure = LAMBDA * (strain(1, 1) + strain(2, 2) + strain(3, 3))
        energy = energy + q%volume * (MU * sum(strain**2) + 0.5_dp * pressure**2 / LAMBDA) &
                 + 0.5_dp * q%stiffness * sum(glass**2)
        do j = 1, 3 ! P = F S, S = lambda tr E + 2 mu E
          stress(:, j) = q%volume * (pressure * deform(:, j) + 2 * MU * (deform(:, 1) * strain(1, j) &
                                     + deform(:, 2) * strain(2, j) + deform(:, 3) * strain(3, j)))
        end do
        do a = 1, 8
          pull(:, a) = 0
          do j = 1, 3
            pull(:, a) = pull(:, a) + stress(:, j) * q%b(a, j)
          end do
          do h = 1, 4
            pull(:, a) = pull(:, a) + q%stiffness * glass(:, h) * q%g(a, h)
          end do
          n = m%hex(a, e)
          f(:, n) = f(:, n) - pull(:, a)
        end do
      end associate
    end do
  end function

  subroutine make_plates(m)
    type(model), intent(inout) :: m
    type(plate) :: both(2)
    integer :: node, e, i, quads, slaves
    both(1) = plate([32, 32, 3], [-16d0, -16d0, -3d0], [32d0, 32d0, 3d0], 0d0, .true.)
    both(2) = plate([32, 32, 4], [-11.2d0, -11.2d0, 0.2d0], [22.4d0, 22.4d0, 2.8d0], 0.35d0, .false.)
    allocate (m%x(3, sum([(product(both(i)%n + 1), i=1, 2)])), m%hex(8, sum([(product(both(i)%n), i=1, 2)])))
    allocate (m%mass(size(m%x, 2)), m%element(size(m%hex, 2)))
    node = 0
    e = 0
    call add_plate(m, both(1), node, e)
    quads = both(1)%n(1) * both(1)%n(2)
    m%seg = m%hex(5:8, e - quads + 1:e) ! S2, counter-clockwise from above
    m%first_upper = node + 1
    slaves = (both(2)%n(1) + 1) * (both(2)%n(2) + 1)
    m%slave = [(node + i, i=1, slaves)]
    call add_plate(m, both(2), node, e)
    m%mass = 0
    do i = 1, e
      call prepare_element(m, i)
    end do
  end subroutine
end module plates
