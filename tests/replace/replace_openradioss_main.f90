! sts_project of runtime/replace/openradioss.f90: quadrature points of a small secondary segment about a known slave
! node.
program replace_openradioss
  use replace_points
  implicit none
  real(rk), parameter :: loc(2) = (/0.3d0, -0.6d0/)
  real(rk) :: x(3,8), xi1, xi2, resid, centre(3), u(3), v(3), n(3)
  integer :: istat
  external :: sts_project

  centre = slave(loc, -0.05d0)
  call frame(loc, u, v, n)
  x(:,1:4) = face
  x(:,5:8) = spread(centre, 2, 4) + 0.1d0*reshape((/-u - v, -u + v, u + v, u - v/), (/3, 4/))
  call sts_project(x, xi1, xi2, 0.d0, 0.d0, 0.d0, 0.d0, .false., istat, resid)
  call check('middle', istat == 0 .and. abs(xi1 - loc(1)) + abs(xi2 - loc(2)) < 1d-9)
  call sts_project(x, xi1, xi2, 0.d0, 0.d0, 0.25d0, -0.5d0, .true., istat, resid)
  call check('from a guess', istat == 0 .and. abs(xi1 - loc(1)) + abs(xi2 - loc(2)) < 1d-9)
  call sts_project(x, xi1, xi2, 0.d0, 0.d0, huge(x)*10, 0.d0, .true., istat, resid)
  call check('from a guess that is no number', istat == 0 .and. abs(xi1 - loc(1)) + abs(xi2 - loc(2)) < 1d-9)
  call sts_project(x, xi1, xi2, 1.d0, -1.d0, 0.d0, 0.d0, .true., istat, resid)
  call check('corner', istat == 0 .and. xi1 < loc(1) .and. xi2 > loc(2))
  x(:,5:8) = x(:,5:8) + spread(20*u, 2, 4)
  call sts_project(x, xi1, xi2, 0.d0, 0.d0, 0.d0, 0.d0, .false., istat, resid)
  call check('beside', xi1 > 1.05d0)
  x(1,6) = huge(x)*10
  call sts_project(x, xi1, xi2, 0.d0, 0.d0, 0.d0, 0.d0, .false., istat, resid)
  call check('not finite', istat == 2 .and. abs(xi1) > 1.05d0)
  call finish()
end program
