/**
 * Spectra of small dense matrices: eigenvalues and singular values.
 *
 * <p>{@link org.mechservice.solver.linear.spectrum.Eigenvalues} scales a matrix, turns it to
 * Hessenberg form and iterates that to the complex Schur form, whose diagonal has the eigenvalues;
 * the eigenvectors follow by back substitution. Modes of a linearised mechanism, transmission zeros
 * and the spectra of reports are computed with it. It allocates and is not for a hot loop.
 *
 * <p>{@link org.mechservice.solver.linear.spectrum.SingularValues} are found by Jacobi rotations,
 * in a workspace that is used again. They say how many equations of a loop are independent, and
 * solve systems that have fewer independent equations than unknowns.
 *
 * <p>The package does not depend on {@code linear}, whose factors serve the steps of a run. Source:
 * Golub and Van Loan, <i>Matrix Computations</i>, 2013, ch. 7 and 8.
 */
package org.mechservice.solver.linear.spectrum;
