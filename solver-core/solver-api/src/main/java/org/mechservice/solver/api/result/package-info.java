/**
 * The rows of a run: groups of columns, their names and units, and receivers of rows.
 *
 * <p>Users request columns by {@link ColumnGroup}: joints, accelerations, bodies, energy, and so
 * on. A model describes each of its columns by a {@link Variable}, with name and unit. {@link
 * ResultColumns} computes the columns of a model that go beyond its state. A {@link ResultSink}
 * receives the rows one after the other; it writes them to a file, sends them to a client, or
 * stores them.
 *
 * <p>The package depends on {@code solver.api.capability} only for the balance of momentum.
 */
package org.mechservice.solver.api.result;
