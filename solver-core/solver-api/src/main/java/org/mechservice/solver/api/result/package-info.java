/**
 * The rows of a run: which columns there are, and who takes them.
 *
 * <p>A {@link ColumnGroup} is what a user asks for by name: joints, accelerations, bodies, energy,
 * and so on. A model describes each of its columns by a {@link Variable}, with name and unit.
 * {@link ResultColumns} computes the columns of a model that go beyond its state. A {@link
 * ResultSink} takes the rows one after the other; it writes them to a file, sends them to a client,
 * or keeps them.
 *
 * <p>The package depends on {@code solver.api.capability} for the balance of momentum alone.
 */
package org.mechservice.solver.api.result;
