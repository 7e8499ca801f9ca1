/**
 * The rows of a run: groups of columns, their names and units, and receivers of rows.
 *
 * <p>Users request columns by {@link ColumnGroup}: joints, accelerations, bodies, energy, and so
 * on. A model describes each of its columns by a {@link Variable}, with name and unit; {@code
 * capability.ResultColumns} computes those that go beyond its state. A {@link ResultSink} receives
 * the rows one after the other; it writes them to a file, sends them to a client, or stores them.
 *
 * <p>The package depends on no other of {@code solver.api}: {@code run} stands on it, {@code
 * solver.api} on both, and {@code capability} on all three.
 */
package org.mechservice.solver.api.result;
