package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Origin;

/**
 * A relation between joint coordinates, such as a gear's or a rack's (MECHML §5, CoordConstraint):
 * the expression is zero. It may contain time, parameters and positions of coordinates, of tree
 * joints and of cut ones, but no velocities.
 *
 * @param name name in the model file
 * @param relation vanishes during the motion; SI units of the coordinates in it
 * @param origin where it was written down
 */
public record CoordinateClosure(String name, Expression relation, Origin origin)
    implements LoopClosure {}
