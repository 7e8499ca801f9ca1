/**
 * Text that goes in and out: writers of numbers, CSV, JSON and reports, result files, SHA-256, and
 * positions in model files.
 *
 * <p>{@link org.mechservice.solver.text.ShortestDecimal} writes the shortest decimal number that
 * reads back as the same double. All results pass through it, so they have the same bytes on every
 * Java runtime; {@code Double.toString} changed in JDK 19. {@link
 * org.mechservice.solver.text.ResultWriter} is the interface of all file formats; {@link
 * org.mechservice.solver.text.CsvWriter} is the one that travels with models, the others are in the
 * module {@code mechresult}. {@link org.mechservice.solver.text.ResultFile} writes to a temporary
 * file and renames it at the end, so a file of the requested name is always complete.
 *
 * <p>{@link org.mechservice.solver.text.ModelFiles} writes what the files hold that a model names
 * into the text of the model before it travels: {@link org.mechservice.solver.text.TableNumbers}
 * reads CSV, {@link org.mechservice.solver.text.ClosedSurface} STL. {@link
 * org.mechservice.solver.text.Origin} is the file and line that every later message about a part of
 * a mechanism quotes.
 *
 * <p>{@link org.mechservice.solver.text.WellFormedText} makes text of users fit for every encoding,
 * {@link org.mechservice.solver.text.OwnerOnly} files that others must not read, and {@link
 * org.mechservice.solver.text.FileErrors} words of errors of files.
 */
package org.mechservice.solver.text;
