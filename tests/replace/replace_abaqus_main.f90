! vuinter of runtime/replace/abaqus_vuinter.f90: two slave nodes on a quadrilateral, one on a triangle.
program replace_abaqus
  use replace_points
  implicit none
  integer, parameter :: slaves = 4
  real(rk), parameter :: at(2,3) = reshape((/0.3d0, -0.6d0, -0.5d0, 0.2d0, 1.3d0, 0.d0/), (/2, 3/))
  real(rk) :: stress(3,slaves), node(slaves), pairs(3,slaves), rotation(2,2,slaves), frames(3,3,slaves), &
              weights(4,slaves), x(3,slaves), state(1,slaves), none(1)
  integer :: facet(4,slaves), ids(slaves)
  character(len=80) :: name = 'surface'
  external :: vuinter

  x(:,1) = slave(at(:,1), -0.01d0)
  x(:,2) = slave(at(:,2), 0.02d0)
  x(:,3) = slave(at(:,3), -0.01d0)
  x(:,4) = (face(:,1) + face(:,2) + face(:,3))/3 - (/0.d0, 0.d0, 0.1d0/)
  facet = spread((/1, 2, 3, 4/), 2, slaves)
  facet(4,4) = 0
  stress = 5
  node = 0; pairs = 0; rotation = 0; frames = 0; weights = 0; state = 0; none = 0
  ids = (/1, 2, 3, 4/)
  call vuinter(node, node, node, node, stress, node, node, node, state, 1, 1, 4, slaves, 4, 2, 3, 1, 1, 0, 0, 0, ids, &
               ids, facet, 0.d0, 0.d0, 1d-6, name, name, name, pairs, pairs, rotation, node, node, weights, x, face, &
               frames, (/100.d0/), node, none, none, none, none, none, none, none, none)
  call check('penetrating', abs(stress(1,1) - 1) < 1d-6 .and. all(stress(2:3,1) == 0))
  call check('open', all(stress(:,2) == 0))
  call check('beside', all(stress(:,3) == 0))
  call check('triangle', stress(1,4) > 5 .and. stress(1,4) < 10)
  call finish()
end program
