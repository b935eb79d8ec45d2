! Abaqus/Explicit: replaces VUINTER. Computes the traction between a slave node and its master facet as a penalty on the
! gap to the bilinear facet: stress(1,i) = props(1) times the penetration, without friction. UINTER (Abaqus/Standard)
! receives no master nodes, so there is nothing to search.
!  jConMstid(nFacNod,nSlvNod)    the facet of each slave node, as positions in coordMst; three-node facets
!                                repeat the third node, or have a zero
! Declared in double, for Abaqus/Explicit with double=both.
subroutine vuinter(sfd, scd, spd, svd, stress, fluxSlv, fluxMst, sed, statev, kStep, kInc, nFacNod, nSlvNod, nMstNod, &
                   nSurfDir, nDir, nStateVar, nProps, nTemp, nPred, numDefTfv, jSlvUid, jMstUid, jConMstid, timStep, &
                   timGlb, dTimCur, surfInt, surfSlv, surfMst, rdisp, drdisp, drot, stiffDflt, condDflt, shape, &
                   coordSlv, coordMst, alocaldir, props, areaSlv, tempSlv, dtempSlv, preDefSlv, dpreDefSlv, tempMst, &
                   dtempMst, preDefMst, dpreDefMst)
  use footpoint
  implicit none
  integer, parameter :: rk = kind(1.d0)
  integer, intent(in) :: kStep, kInc, nFacNod, nSlvNod, nMstNod, nSurfDir, nDir, nStateVar, nProps, nTemp, nPred, &
                         numDefTfv
  integer, intent(in) :: jSlvUid(nSlvNod), jMstUid(nMstNod), jConMstid(nFacNod,nSlvNod)
  character(len=80), intent(in) :: surfInt, surfSlv, surfMst
  real(rk), intent(inout) :: sfd(nSlvNod), scd(nSlvNod), spd(nSlvNod), svd(nSlvNod), stress(nDir,nSlvNod), &
                             fluxSlv(nSlvNod), fluxMst(nSlvNod), sed(nSlvNod), statev(nStateVar,nSlvNod)
  real(rk), intent(in) :: timStep, timGlb, dTimCur, rdisp(nDir,nSlvNod), drdisp(nDir,nSlvNod), drot(2,2,nSlvNod), &
                          stiffDflt(nSlvNod), condDflt(nSlvNod), shape(nFacNod,nSlvNod), coordSlv(nDir,nSlvNod), &
                          coordMst(nDir,nMstNod), alocaldir(nDir,nDir,nSlvNod), props(nProps), areaSlv(nSlvNod), &
                          tempSlv(*), dtempSlv(*), preDefSlv(*), dpreDefSlv(*), tempMst(*), dtempMst(*), preDefMst(*), &
                          dpreDefMst(*)
  integer  :: i, f(4), status
  real(rk) :: loc(2), gap

  do i = 1, nSlvNod
    f = jConMstid((/1, 2, 3, min(4, nFacNod)/), i)
    if (f(4) == 0) f(4) = f(3)
    status = footpoint_robust(coordMst(:,f(1)), coordMst(:,f(2)), coordMst(:,f(3)), coordMst(:,f(4)), coordSlv(:,i), &
                              loc, gap)
    stress(:,i) = 0
    if (status == FOOTPOINT_OK .and. gap < 0) stress(1,i) = -props(1)*gap ! compression is positive
  end do
end subroutine
