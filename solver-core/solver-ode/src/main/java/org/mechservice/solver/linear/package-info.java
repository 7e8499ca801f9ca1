/**
 * Systems of linear equations A x = b, solved by factors that are formed once and used for many
 * right-hand sides. Nothing here allocates memory after construction, but for sparse factors that
 * turn out to need more room.
 *
 * <table>
 * <caption>Which solver for which matrix</caption>
 * <tr><th>class</th><th>matrix</th><th>factors</th><th>solution</th></tr>
 * <tr><td>{@link org.mechservice.solver.linear.DenseLu}</td><td>n × n, no structure used</td>
 * <td>⅔ n³ operations</td><td>2 n²</td></tr>
 * <tr><td>{@link org.mechservice.solver.linear.BandLu}</td><td>l diagonals below, u above the main
 * one</td><td>2 n l (l + u)</td><td>2 n (2l + u)</td></tr>
 * <tr><td>{@link org.mechservice.solver.linear.BlockLu}</td><td>blocks of m rows on the
 * diagonal</td><td>⅔ n m²</td><td>2 n m</td></tr>
 * <tr><td>{@link org.mechservice.solver.linear.SparsePivotedLu}</td><td>a fixed pattern</td>
 * <td>some 10 n √n for neighbours in a plane</td><td>some 10 n log n</td></tr>
 * </table>
 *
 * <p>{@link org.mechservice.solver.linear.Cholesky} factors dense symmetric positive definite
 * matrices; {@link org.mechservice.solver.linear.PivotedElimination} chooses rows and columns of a
 * rectangular one that determine the others; {@link
 * org.mechservice.solver.linear.spectrum.SingularValues} tells how many there are, and solves when
 * there are fewer than equations or unknowns.
 *
 * <p>A {@link org.mechservice.solver.linear.SparseMatrix} holds the elements of a fixed pattern.
 * {@link org.mechservice.solver.linear.SparseElimination} chooses pivots of it for size and for few
 * new elements, {@link org.mechservice.solver.linear.SparseLu} forms the factors of what was chosen
 * again and again, and {@link org.mechservice.solver.linear.SparseSymmetric} factors symmetric
 * matrices summed up from small parts, in an order of least degree. The first allocates. Sparse
 * symmetric matrices that need not be definite are factored by {@link
 * org.mechservice.solver.linear.front.SymmetricFronts}, which counts their negative eigenvalues and
 * allocates its factors each time.
 *
 * <p>{@link org.mechservice.solver.linear.EquilibratedSolver} brings the rows to like size before
 * any of them factors, so that the units of the equations do not decide about the pivots.
 *
 * <p>A solver says where in a flat array it wants each element, by its {@link
 * org.mechservice.solver.linear.MatrixLayout}; whoever fills the matrix need not know more of it.
 * All work by Gaussian elimination with row interchanges (Golub and Van Loan, <i>Matrix
 * Computations</i>, 2013, ch. 3 and 4): a pivot that is exactly zero is reported with its column,
 * and how many digits the equations may cost is told by {@link
 * org.mechservice.solver.linear.LinearSolver#reciprocalCondition}.
 */
package org.mechservice.solver.linear;
