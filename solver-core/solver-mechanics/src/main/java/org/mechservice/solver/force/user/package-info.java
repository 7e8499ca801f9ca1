/**
 * Forces that a user writes as Java classes.
 *
 * <p>A {@link org.mechservice.solver.api.UserForce} declares the points and joints that it reads
 * and on which it acts. {@link org.mechservice.solver.force.user.UserForceReading} and {@link
 * org.mechservice.solver.force.user.UserForceSensor} give it the declared quantities of a state.
 * {@link org.mechservice.solver.force.user.AppliedUserForce} applies its loads, and takes
 * derivatives by central differences if the class has none. Names that do not exist are rejected
 * before the run.
 *
 * <p>{@link org.mechservice.solver.force.user.UserForceSource} creates the instances; a server's
 * worker process, a downloaded model and a standalone JAR each have their own source.
 */
package org.mechservice.solver.force.user;
