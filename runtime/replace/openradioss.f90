! OpenRadioss, surface-to-surface contact (engine/source/interfaces/ists): replaces the subroutine sts_project, which
! finds the point of a four-node primary segment below a quadrature point of a secondary segment.
!  xupd(3,8)              nodes of the primary segment, then of the secondary
!  xi1, xi2       [out]   local coordinates on the primary segment; huge if there is no foot point, so that the
!                         caller skips the pair
!  eta1, eta2             of the quadrature point, on the secondary segment
!  xi1_guess, xi2_guess   from the warm-start table if use_guess: the search starts there and, like the iteration that it
!                         replaces, returns the minimum of the distance to which it leads
!  istat          [out]   0 found, 2 not found
!  resid          [out]   0
subroutine sts_project(xupd, xi1, xi2, eta1, eta2, xi1_guess, xi2_guess, use_guess, istat, resid)
  use footpoint_unclamped
  implicit none
  real*8, intent(in)    :: xupd(3,8), eta1, eta2, xi1_guess, xi2_guess
  logical, intent(in)   :: use_guess
  real*8, intent(inout) :: xi1, xi2
  integer, intent(out)  :: istat
  real*8, intent(out)   :: resid
  real*8 :: xs(3), loc(2), gap

  xs = 0.25d0*((1 - eta1)*((1 - eta2)*xupd(:,5) + (1 + eta2)*xupd(:,8)) &
             + (1 + eta1)*((1 - eta2)*xupd(:,6) + (1 + eta2)*xupd(:,7)))
  resid = 0
  if (use_guess) then
    loc = [xi1_guess, xi2_guess]
    istat = tracked(xupd(:,1), xupd(:,2), xupd(:,3), xupd(:,4), xs, loc, gap)
  else
    istat = unclamped(xupd(:,1), xupd(:,2), xupd(:,3), xupd(:,4), xs, loc, gap)
  end if
  if (istat /= FOOTPOINT_OK) then
    istat = 2
    loc = huge(loc)
  end if
  xi1 = loc(1)
  xi2 = loc(2)
end subroutine
