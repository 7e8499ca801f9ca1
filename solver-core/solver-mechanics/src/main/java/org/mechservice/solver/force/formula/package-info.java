/**
 * Forces whose size is a formula of the model file.
 *
 * <p>A formula reads the time, coordinates and velocities of joints, positions and velocities of
 * points, and angles. Each kind of quantity is an {@code Input} class, which gives the value and
 * the gradient by the joint coordinates ({@link org.mechservice.solver.force.formula.LeafInput});
 * {@link org.mechservice.solver.force.formula.ExpressionInputs} collects the inputs that one set of
 * formulas needs, each evaluated once per state.
 *
 * <p>{@link org.mechservice.solver.force.formula.ExpressionWrench} and {@link
 * org.mechservice.solver.force.formula.ExpressionJointForce} apply the values. {@link
 * org.mechservice.solver.force.formula.FormulaCheck} and {@link
 * org.mechservice.solver.force.formula.SampleStates} find the formula behind a failed run: they
 * evaluate its subexpressions near the last states and report the one without a finite value, or
 * with a jump.
 */
package org.mechservice.solver.force.formula;
