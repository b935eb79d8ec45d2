! FrontISTR: replaces the subroutine project_Point2Element of m_fstr_contact_geom, which projects a point on a surface
! element. Rename FrontISTR's own to project_Point2Element_newton; it still serves elements other than four-node
! quadrilaterals. The search starts from the last iteration's position, ctpos, if there is one. Like the iteration that
! it replaces, it then returns the minimum of the distance to which this start leads.
subroutine project_Point2Element(xyz, etype, nn, elemt, reflen, cstate, isin, distclr, ctpos, localclr)
  use hecmw, only: kreal
  use elementInfo, only: fe_quad4n
  use mContactDef, only: tContactState, CONTACTFREE, CONTACTSTICK
  use m_fstr_contact_newton, only: project_Point2Element_newton
  use footpoint_unclamped
  implicit none
  real(kind=kreal), intent(in)       :: xyz(3), elemt(:,:), reflen, distclr
  integer, intent(in)                :: etype, nn
  type(tContactState), intent(inout) :: cstate
  logical, intent(out)               :: isin
  real(kind=kreal), optional         :: ctpos(2), localclr
  type(footpoint_derivatives)        :: at
  real(kind=kreal) :: loc(2), gap, clr
  integer          :: before, status

  if (etype /= fe_quad4n .or. cstate%interference_flag /= 0) then
    call project_Point2Element_newton(xyz, etype, nn, elemt, reflen, cstate, isin, distclr, ctpos, localclr)
    return
  end if
  clr = 1.d-4
  if (present(localclr)) clr = localclr
  before = cstate%state
  cstate%state = CONTACTFREE
  isin = .false.
  if (present(ctpos)) then
    loc = ctpos
    status = tracked(elemt(:,1), elemt(:,2), elemt(:,3), elemt(:,4), xyz, loc, gap)
  else
    status = unclamped(elemt(:,1), elemt(:,2), elemt(:,3), elemt(:,4), xyz, loc, gap)
  end if
  if (status /= FOOTPOINT_OK) return
  if (maxval(abs(loc)) > 1 + clr) return
  if (footpoint_differentiate(elemt(:,1), elemt(:,2), elemt(:,3), elemt(:,4), xyz, loc, at) /= FOOTPOINT_OK) return
  cstate%distance = -at%gap ! theirs is positive where the point has penetrated
  isin = cstate%distance < distclr*reflen .and. cstate%distance > -0.5d0*reflen
  if (.not. isin) return
  cstate%state = merge(CONTACTSTICK, before, before == CONTACTFREE)
  cstate%gpos = matmul(elemt(1:3,1:4), at%phi)
  cstate%lpos(1:2) = loc
  cstate%direction = at%normal
  cstate%wkdist = cstate%distance
end subroutine
