! project_Point2Element of runtime/replace/frontistr.f90, with the little that it needs of FrontISTR's modules.
module hecmw
  implicit none
  integer, parameter :: kreal = kind(1.d0)
end module
module elementInfo
  implicit none
  integer, parameter :: fe_tri3n = 231, fe_quad4n = 241
end module
module mContactDef
  use hecmw
  implicit none
  integer, parameter :: CONTACTFREE = -1, CONTACTSTICK = 1, CONTACTSLIP = 2
  type tContactState
    integer :: state = CONTACTFREE, interference_flag = 0
    real(kind=kreal) :: distance, wkdist, lpos(3), gpos(3), direction(3)
  end type
end module
module m_fstr_contact_newton
  use hecmw
  use mContactDef
  implicit none
  integer :: called = 0
contains
  subroutine project_Point2Element_newton(xyz, etype, nn, elemt, reflen, cstate, isin, distclr, ctpos, localclr)
    real(kind=kreal), intent(in)       :: xyz(3), elemt(:,:), reflen, distclr
    integer, intent(in)                :: etype, nn
    type(tContactState), intent(inout) :: cstate
    logical, intent(out)               :: isin
    real(kind=kreal), optional         :: ctpos(2), localclr
    isin = sum(xyz) + sum(elemt) + reflen + distclr > huge(xyz) .and. etype == nn .and. present(ctpos) &
           .and. present(localclr)
    cstate%state = CONTACTFREE
    called = called + 1
  end subroutine
end module
program replace_frontistr
  use replace_points
  use elementInfo
  use mContactDef
  use m_fstr_contact_newton, only: called
  implicit none
  interface
    subroutine project_Point2Element(xyz, etype, nn, elemt, reflen, cstate, isin, distclr, ctpos, localclr)
      use mContactDef
      real(kind=kreal), intent(in)       :: xyz(3), elemt(:,:), reflen, distclr
      integer, intent(in)                :: etype, nn
      type(tContactState), intent(inout) :: cstate
      logical, intent(out)               :: isin
      real(kind=kreal), optional         :: ctpos(2), localclr
    end subroutine
  end interface
  real(rk), parameter :: loc(2) = (/0.3d0, -0.6d0/)
  real(rk) :: u(3), v(3), n(3)
  type(tContactState) :: c
  logical :: isin

  call frame(loc, u, v, n)
  call project_Point2Element(slave(loc, -0.05d0), fe_quad4n, 4, face, 1.d0, c, isin, 0.1d0)
  call check('penetrating', isin .and. c%state == CONTACTSTICK .and. abs(c%distance - 0.05d0) < 1d-9)
  call check('place', maxval(abs(c%lpos(1:2) - loc)) < 1d-9 .and. norm2(c%gpos - slave(loc, 0.d0)) < 1d-9)
  call check('normal', norm2(c%direction - n) < 1d-8)
  call project_Point2Element(slave(loc, -0.05d0), fe_quad4n, 4, face, 1.d0, c, isin, 0.1d0, loc + 0.05d0)
  call check('from the position before', isin .and. maxval(abs(c%lpos(1:2) - loc)) < 1d-9)
  c%state = CONTACTSLIP
  call project_Point2Element(slave(loc, -0.05d0), fe_quad4n, 4, face, 1.d0, c, isin, 0.1d0, loc, 1d-3)
  call check('state of before', isin .and. c%state == CONTACTSLIP)
  call project_Point2Element(slave(loc, -0.2d0), fe_quad4n, 4, face, 1.d0, c, isin, 0.1d0)
  call check('too deep', .not. isin .and. c%state == CONTACTFREE)
  call project_Point2Element(slave((/1.2d0, 0.d0/), -0.05d0), fe_quad4n, 4, face, 1.d0, c, isin, 0.1d0)
  call check('beside', .not. isin)
  call project_Point2Element(slave(loc, -0.05d0), fe_tri3n, 3, face(:,1:3), 1.d0, c, isin, 0.1d0)
  call check('other elements', called == 1)
  call finish()
end program
