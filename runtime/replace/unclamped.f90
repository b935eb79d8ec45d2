! Shared by the adapters in Fortran: the foot point on a four-node face, or beside it if the closest point of the face
! lies on its edge; and the foot point from the code's own start.
module footpoint_unclamped
  use footpoint
  implicit none
contains
  ! Returns FOOTPOINT_OK with loc and gap; |loc| <= 1 only if no point of the face is nearer. With other statuses loc
  ! and gap are not written.
  function unclamped(xA, xB, xC, xD, xS, loc, gap) result(status)
    real*8, intent(in)    :: xA(3), xB(3), xC(3), xD(3), xS(3)
    real*8, intent(inout) :: loc(2), gap
    integer :: status, iterations
    real*8  :: at(2), edge(2), g

    status = footpoint_locate(xA, xB, xC, xD, xS, loc, gap)
    if (status == FOOTPOINT_OK) return
    status = footpoint_robust(xA, xB, xC, xD, xS, at, g)
    if (status == FOOTPOINT_OUTSIDE) then
      edge = at
      status = footpoint_newton(xA, xB, xC, xD, xS, 20, 1d-12, at, g, iterations)
      ! a foot point inside, but not the closest point
      if (status == FOOTPOINT_OK .and. maxval(abs(at)) <= 1 .and. maxval(abs(at - edge)) > 1d-9) status = FOOTPOINT_OUTSIDE
    end if
    if (status /= FOOTPOINT_OK) return
    loc = at
    gap = g
  end function

  ! The same from the start in loc, for codes that want the minimum that an iteration from there finds; on a folded face
  ! another point may be nearer. Without a proof from there, unclamped() answers.
  function tracked(xA, xB, xC, xD, xS, loc, gap) result(status)
    real*8, intent(in)    :: xA(3), xB(3), xC(3), xD(3), xS(3)
    real*8, intent(inout) :: loc(2), gap
    integer :: status

    status = footpoint_track(FOOTPOINT_QUAD4, reshape([xA, xB, xC, xD, xS], [3, 5]), loc, gap)
    if (status /= FOOTPOINT_OK) status = unclamped(xA, xB, xC, xD, xS, loc, gap)
  end function
end module
