! footpoint for Fortran 2003: the functions of footpoint.h, footpoint_face.h and footpoint_patch.h under the same names, which see for what
! they do; of those on faces and patches no argument may be left out.
!
!     use footpoint
!     status = footpoint_locate(xA, xB, xC, xD, xS, loc, gap)
!
! Nothing here but interfaces: the module needs no object file, only -lfootpoint -lm.  Kinds are those of
! iso_c_binding; real(c_double) is double precision, integer(c_int) the default integer.  Coordinates are xyz(3,nodes),
! connectivity seg(4,n).  As in C, node indices and `chosen` count from 0.
module footpoint
  use, intrinsic :: iso_c_binding, only: c_int, c_size_t, c_double, c_ptr
  implicit none
  private :: c_int, c_size_t, c_double, c_ptr

  ! An answer is written where status >= FOOTPOINT_OK, and nothing where it is less.
  integer(c_int), parameter :: FOOTPOINT_OK = 0
  integer(c_int), parameter :: FOOTPOINT_OUTSIDE = 1
  integer(c_int), parameter :: FOOTPOINT_NOT_UNIQUE = 2
  integer(c_int), parameter :: FOOTPOINT_NO_AREA = 3
  integer(c_int), parameter :: FOOTPOINT_UNPROVED = 4
  integer(c_int), parameter :: FOOTPOINT_ERR_NOT_FINITE = -1
  integer(c_int), parameter :: FOOTPOINT_ERR_DEGENERATE = -2
  integer(c_int), parameter :: FOOTPOINT_ERR_DOMAIN = -3
  integer(c_int), parameter :: FOOTPOINT_ERR_NO_CONVERGENCE = -4
  integer(c_int), parameter :: FOOTPOINT_ERR_ARGUMENT = -5
  integer(c_int), parameter :: FOOTPOINT_ERR_UNPROVED = -6

  ! Kinds of faces.
  integer(c_int), parameter :: FOOTPOINT_TRI3 = 0
  integer(c_int), parameter :: FOOTPOINT_TRI6 = 1
  integer(c_int), parameter :: FOOTPOINT_QUAD4 = 2
  integer(c_int), parameter :: FOOTPOINT_QUAD8 = 3
  integer(c_int), parameter :: FOOTPOINT_QUAD9 = 4
  integer(c_int), parameter :: FOOTPOINT_EDGE2 = 6
  integer(c_int), parameter :: FOOTPOINT_EDGE3 = 7

  ! Kinds of patches.
  integer(c_int), parameter :: FOOTPOINT_BEZIER = 0
  integer(c_int), parameter :: FOOTPOINT_GREGORY = 1

  ! Points that footpoint_stationary finds at most.
  integer(c_int), parameter :: FOOTPOINT_STATIONARY_MOST = 5

  type, bind(C) :: footpoint_derivatives
    real(c_double) :: phi(4), r_xi(3), r_eta(3), normal(3), gap, d_xi(15), d_eta(15), d_gap(15)
  end type

  interface
    ! A C string; c_f_pointer makes characters of it.
    function footpoint_strerror(status) bind(C)
      import :: c_int, c_ptr
      integer(c_int), value :: status
      type(c_ptr) :: footpoint_strerror
    end function

    function footpoint_locate(xA, xB, xC, xD, xS, loc, gap) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3)
      real(c_double), intent(inout) :: loc(2), gap
      integer(c_int) :: status
    end function

    function footpoint_locate_pairs(n, xyz, nodes, seg, slave, loc, gap, status) bind(C) result(failed)
      import :: c_int, c_size_t, c_double
      integer(c_size_t), value :: n, nodes
      real(c_double), intent(in) :: xyz(3, *)
      integer(c_int), intent(in) :: seg(4, *), slave(*)
      real(c_double), intent(inout) :: loc(2, *), gap(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_size_t) :: failed
    end function

    function footpoint_along(xA, xB, xC, xD, xS, along, loc, dist) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3), along(3)
      real(c_double), intent(inout) :: loc(2), dist
      integer(c_int) :: status
    end function

    function footpoint_newton(xA, xB, xC, xD, xS, max_iterations, tolerance, loc, gap, iterations) bind(C) &
        result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3)
      integer(c_int), value :: max_iterations
      real(c_double), value :: tolerance
      real(c_double), intent(inout) :: loc(2), gap
      integer(c_int), intent(inout) :: iterations
      integer(c_int) :: status
    end function

    function footpoint_select_segment(xyz, master, candidates, seg, xS, chosen) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xyz(3, *), xS(3)
      integer(c_int), value :: master, candidates
      integer(c_int), intent(in) :: seg(4, *)
      integer(c_int), intent(inout) :: chosen
      integer(c_int) :: status
    end function

    function footpoint_normal(corner, next, previous, m) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: corner(3), next(3), previous(3)
      real(c_double), intent(inout) :: m(3)
      integer(c_int) :: status
    end function

    function footpoint_gap(xA, xB, xC, xD, xS, loc, m, gap) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3), loc(2), m(3)
      real(c_double), intent(inout) :: gap
      integer(c_int) :: status
    end function

    function footpoint_force(gap, stiffness, m, loc, fs, fm) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), value :: gap, stiffness
      real(c_double), intent(in) :: m(3), loc(2)
      real(c_double), intent(inout) :: fs(3), fm(3, 4)
      integer(c_int) :: status
    end function

    function footpoint_select_closest(xyz, master, candidates, seg, xS, chosen, distance) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xyz(3, *), xS(3)
      integer(c_int), value :: master, candidates
      integer(c_int), intent(in) :: seg(4, *)
      integer(c_int), intent(inout) :: chosen
      real(c_double), intent(inout) :: distance
      integer(c_int) :: status
    end function

    function footpoint_force_balanced(xA, xB, xC, xD, xS, loc, stiffness, fs, fm) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3), loc(2)
      real(c_double), value :: stiffness
      real(c_double), intent(inout) :: fs(3), fm(3, 4)
      integer(c_int) :: status
    end function

    function footpoint_element_normal(nodes, gap, d_gap, hessian, stiffness, multiplier, pressure, force, tangent) &
        bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: nodes
      real(c_double), value :: gap, stiffness, multiplier
      real(c_double), intent(in) :: d_gap(*), hessian(*)
      real(c_double), intent(inout) :: pressure, force(*), tangent(*)
      integer(c_int) :: status
    end function

    function footpoint_element_friction(nodes, x, phi, r_xi, r_eta, normal, d_gap, d_normal, pressure, stiffness, &
        friction, tangential, slip, force, tangent) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: nodes
      real(c_double), intent(in) :: x(3, *), phi(*), r_xi(3), r_eta(3), normal(3), d_gap(*), d_normal(*)
      real(c_double), value :: pressure, stiffness, friction, tangential
      real(c_double), intent(inout) :: slip(2), force(*), tangent(*)
      integer(c_int) :: status
    end function

    function footpoint_certify(xA, xB, xC, xD, xS, loc, rho) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3), loc(2)
      real(c_double), intent(inout) :: rho(2)
      integer(c_int) :: status
    end function

    function footpoint_robust(xA, xB, xC, xD, xS, loc, dist) bind(C) result(status)
      import :: c_int, c_double
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3)
      real(c_double), intent(inout) :: loc(2), dist
      integer(c_int) :: status
    end function

    function footpoint_stationary(xA, xB, xC, xD, xS, loc, count) bind(C) result(status)
      import :: c_int, c_double, FOOTPOINT_STATIONARY_MOST
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3)
      real(c_double), intent(inout) :: loc(2, FOOTPOINT_STATIONARY_MOST)
      integer(c_int), intent(inout) :: count
      integer(c_int) :: status
    end function

    function footpoint_differentiate(xA, xB, xC, xD, xS, loc, out) bind(C) result(status)
      import :: c_int, c_double, footpoint_derivatives
      real(c_double), intent(in) :: xA(3), xB(3), xC(3), xD(3), xS(3), loc(2)
      type(footpoint_derivatives), intent(inout) :: out
      integer(c_int) :: status
    end function
    function footpoint_face_nodes(face) bind(C) result(nodes)
      import :: c_int
      integer(c_int), value :: face
      integer(c_int) :: nodes
    end function

    function footpoint_face_locate(face, x, loc, gap) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *)
      real(c_double), intent(inout) :: loc(2), gap
      integer(c_int) :: status
    end function

    ! seg: nodes of a face after those of another.
    function footpoint_face_locate_pairs(face, n, xyz, nodes, seg, slave, loc, gap, status) bind(C) result(failed)
      import :: c_int, c_size_t, c_double
      integer(c_int), value :: face
      integer(c_size_t), value :: n, nodes
      real(c_double), intent(in) :: xyz(3, *)
      integer(c_int), intent(in) :: seg(*), slave(*)
      real(c_double), intent(inout) :: loc(2, *), gap(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_size_t) :: failed
    end function

    function footpoint_track(face, x, loc, gap) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *)
      real(c_double), intent(inout) :: loc(2), gap
      integer(c_int) :: status
    end function

    function footpoint_track_pairs(face, n, xyz, nodes, seg, slave, loc, gap, status) bind(C) result(failed)
      import :: c_int, c_size_t, c_double
      integer(c_int), value :: face
      integer(c_size_t), value :: n, nodes
      real(c_double), intent(in) :: xyz(3, *)
      integer(c_int), intent(in) :: seg(*), slave(*)
      real(c_double), intent(inout) :: loc(2, *), gap(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_size_t) :: failed
    end function

    function footpoint_face_along(face, x, along, loc, dist) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *), along(3)
      real(c_double), intent(inout) :: loc(2), dist
      integer(c_int) :: status
    end function

    function footpoint_face_along_pairs(face, n, xyz, nodes, seg, slave, along, loc, dist, status) bind(C) &
        result(failed)
      import :: c_int, c_size_t, c_double
      integer(c_int), value :: face
      integer(c_size_t), value :: n, nodes
      real(c_double), intent(in) :: xyz(3, *), along(3, *)
      integer(c_int), intent(in) :: seg(*), slave(*)
      real(c_double), intent(inout) :: loc(2, *), dist(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_size_t) :: failed
    end function

    function footpoint_face_closest(face, x, loc, distance, region) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *)
      real(c_double), intent(inout) :: loc(2), distance
      integer(c_int), intent(inout) :: region
      integer(c_int) :: status
    end function

    function footpoint_face_robust(face, x, loc, distance, region) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *)
      real(c_double), intent(inout) :: loc(2), distance
      integer(c_int), intent(inout) :: region
      integer(c_int) :: status
    end function

    function footpoint_face_robust_pairs(face, n, xyz, nodes, seg, slave, loc, distance, region, status) bind(C) &
        result(failed)
      import :: c_int, c_size_t, c_double
      integer(c_int), value :: face
      integer(c_size_t), value :: n, nodes
      real(c_double), intent(in) :: xyz(3, *)
      integer(c_int), intent(in) :: seg(*), slave(*)
      real(c_double), intent(inout) :: loc(2, *), distance(*)
      integer(c_int), intent(inout) :: region(*), status(*)
      integer(c_size_t) :: failed
    end function

    function footpoint_face_select(face, xyz, candidates, seg, xS, chosen, loc, distance, region) bind(C) result(status)
      import :: c_int, c_size_t, c_double
      integer(c_int), value :: face
      integer(c_size_t), value :: candidates
      real(c_double), intent(in) :: xyz(3, *), xS(3)
      integer(c_int), intent(in) :: seg(*)
      integer(c_size_t), intent(inout) :: chosen
      real(c_double), intent(inout) :: loc(2), distance
      integer(c_int), intent(inout) :: region
      integer(c_int) :: status
    end function

    function footpoint_face_place(face, x, loc, phi, r_xi, r_eta, normal, gap) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *), loc(2)
      real(c_double), intent(inout) :: phi(*), r_xi(3), r_eta(3), normal(3), gap
      integer(c_int) :: status
    end function

    function footpoint_face_differentiate(face, x, loc, phi, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap) bind(C) &
        result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *), loc(2)
      real(c_double), intent(inout) :: phi(*), r_xi(3), r_eta(3), normal(3), gap, d_xi(*), d_eta(*), d_gap(*)
      integer(c_int) :: status
    end function

    function footpoint_face_hessian(face, x, loc, gap, d_xi, d_eta, d_gap, d_normal, hessian) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *), loc(2)
      real(c_double), intent(inout) :: gap, d_xi(*), d_eta(*), d_gap(*), d_normal(*), hessian(*)
      integer(c_int) :: status
    end function

    function footpoint_face_differentiate_along(face, x, along, loc, dist, d_xi, d_eta, d_dist, h_xi, h_eta, h_dist) &
        bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: face
      real(c_double), intent(in) :: x(3, *), along(3), loc(2)
      real(c_double), intent(inout) :: dist, d_xi(*), d_eta(*), d_dist(*), h_xi(*), h_eta(*), h_dist(*)
      integer(c_int) :: status
    end function

    ! x: corners, unit normals there, slave node.
    function footpoint_patch_locate(patch, x, loc, gap) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: patch
      real(c_double), intent(in) :: x(3, 9)
      real(c_double), intent(inout) :: loc(2), gap
      integer(c_int) :: status
    end function

    function footpoint_patch_locate_pairs(patch, n, xyz, normals, nodes, seg, slave, loc, gap, status) bind(C) &
        result(failed)
      import :: c_int, c_size_t, c_double
      integer(c_int), value :: patch
      integer(c_size_t), value :: n, nodes
      real(c_double), intent(in) :: xyz(3, *), normals(3, *)
      integer(c_int), intent(in) :: seg(4, *), slave(*)
      real(c_double), intent(inout) :: loc(2, *), gap(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_size_t) :: failed
    end function

    function footpoint_patch_place(patch, x, loc, r, r_xi, r_eta, normal, gap) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: patch
      real(c_double), intent(in) :: x(3, 9), loc(2)
      real(c_double), intent(inout) :: r(3), r_xi(3), r_eta(3), normal(3), gap
      integer(c_int) :: status
    end function

    function footpoint_patch_differentiate(patch, x, loc, r, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap, d_xi_n, &
        d_eta_n, d_gap_n) bind(C) result(status)
      import :: c_int, c_double
      integer(c_int), value :: patch
      real(c_double), intent(in) :: x(3, 9), loc(2)
      real(c_double), intent(inout) :: r(3), r_xi(3), r_eta(3), normal(3), gap
      real(c_double), intent(inout) :: d_xi(3, 5), d_eta(3, 5), d_gap(3, 5), d_xi_n(3, 4), d_eta_n(3, 4), d_gap_n(3, 4)
      integer(c_int) :: status
    end function
  end interface
end module footpoint
