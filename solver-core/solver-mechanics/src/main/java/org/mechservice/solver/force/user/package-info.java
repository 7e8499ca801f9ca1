/**
 * Forces that a user gives as a class.
 *
 * <p>A {@link org.mechservice.solver.api.UserForce} declares which bodies, points and joints it
 * reads and loads. {@link org.mechservice.solver.force.user.UserForceReading} and {@link
 * org.mechservice.solver.force.user.UserForceSensor} give it the declared quantities of a state,
 * and {@link org.mechservice.solver.force.user.AppliedUserForce} applies what it answers and takes
 * its derivatives by differences where the class gives none. Names that do not exist are refused
 * before the run.
 *
 * <p>{@link org.mechservice.solver.force.user.UserForceSource} makes the instances; it differs
 * between a run in the server's worker, a downloaded model and a standalone JAR.
 */
package org.mechservice.solver.force.user;
