package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.text.Origin;

/**
 * A coupling of joint coordinates, such as a gear or a rack (MECHML §5, CoordConstraint): the
 * expression is zero. It may contain time, parameters and positions of coordinates, of tree joints
 * and of cut ones, but no velocities.
 *
 * @param name name in the model file
 * @param relation expression that is zero during the motion; coordinates in SI units
 * @param origin position in the model file
 */
public record CoordinateClosure(String name, Expression relation, Origin origin)
    implements LoopClosure {}
