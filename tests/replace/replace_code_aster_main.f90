! mmnewt of runtime/replace/code_aster.f90.
subroutine mmnewt_newton(type_elem, nb_node, nb_dim, elem_coor, pt_coor, iter_maxi, tole_maxi, ksi1, ksi2, tang_1, &
                         tang_2, error, l_reli_)
  implicit none
  character(len=8), intent(in)  :: type_elem
  integer, intent(in)           :: nb_node, nb_dim, iter_maxi
  real(kind=8), intent(in)      :: elem_coor(27), pt_coor(3), tole_maxi
  real(kind=8), intent(out)     :: ksi1, ksi2, tang_1(3), tang_2(3)
  integer, intent(out)          :: error
  logical, intent(in), optional :: l_reli_
  ksi1 = sum(elem_coor) + sum(pt_coor) + tole_maxi
  ksi2 = nb_node + nb_dim + iter_maxi + len(type_elem)
  tang_1 = 0
  tang_2 = 0
  error = 7
  if (present(l_reli_)) error = merge(8, 9, l_reli_)
end subroutine
program replace_code_aster
  use replace_points
  implicit none
  interface
    subroutine mmnewt(type_elem, nb_node, nb_dim, elem_coor, pt_coor, iter_maxi, tole_maxi, ksi1, ksi2, tang_1, &
                      tang_2, error, l_reli_)
      character(len=8), intent(in)  :: type_elem
      integer, intent(in)           :: nb_node, nb_dim, iter_maxi
      real(kind=8), intent(in)      :: elem_coor(27), pt_coor(3), tole_maxi
      real(kind=8), intent(out)     :: ksi1, ksi2, tang_1(3), tang_2(3)
      integer, intent(out)          :: error
      logical, intent(in), optional :: l_reli_
    end subroutine
  end interface
  real(rk), parameter :: loc(2) = (/0.3d0, -0.6d0/)
  real(rk) :: x(27), ksi1, ksi2, t1(3), t2(3), u(3), v(3), n(3)
  integer :: error

  x = 0
  x(1:12) = reshape(face, (/12/))
  call frame(loc, u, v, n)
  call mmnewt('QU4     ', 4, 3, x, slave(loc, 0.1d0), 200, 1d-4, ksi1, ksi2, t1, t2, error)
  call check('quadrilateral', error == 0 .and. abs(ksi1 - loc(1)) + abs(ksi2 - loc(2)) < 1d-9)
  call check('tangents', norm2(t1 - u) + norm2(t2 - v) < 1d-8)
  call mmnewt('QU4     ', 4, 3, x, slave((/1.05d0, 0.d0/), 0.1d0), 200, 1d-4, ksi1, ksi2, t1, t2, error, .true.)
  call check('beside', error == 0 .and. abs(ksi1 - 1.05d0) + abs(ksi2) < 1d-6)
  x(1) = huge(x)*10
  call mmnewt('QU4     ', 4, 3, x, slave(loc, 0.1d0), 200, 1d-4, ksi1, ksi2, t1, t2, error)
  call check('not finite', error == 1)
  call mmnewt('TR3     ', 3, 3, x, slave(loc, 0.1d0), 200, 1d-4, ksi1, ksi2, t1, t2, error)
  call check('other cells', error == 7)
  call mmnewt('TR3     ', 3, 3, x, slave(loc, 0.1d0), 200, 1d-4, ksi1, ksi2, t1, t2, error, .true.)
  call check('with a line search', error == 8)
  call mmnewt('TR3     ', 3, 3, x, slave(loc, 0.1d0), 200, 1d-4, ksi1, ksi2, t1, t2, error, .false.)
  call check('without', error == 9)
  call finish()
end program
