/**
 * {@code mech optimise} and {@code mech identify}: parameters for which a model does best, or
 * agrees best with measurements; and {@code mech gradient}, derivatives of results by parameters.
 *
 * <p>{@link org.mechservice.cli.optimise.VariableOptions} reads which parameters may be changed
 * between which bounds, in both commands; {@link org.mechservice.cli.optimise.OptimiseCommand} and
 * {@link org.mechservice.cli.optimise.IdentifyCommand} have {@code org.mechservice.study} do the
 * work and print the answer as text or JSON.
 *
 * <p>Their reports are pages with pictures: {@link org.mechservice.cli.optimise.OptimumPage} has
 * the optimum in tables and the way to it in pictures, {@link org.mechservice.cli.optimise.FitPage}
 * the parameters with their intervals and correlations, the fit and what is left of the
 * measurements. {@link org.mechservice.cli.optimise.GradientCommand} prints a table and no page.
 */
@NullMarked
package org.mechservice.cli.optimise;

import org.jspecify.annotations.NullMarked;
