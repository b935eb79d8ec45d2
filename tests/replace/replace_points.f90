! A warped face and slave nodes at known xi, eta and gap, for the programs beside it.
module replace_points
  implicit none
  integer, parameter :: rk = kind(1.d0)
  real(rk), parameter :: face(3,4) = reshape((/0.d0, 0.d0, 0.d0, 2.d0, 0.d0, 0.1d0, 2.2d0, 1.5d0, 0.d0, 0.d0, 1.2d0, &
                                               0.1d0/), (/3, 4/))
  integer :: failures = 0
contains
  pure function phi(loc)
    real(rk), intent(in) :: loc(2)
    real(rk) :: phi(4)
    phi = 0.25d0*(1 + (/-1, 1, 1, -1/)*loc(1))*(1 + (/-1, -1, 1, 1/)*loc(2))
  end function
  pure subroutine frame(loc, u, v, n)
    real(rk), intent(in) :: loc(2)
    real(rk), intent(out) :: u(3), v(3), n(3)
    u = 0.25d0*matmul(face, (/-1, 1, 1, -1/)*(1 + (/-1, -1, 1, 1/)*loc(2)))
    v = 0.25d0*matmul(face, (/-1, -1, 1, 1/)*(1 + (/-1, 1, 1, -1/)*loc(1)))
    n = (/u(2)*v(3) - u(3)*v(2), u(3)*v(1) - u(1)*v(3), u(1)*v(2) - u(2)*v(1)/)
    n = n/norm2(n)
  end subroutine
  pure function slave(loc, gap)
    real(rk), intent(in) :: loc(2), gap
    real(rk) :: slave(3), u(3), v(3), n(3)
    call frame(loc, u, v, n)
    slave = matmul(face, phi(loc)) + gap*n
  end function
  subroutine check(name, good)
    character(len=*), intent(in) :: name
    logical, intent(in) :: good
    if (good) return
    failures = failures + 1
    print '(a)', '# ' // name
  end subroutine
  subroutine finish()
    if (failures > 0) error stop 1
  end subroutine
end module
