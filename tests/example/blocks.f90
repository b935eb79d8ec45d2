! An implicit code without contact: a mesh, forces of the elements and their tangent, a linear solver. blocks.h in
! Fortran, only for hexahedra of 8, 20 and 27 nodes, with faces of 4, 8 and 9. Units: mm, N, MPa.
module blocks
  use footpoint, only: FOOTPOINT_QUAD4, FOOTPOINT_QUAD8, footpoint_face_nodes
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp), parameter :: YOUNG = 1000, POISSON = 0.3_dp ! MPa
  real(dp), parameter :: LAMBDA = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
  real(dp), parameter :: MU = 0.5_dp * YOUNG / (1 + POISSON)

  ! An element, in coordinates from 0 to 1: its nodes, and gradients of the shape functions at quadrature points.
  type :: solid
    integer :: nodes = 0, points = 0
    real(dp) :: place(3, 27), gradient(3, 27, 27), weight(27)
  end type

  type :: block
    integer :: cells(3)
    real(dp) :: low(3), size(3), turn, wave ! about z, radians; of the upper side, mm
  end type

  type :: model
    integer :: kind, face_nodes, nodes = 0, unknowns = 0, first_upper ! nodes behind first_upper are the upper block's
    type(solid) :: solid
    real(dp), allocatable :: X(:, :)
    integer, allocatable :: unknown(:)              ! first unknown of each node, minus 1; -1: prescribed
    integer, allocatable :: element(:, :)           ! nodes from 1
    integer, allocatable :: face(:, :), slave(:)    ! nodes from 0, as footpoint counts them
  end type

contains

  ! Solves A Z = B: Z replaces B, A is overwritten; pivots by columns.
  logical function solve(A, B) result(regular)
    real(dp), intent(inout) :: A(:, :), B(:, :)
    integer :: n, k, p, c
    n = size(A, 1)
    regular = .false.
    do k = 1, n
      p = k - 1 + maxloc(abs(A(k:, k)), 1)
      if (.not. abs(A(p, k)) > 0) return
      A([k, p], :) = A([p, k], :)
      B([k, p], :) = B([p, k], :)
      A(k + 1:, k) = A(k + 1:, k) / A(k, k)
      do c = k + 1, n
        if (A(k, c) /= 0) A(k + 1:, c) = A(k + 1:, c) - A(k, c) * A(k + 1:, k)
      end do
      do c = 1, size(B, 2)
        if (B(k, c) /= 0) B(k + 1:, c) = B(k + 1:, c) - B(k, c) * A(k + 1:, k)
      end do
    end do
    do k = n, 1, -1
      B(k, :) = B(k, :) / A(k, k)
      do c = 1, size(B, 2)
        B(:k - 1, c) = B(:k - 1, c) - B(k, c) * A(:k - 1, k)
      end do
    end do
    regular = .true.
  end function

  ! Returns true if a kind's element has a node this many half steps from its first node.
  pure logical function has_node(kind, half)
    integer, intent(in) :: kind, half(3)
    has_node = kind /= FOOTPOINT_QUAD4 .and. kind /= FOOTPOINT_QUAD8 .or. &
               count(mod(half, 2) == 1) <= merge(0, 1, kind == FOOTPOINT_QUAD4)
  end function

  function solid_of(kind) result(s)
    integer, intent(in) :: kind
    type(solid) :: s
    real(dp), parameter :: near = 0.2113248654051871_dp, far = 0.1127016653792583_dp
    real(dp) :: gauss(3), share(3), point(3), by
    real(dp), allocatable :: value(:, :), shape(:, :)
    integer :: power(3, 27), half(3), at(3), order, i, a, m, k, q
    do i = 0, 26
      half = [mod(i, 3), mod(i / 3, 3), i / 9]
      if (.not. has_node(kind, half)) cycle
      s%nodes = s%nodes + 1
      s%place(:, s%nodes) = 0.5_dp * half
      power(:, s%nodes) = merge(2, half / 2, half == 1) ! the monomial that stands for that node
    end do
    order = merge(2, 3, kind == FOOTPOINT_QUAD4)
    gauss = merge([near, 1 - near, 0.0_dp], [far, 0.5_dp, 1 - far], order == 2)
    share = merge([0.5_dp, 0.5_dp, 0.0_dp], [5.0_dp, 8.0_dp, 5.0_dp] / 18, order == 2)
    ! Shape function a is the sum over m of shape(m, a) times monomial m: 1 at node a, 0 at the other nodes.
    allocate (value(s%nodes, s%nodes), shape(s%nodes, s%nodes))
    do a = 1, s%nodes
      do m = 1, s%nodes
        value(a, m) = product(s%place(:, a)**power(:, m))
        shape(a, m) = merge(1, 0, a == m)
      end do
    end do
    if (.not. solve(value, shape)) error stop 'no shape functions'
    s%points = order**3
    s%gradient = 0
    do q = 1, s%points
      at = 1 + [mod(q - 1, order), mod((q - 1) / order, order), (q - 1) / order**2]
      point = gauss(at)
      s%weight(q) = product(share(at))
      do m = 1, s%nodes
        do k = 1, 3
          if (power(k, m) == 0) cycle
          i = mod(k, 3) + 1
          by = power(k, m) * point(k)**(power(k, m) - 1) * point(i)**power(i, m) * point(6 - k - i)**power(6 - k - i, m)
          s%gradient(k, :s%nodes, q) = s%gradient(k, :s%nodes, q) + by * shape(m, :)
        end do
      end do
    end do
  end function

  function place_node(b, at) result(X)
    type(block), intent(in) :: b
    integer, intent(in) :: at(3)
    real(dp) :: X(3), u(3), r(3)
    u = 0.5_dp * at / b%cells
    r = b%low + b%size * u
    X = [r(1) * cos(b%turn) - r(2) * sin(b%turn), r(1) * sin(b%turn) + r(2) * cos(b%turn), &
         r(3) + b%wave * u(3) * sin(1.1_dp * r(1) + 0.4_dp) * cos(0.9_dp * r(2))]
  end function

  ! Adds nodes layer by layer; the block's outer side is prescribed.
  subroutine add_block(m, b, lower)
    type(model), intent(inout) :: m
    type(block), intent(in) :: b
    logical, intent(in) :: lower
    integer, parameter :: quad(2, 9) = reshape([0, 0, 2, 0, 2, 2, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 1, 1], [2, 9])
    integer :: n(3), at(3), half(3), i, a, held
    integer, allocatable :: index(:, :, :), nodes(:)
    n = 2 * b%cells + 1
    held = merge(0, n(3) - 1, lower)
    allocate (index(0:n(1) - 1, 0:n(2) - 1, 0:n(3) - 1))
    do i = 0, product(n) - 1
      at = [mod(i, n(1)), mod(i / n(1), n(2)), i / n(1) / n(2)]
      if (.not. has_node(m%kind, at)) cycle
      m%nodes = m%nodes + 1
      index(at(1), at(2), at(3)) = m%nodes
      m%X = reshape([m%X, place_node(b, at)], [3, m%nodes])
      m%unknown = [m%unknown, merge(-1, m%unknowns, at(3) == held)]
      if (at(3) /= held) m%unknowns = m%unknowns + 3
      if (.not. lower .and. at(3) == 0) m%slave = [m%slave, m%nodes - 1]
    end do
    do i = 0, product(b%cells) - 1
      at = 2 * [mod(i, b%cells(1)), mod(i / b%cells(1), b%cells(2)), i / b%cells(1) / b%cells(2)]
      nodes = [integer ::]
      do a = 1, m%solid%nodes
        half = at + nint(2 * m%solid%place(:, a))
        nodes = [nodes, index(half(1), half(2), half(3))]
      end do
      m%element = reshape([m%element, nodes], [m%solid%nodes, size(m%element, 2) + 1])
      if (.not. lower .or. at(3) /= n(3) - 3) cycle
      nodes = [integer ::]
      do a = 1, m%face_nodes
        nodes = [nodes, index(at(1) + quad(1, a), at(2) + quad(2, a), n(3) - 1) - 1]
      end do
      m%face = reshape([m%face, nodes], [m%face_nodes, size(m%face, 2) + 1])
    end do
  end subroutine

  function blocks_of(kind) result(m)
    integer, intent(in) :: kind
    type(model) :: m
    m%kind = kind
    m%face_nodes = footpoint_face_nodes(kind)
    m%solid = solid_of(kind)
    allocate (m%X(3, 0), m%unknown(0), m%element(m%solid%nodes, 0), m%face(m%face_nodes, 0), m%slave(0))
    call add_block(m, block([3, 3, 1], [-1.5_dp, -1.5_dp, -1.0_dp], [3.0_dp, 3.0_dp, 1.0_dp], 0.0_dp, 0.05_dp), .true.)
    m%first_upper = m%nodes
    call add_block(m, block([2, 2, 1], [-0.8_dp, -0.8_dp, 0.05_dp], [1.6_dp, 1.6_dp, 0.8_dp], 0.3_dp, 0.0_dp), .false.)
  end function

  ! Adds the tangent between two nodes: the change of the force on one when the other moves.
  subroutine add_tangent(m, K, a, b, tangent)
    type(model), intent(in) :: m
    real(dp), intent(inout) :: K(:, :)
    integer, intent(in) :: a, b
    real(dp), intent(in) :: tangent(3, 3)
    integer :: r, c
    r = m%unknown(a)
    c = m%unknown(b)
    if (r >= 0 .and. c >= 0) K(r + 1:r + 3, c + 1:c + 3) = K(r + 1:r + 3, c + 1:c + 3) + tangent
  end subroutine

  function inverse(J, det) result(inv)
    real(dp), intent(in) :: J(3, 3)
    real(dp), intent(out) :: det
    real(dp) :: inv(3, 3)
    integer :: i, k, p, q, r, s
    do i = 1, 3
      do k = 1, 3
        p = mod(k, 3) + 1
        q = mod(p, 3) + 1
        r = mod(i, 3) + 1
        s = mod(r, 3) + 1
        inv(i, k) = J(p, r) * J(q, s) - J(p, s) * J(q, r)
      end do
    end do
    det = dot_product(J(1, :), inv(:, 1))
    inv = inv / det
  end function

  ! Adds forces of the elements on the nodes, and their tangent -df/dx by the unknowns.
  subroutine add_elements(m, x, f, K)
    type(model), intent(in) :: m
    real(dp), intent(in) :: x(:, :)
    real(dp), intent(inout) :: f(:, :), K(:, :)
    real(dp) :: g(3, 27), Fg(3, 27), D(3, 3), E(3, 3), S(3, 3), FF(3, 3), T(3, 3), det, volume
    real(dp), parameter :: unit(3, 3) = reshape(real([1, 0, 0, 0, 1, 0, 0, 0, 1], dp), [3, 3])
    integer :: l, q, a, b, i, n
    n = m%solid%nodes
    do l = 1, size(m%element, 2)
      associate (node => m%element(:, l))
        do q = 1, m%solid%points
          associate (gradient => m%solid%gradient(:, :n, q))
            g(:, :n) = matmul(inverse(matmul(gradient, transpose(m%X(:, node))), det), gradient)
          end associate
          volume = abs(det) * m%solid%weight(q)
          D = matmul(x(:, node), transpose(g(:, :n)))
          E = 0.5_dp * (matmul(transpose(D), D) - unit)
          FF = matmul(D, transpose(D))
          S = 2 * MU * E + LAMBDA * (E(1, 1) + E(2, 2) + E(3, 3)) * unit
          Fg(:, :n) = matmul(D, g(:, :n))
          do a = 1, n
            f(:, node(a)) = f(:, node(a)) - volume * matmul(D, matmul(S, g(:, a)))
            do b = 1, n
              do i = 1, 3
                T(i, :) = LAMBDA * Fg(i, a) * Fg(:, b) + &
                          MU * (dot_product(g(:, a), g(:, b)) * FF(i, :) + Fg(i, b) * Fg(:, a)) + &
                          dot_product(g(:, a), matmul(S, g(:, b))) * unit(i, :)
              end do
              call add_tangent(m, K, node(a), node(b), volume * T)
            end do
          end do
        end do
      end associate
    end do
  end subroutine
end module
