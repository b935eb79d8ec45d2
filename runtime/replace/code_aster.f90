! Code_Aster: replaces the subroutine mmnewt, which projects a point on a cell of contact. Rename Code_Aster's own to
! mmnewt_newton; it still serves cells other than four-node quadrilaterals.
!  type_elem, nb_node, nb_dim    'QU4     ', 4, 3
!  elem_coor(27), pt_coor(3)     nodes of the cell, node by node; the point
!  iter_maxi, tole_maxi          not used
!  ksi1, ksi2            [out]   local coordinates, not clamped to the cell
!  tang_1, tang_2        [out]   tangents at the projection
!  error                 [out]   0 found, 1 not found
subroutine mmnewt(type_elem, nb_node, nb_dim, elem_coor, pt_coor, iter_maxi, tole_maxi, ksi1, ksi2, tang_1, tang_2, &
                  error, l_reli_)
  use footpoint_unclamped
  implicit none
  character(len=8), intent(in)  :: type_elem
  integer, intent(in)           :: nb_node, nb_dim, iter_maxi
  real(kind=8), intent(in)      :: elem_coor(27), pt_coor(3), tole_maxi
  real(kind=8), intent(out)     :: ksi1, ksi2, tang_1(3), tang_2(3)
  integer, intent(out)          :: error
  logical, intent(in), optional :: l_reli_
  type(footpoint_derivatives)   :: at
  real(kind=8) :: loc(2), gap
  integer      :: status
  interface ! an optional argument takes one
    subroutine mmnewt_newton(type_elem, nb_node, nb_dim, elem_coor, pt_coor, iter_maxi, tole_maxi, ksi1, ksi2, &
                             tang_1, tang_2, error, l_reli_)
      character(len=8), intent(in)  :: type_elem
      integer, intent(in)           :: nb_node, nb_dim, iter_maxi
      real(kind=8), intent(in)      :: elem_coor(27), pt_coor(3), tole_maxi
      real(kind=8), intent(out)     :: ksi1, ksi2, tang_1(3), tang_2(3)
      integer, intent(out)          :: error
      logical, intent(in), optional :: l_reli_
    end subroutine
  end interface

  if (type_elem /= 'QU4' .or. nb_dim /= 3) then
    call mmnewt_newton(type_elem, nb_node, nb_dim, elem_coor, pt_coor, iter_maxi, tole_maxi, ksi1, ksi2, &
                       tang_1, tang_2, error, l_reli_)
    return
  end if
  associate (a => elem_coor(1:3), b => elem_coor(4:6), c => elem_coor(7:9), d => elem_coor(10:12))
    status = unclamped(a, b, c, d, pt_coor, loc, gap)
    if (status == FOOTPOINT_OK) status = footpoint_differentiate(a, b, c, d, pt_coor, loc, at)
  end associate
  error = merge(0, 1, status == FOOTPOINT_OK)
  if (error == 1) return
  ksi1 = loc(1)
  ksi2 = loc(2)
  tang_1 = at%r_xi
  tang_2 = at%r_eta
end subroutine
