! Two elastic plates collide: impact.c in Fortran. Explicit dynamics with penalty contact; slave nodes of the upper
! plate meet master segments of the lower plate. Central differences; global search by buckets; local search by Newton's
! iteration or by footpoint. Two worlds advance side by side, each with its own local search.
!
!     footpoint-codegen --allow-poles --language fortran evolve/genomes/quad4.gen -o footpoint_quad4.f90
!     gfortran -O3 -march=native -flto footpoint_quad4.f90 plates.f90 impact.f90 -o impact
!     ./impact                 both searches, a table
!     ./impact 0.5 FOLDER      half the time step; VTK files in a folder that exists
!
! -flto inlines the search into the loop over pairs, which then vectorises.
program impact
  use plates
  use footpoint_quad4, only: footpoint_quad4_balanced_at
  implicit none
  real(dp), parameter :: FINAL = 0.03_dp                       ! ms
  real(dp), parameter :: VELOCITY(3) = [20d0, 5d0, -40d0]      ! of the upper plate, mm/ms
  real(dp), parameter :: REACH = 0.3_dp, DEPTH = 0.5_dp        ! range of the global search, and largest penetration; mm
  integer, parameter :: GLOBAL_EVERY = 10, BLOCK = 128, FRAMES = 20
  integer, parameter :: NEWTON = 1, FOOTPOINT = 2

  ! A moving state, with its contact pairs and the times of its searches.
  type :: world
    integer :: search
    real(dp), allocatable :: x(:, :), v(:, :), f(:, :)
    integer :: pairs = 0
    integer, allocatable :: pair_seg(:), pair_slave(:), nearest(:) ! the last one: pair of each slave node, 0: none
    real(dp), allocatable :: xi(:), eta(:), distance(:)
    real(dp) :: strain, contact
    real(dp) :: global = 0, total = 0, searched = 0 ! seconds, seconds, pairs
    real(dp), allocatable :: local(:)               ! indexed by step: seconds of local search per pair
  end type

  ! Initial energy and momenta, and their largest relative deviations.
  type :: balance
    real(dp) :: energy = 0, momentum(3) = 0, moment(3) = 0, worst(3) = 0
  end type

  type(model) :: m
  type(world) :: w(2)
  type(balance) :: b(2)
  real(dp) :: scale, dt, ns(2)
  character(4096) :: argument, folder
  integer :: i, step, steps, bad

  scale = 1
  call get_command_argument(1, argument)
  bad = 0
  if (argument /= '') read (argument, *, iostat=bad) scale
  if (bad /= 0 .or. .not. (scale > 0 .and. scale <= 1)) stop 'usage: impact [SCALE [FOLDER]]: of the time step, to 1'
  call get_command_argument(2, folder)
  call make_plates(m)
  dt = scale * m%dt
  steps = ceiling(FINAL / dt)
  do i = 1, 2
    call start(w(i), i)
    call take_balance(w(i), b(i), .true.)
  end do
  do step = 1, steps
    do i = 1, 2
      call advance(w(i))
      call take_balance(w(i), b(i), .false.)
    end do
    i = step * FRAMES / steps
    if (folder /= '' .and. i /= (step - 1) * FRAMES / steps) call write_vtk(w(2), i)
  end do

  ns = [(1e9_dp * median(w(i)%local), i=1, 2)]
  print '(i0, 3(a, i0), a)', size(m%element), ' elements, ', size(m%slave), ' slave nodes, ', size(m%seg, 2), &
    ' segments, ', steps, ' steps'
  print '(a34, 2a13)', '', 'Newton', 'footpoint'
  print '(a34, 2f13.1)', 'pairs searched in a step          ', w%searched / steps
  print '(a34, 2f13.2, f8.2, a)', 'local search, ns a pair           ', ns, ns(1) / ns(2), ' times'
  print '(a34, 2f13.2)', 'global search, ms                 ', 1e3_dp * w%global
  print '(a34, 2f13.2)', 'everything, ms                    ', 1e3_dp * w%total
  print '(a34, 2es19.11)', 'energy, N mm                      ', b%energy
  print '(a34, 2es13.4)', 'energy error, relative            ', b%worst(1)
  print '(a34, 2es13.4)', 'momentum error, relative          ', b%worst(2)
  print '(a34, 2es13.4)', 'moment of momentum error, relative', b%worst(3)
  print '(a34, 13x, es13.4)', 'nodes apart at the end, mm, worst ', maxval(norm2(w(1)%x - w(2)%x, 1))
  print '(a34, 2es19.11)', 'kinetic energy at the end, N mm   ', (kinetic(w(i)), i=1, 2)

contains

  real(dp) function seconds()
    integer(selected_int_kind(18)) :: count, rate
    call system_clock(count, rate)
    seconds = real(count, dp) / rate
  end function

  subroutine start(w, search)
    type(world), intent(inout) :: w
    integer, intent(in) :: search
    w%search = search
    w%x = m%x
    w%v = 0 * m%x
    w%f = w%v
    w%v(:, m%first_upper:) = spread(VELOCITY, 2, size(m%x, 2) - m%first_upper + 1)
    allocate (w%nearest(size(m%slave)), w%distance(size(m%slave)), w%local(steps))
    allocate (w%pair_seg(0), w%pair_slave(0), w%xi(0), w%eta(0))
    call forces(w, 0)
    w%global = 0
    w%searched = 0
  end subroutine

  ! ---- global search ----

  ! Finds pairs of a segment and the slave nodes within REACH of its box. Slave nodes lie in buckets of 1 mm.
  subroutine global_search(w)
    type(world), intent(inout) :: w
    real(dp) :: low(3), high(3), from(3), to(3)
    integer :: n(3), a(3), b(3), c(3), s, seg, i, j, k
    integer, allocatable :: head(:, :, :), next(:)
    low = minval(w%x(:, m%slave), 2)
    high = maxval(w%x(:, m%slave), 2)
    n = 1 + int(high - low)
    allocate (head(n(1), n(2), n(3)), next(size(m%slave)))
    head = 0
    do s = size(m%slave), 1, -1
      c = cell(w%x(:, m%slave(s)), low, n)
      next(s) = head(c(1), c(2), c(3))
      head(c(1), c(2), c(3)) = s
    end do
    w%pairs = 0
    do seg = 1, size(m%seg, 2)
      from = minval(w%x(:, m%seg(:, seg)), 2) - REACH
      to = maxval(w%x(:, m%seg(:, seg)), 2) + REACH
      a = cell(from, low, n)
      b = cell(to, low, n)
      do k = a(3), b(3)
        do j = a(2), b(2)
          do i = a(1), b(1)
            s = head(i, j, k)
            do while (s > 0)
              if (all(w%x(:, m%slave(s)) >= from .and. w%x(:, m%slave(s)) <= to)) call add_pair(w, seg, s)
              s = next(s)
            end do
          end do
        end do
      end do
    end do
  end subroutine

  pure function cell(x, low, n)
    real(dp), intent(in) :: x(3), low(3)
    integer, intent(in) :: n(3)
    integer :: cell(3)
    cell = 1 + int(max(0d0, min(n - 1d0, x - low)))
  end function

  subroutine add_pair(w, seg, slave)
    type(world), intent(inout) :: w
    integer, intent(in) :: seg, slave
    if (w%pairs == size(w%pair_seg)) then
      w%pair_seg = [w%pair_seg, spread(0, 1, w%pairs + 1024)]
      w%pair_slave = [w%pair_slave, spread(0, 1, w%pairs + 1024)]
      w%xi = [w%xi, spread(0d0, 1, w%pairs + 1024)]
      w%eta = [w%eta, spread(0d0, 1, w%pairs + 1024)]
    end if
    w%pairs = w%pairs + 1
    w%pair_seg(w%pairs) = seg
    w%pair_slave(w%pairs) = slave
  end subroutine

  ! ---- local search: xi and eta of all pairs ----

  ! Newton's iteration from the centre on r_xi . (S - r) = r_eta . (S - r) = 0, r = c0 + c1 xi + c2 eta + c3 xi eta.
  pure subroutine iterate(xA, xB, xC, xD, xS, xi, eta)
    real(dp), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3)
    real(dp), intent(out) :: xi, eta
    real(dp) :: c0(3), c1(3), c2(3), c3(3), a(3), b(3), d(3), aa, bb, ab, ad, bd, inverse, u, v
    integer :: n
    c0 = xS - 0.25_dp * (xA + xB + xC + xD)
    c1 = 0.25_dp * (xB - xA + xC - xD)
    c2 = 0.25_dp * (xD - xA + xC - xB)
    c3 = 0.25_dp * (xA - xB + xC - xD)
    xi = 0
    eta = 0
    do n = 1, 20
      a = c1 + c3 * eta
      b = c2 + c3 * xi
      d = c0 - c1 * xi - b * eta
      aa = dot_product(a, a)
      bb = dot_product(b, b)
      ab = dot_product(a, b) - dot_product(c3, d)
      ad = dot_product(a, d)
      bd = dot_product(b, d)
      inverse = 1 / (aa * bb - ab * ab)
      u = (bb * ad - ab * bd) * inverse
      v = (aa * bd - ab * ad) * inverse
      xi = xi + u
      eta = eta + v
      if (abs(u) < 1e-8_dp .and. abs(v) < 1e-8_dp) return
    end do
  end subroutine

  subroutine search_newton(w)
    type(world), intent(inout) :: w
    integer :: p, n(4)
    do p = 1, w%pairs
      n = m%seg(:, w%pair_seg(p))
      call iterate(w%x(:, n(1)), w%x(:, n(2)), w%x(:, n(3)), w%x(:, n(4)), w%x(:, m%slave(w%pair_slave(p))), w%xi(p), &
                   w%eta(p))
    end do
  end subroutine

  ! Searches by footpoint: coordinates are copied into columns, over which the loop vectorises.
  subroutine search_footpoint(w)
    type(world), intent(inout) :: w
    real(dp) :: x(BLOCK, 3, 5), xi(BLOCK), eta(BLOCK)
    integer :: first, p, k, n
    do first = 0, w%pairs - 1, BLOCK
      n = min(BLOCK, w%pairs - first)
      do p = 1, n
        do k = 1, 4
          x(p, :, k) = w%x(:, m%seg(k, w%pair_seg(first + p)))
        end do
        x(p, :, 5) = w%x(:, m%slave(w%pair_slave(first + p)))
      end do
      do p = 1, n
        call footpoint_quad4_balanced_at([x(p, 1, 1), x(p, 2, 1), x(p, 3, 1)], [x(p, 1, 2), x(p, 2, 2), x(p, 3, 2)], &
                                         [x(p, 1, 3), x(p, 2, 3), x(p, 3, 3)], [x(p, 1, 4), x(p, 2, 4), x(p, 3, 4)], &
                                         [x(p, 1, 5), x(p, 2, 5), x(p, 3, 5)], xi(p), eta(p))
      end do
      w%xi(first + 1:first + n) = xi(:n)
      w%eta(first + 1:first + n) = eta(:n)
    end do
  end subroutine

  ! ---- contact forces ----

  pure function cross(a, b)
    real(dp), intent(in) :: a(3), b(3)
    real(dp) :: cross(3)
    cross = cshift(a, 1) * cshift(b, 2) - cshift(a, 2) * cshift(b, 1)
  end function

  ! Computes shape functions, gap vector S - r and unit normal at (xi,eta).
  pure subroutine foot(w, pair, xi, eta, phi, d, n)
    type(world), intent(in) :: w
    integer, intent(in) :: pair
    real(dp), intent(in) :: xi, eta
    real(dp), intent(out) :: phi(4), d(3), n(3)
    real(dp) :: s, t, u(3), v(3), x(3)
    integer :: k
    d = w%x(:, m%slave(w%pair_slave(pair)))
    u = 0
    v = 0
    do k = 1, 4
      s = CORNER(1, k)
      t = CORNER(2, k)
      phi(k) = 0.25_dp * (1 + s * xi) * (1 + t * eta)
      x = w%x(:, m%seg(k, w%pair_seg(pair)))
      d = d - phi(k) * x
      u = u + 0.25_dp * s * (1 + t * eta) * x
      v = v + 0.25_dp * t * (1 + s * xi) * x
    end do
    n = cross(u, v)
    n = n / sqrt(dot_product(n, n))
  end subroutine

  ! Assigns each slave node to the segment with the nearest point.
  subroutine choose_segments(w)
    type(world), intent(inout) :: w
    real(dp) :: phi(4), d(3), n(3), distance
    integer :: p, s
    w%nearest = 0
    w%distance = DEPTH
    do p = 1, w%pairs
      s = w%pair_slave(p)
      w%xi(p) = max(-1d0, min(1d0, w%xi(p)))
      w%eta(p) = max(-1d0, min(1d0, w%eta(p)))
      call foot(w, p, w%xi(p), w%eta(p), phi, d, n)
      distance = sqrt(dot_product(d, d))
      if (distance < w%distance(s)) then
        w%distance(s) = distance
        w%nearest(s) = p
      end if
    end do
  end subroutine

  ! Adds penalty forces (10), (11) for negative gaps, and their energy.
  real(dp) function contact_forces(w) result(energy)
    type(world), intent(inout) :: w
    real(dp) :: phi(4), d(3), n(3), gap
    integer :: s, p, k, node
    energy = 0
    do s = 1, size(m%slave)
      p = w%nearest(s)
      if (p == 0) cycle
      call foot(w, p, w%xi(p), w%eta(p), phi, d, n)
      gap = dot_product(d, n)
      if (gap >= 0) cycle
      w%f(:, m%slave(s)) = w%f(:, m%slave(s)) - PENALTY * gap * n
      do k = 1, 4
        node = m%seg(k, w%pair_seg(p))
        w%f(:, node) = w%f(:, node) + phi(k) * PENALTY * gap * n
      end do
      energy = energy + 0.5_dp * PENALTY * gap**2
    end do
  end function

  ! ---- the loop ----

  subroutine forces(w, step)
    type(world), intent(inout) :: w
    integer, intent(in) :: step
    real(dp) :: begin, local, end
    w%f = 0
    w%strain = internal_forces(m, w%x, w%f)
    begin = seconds()
    if (mod(step, GLOBAL_EVERY) == 0) call global_search(w)
    local = seconds()
    if (w%search == NEWTON) call search_newton(w)
    if (w%search == FOOTPOINT) call search_footpoint(w)
    end = seconds()
    call choose_segments(w)
    w%contact = contact_forces(w)
    w%global = w%global + local - begin
    w%searched = w%searched + w%pairs
    if (step > 0) w%local(step) = (end - local) / max(1, w%pairs)
  end subroutine

  subroutine advance(w)
    type(world), intent(inout) :: w
    real(dp) :: begin
    begin = seconds()
    call kick(w)
    w%x = w%x + dt * w%v
    call forces(w, step)
    call kick(w)
    w%total = w%total + seconds() - begin
  end subroutine

  subroutine kick(w)
    type(world), intent(inout) :: w
    integer :: n
    do n = 1, size(w%v, 2)
      w%v(:, n) = w%v(:, n) + 0.5_dp * dt * w%f(:, n) / m%mass(n)
    end do
  end subroutine

  ! ---- results ----

  pure real(dp) function kinetic(w)
    type(world), intent(in) :: w
    kinetic = 0.5_dp * sum(m%mass * sum(w%v**2, 1))
  end function

  subroutine take_balance(w, b, first)
    type(world), intent(in) :: w
    type(balance), intent(inout) :: b
    logical, intent(in) :: first
    real(dp) :: energy, momentum(3), moment(3)
    integer :: n
    energy = kinetic(w) + w%strain + w%contact
    momentum = matmul(w%v, m%mass)
    moment = 0
    do n = 1, size(m%mass)
      moment = moment + m%mass(n) * cross(w%x(:, n), w%v(:, n))
    end do
    if (first) b = balance(energy, momentum, moment)
    b%worst = max(b%worst, [abs(energy / b%energy - 1), norm2(momentum - b%momentum) / norm2(b%momentum), &
                            norm2(moment - b%moment) / norm2(b%moment)])
  end subroutine

  ! Writes a frame for ParaView or VisIt: the deformed plates with velocities.
  subroutine write_vtk(w, frame)
    type(world), intent(in) :: w
    integer, intent(in) :: frame
    character(16) :: name
    integer :: unit, e, elements
    elements = size(m%hex, 2)
    write (name, '(a, i4.4, a)') 'impact_', frame, '.vtk'
    open (newunit=unit, file=trim(folder)//'/'//name, status='replace', action='write')
    write (unit, '(a)') '# vtk DataFile Version 3.0', 'impact', 'ASCII', 'DATASET UNSTRUCTURED_GRID'
    write (unit, '(a, i0, a)') 'POINTS ', size(w%x, 2), ' double'
    write (unit, '(3es16.6e3)') w%x
    write (unit, '(a, i0, 1x, i0)') 'CELLS ', elements, 9 * elements
    write (unit, '(9(i0, :, 1x))') (8, m%hex(:, e) - 1, e=1, elements)
    write (unit, '(a, i0)') 'CELL_TYPES ', elements
    write (unit, '(a)') ('12', e=1, elements)
    write (unit, '(a, i0)') 'POINT_DATA ', size(w%x, 2)
    write (unit, '(a)') 'VECTORS velocity double'
    write (unit, '(3es14.4e3)') w%v
    close (unit)
  end subroutine

  ! Returns the median over the steps, which excludes interrupted steps.
  pure real(dp) function median(x)
    real(dp), intent(in) :: x(:)
    integer :: i
    median = 0
    do i = 1, size(x)
      median = x(i)
      if (count(x < median) <= size(x) / 2 .and. count(x > median) <= size(x) / 2) return
    end do
  end function
end program impact
